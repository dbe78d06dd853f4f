// SPDX-License-Identifier: MIT
// What happens in the window, as a line of JSON each on standard output: for programs that drive it.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace raytorus::viewer {

class EventLog {
public:
    using Value = std::variant<bool, long long, double, std::string, std::vector<double>>;
    using Field = std::pair<std::string_view, Value>;

    /// Silent unless enabled.
    explicit EventLog(bool enabled) : on(enabled) {}

    /// {"event": "<name>", ...}, written at once.
    void write(std::string_view name, std::initializer_list<Field> fields = {}) const;

private:
    bool on;
};

}  // namespace raytorus::viewer
