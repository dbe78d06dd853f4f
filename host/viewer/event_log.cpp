// SPDX-License-Identifier: MIT
#include "viewer/event_log.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/console.hpp"
#include "core/json_text.hpp"

namespace raytorus::viewer {

void EventLog::write(std::string_view name, std::initializer_list<Field> fields) const {
    if (!on) {
        return;
    }
    nlohmann::ordered_json line;
    line["event"] = name;
    for (const auto& [key, value] : fields) {
        std::visit([&line, name = std::string(key)](const auto& item) { line[name] = item; }, value);
    }
    print("{}\n", dumpJson(line, -1));
    flushOutput();
}

}  // namespace raytorus::viewer
