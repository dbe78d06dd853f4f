// SPDX-License-Identifier: MIT
#include "core/json_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/console.hpp"

namespace raytorus {

std::string dumpJson(const nlohmann::ordered_json& json, int indent) {
    const auto dump = [](const nlohmann::ordered_json& value, int width, bool ascii) {
        return value.dump(width, ' ', ascii, nlohmann::ordered_json::error_handler_t::replace);
    };
    // Outside of strings there is nothing to hide. Beyond U+FFFF an escape is a pair, which the library
    // knows.
    return replaceHidden(dump(json, indent, false), [&dump](std::string_view bytes) {
        const std::string quoted = dump(bytes, -1, true);
        return quoted.substr(1, quoted.size() - 2);
    });
}

}  // namespace raytorus
