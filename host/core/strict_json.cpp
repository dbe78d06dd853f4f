// SPDX-License-Identifier: MIT
// The handler of nlohmann's SAX parser that builds the tree. The tree's depth is bounded here, because the
// library destroys and prints values recursively.
#include "core/strict_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace raytorus {
namespace {

/// Scenes need 5. Deeper than that can only be an error, deeper than this could hurt.
constexpr std::size_t maxDepth = 64;

/// What a message quotes of a value at most.
constexpr std::size_t maxQuoted = 60;

/// An error of the library is "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error
/// while parsing value - unexpected ']'; last read: '...'; expected ...". Ours names the place itself, and
/// quotes nothing, since what was read last may be long or not even text.
std::string essence(std::string message) {
    for (const std::string_view end : {"syntax error ", "column ", "] "}) {
        const std::size_t found = message.find(end);
        if (found != std::string::npos) {
            message.erase(0, found + end.size());
            break;
        }
    }
    const std::size_t quote = message.find("; last read: '");
    if (quote != std::string::npos) {
        const std::size_t expected = message.rfind("'; expected ");
        const std::size_t end = expected == std::string::npos ? message.size() : expected + 1;
        message.erase(quote, end - quote);
    }
    return message;
}

/// Of the character that was read last; the parser counts characters from 1.
std::string lineAndColumn(std::string_view text, std::size_t position) {
    const std::string_view before =
        text.substr(0, std::min(position - std::min<std::size_t>(position, 1), text.size()));
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t lastBreak = before.rfind('\n');
    const std::size_t column =
        lastBreak == std::string_view::npos ? before.size() : before.size() - lastBreak - 1;
    return fmt::format("line {}, column {}", line, column + 1);
}

/// What nlohmann::Json::sax_parse asks of its handler: each call returns whether to go on.
class TreeBuilder {
public:
    TreeBuilder(std::string_view text, std::string_view sourceName) : text_(text), sourceName_(sourceName) {}

    Json take() { return std::move(root_); }

    bool null() { return add(nullptr); }
    bool boolean(bool value) { return add(value); }
    bool number_integer(Json::number_integer_t value) { return add(value); }
    bool number_unsigned(Json::number_unsigned_t value) { return add(value); }
    bool string(std::string& value) { return add(std::move(value)); }
    bool binary(Json::binary_t& /*value*/) { return false; }  // not in text

    bool number_float(double value, const std::string& text) {
        if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max())) {
            failTooLarge(text);
        }
        return add(value);
    }

    bool start_object(std::size_t /*unknown*/) { return open(Json::object()); }
    bool start_array(std::size_t /*unknown*/) { return open(Json::array()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(std::string& name) {
        Level& level = levels_.back();
        level.key = std::move(name);
        if (!level.keys.insert(level.key).second) {
            failAt(sourceName_, pointer(), "the key is given twice");
        }
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::detail::exception& error) {
        constexpr int numberOverflow = 406;
        if (error.id == numberOverflow) {
            failTooLarge(token);
        }
        failAt(sourceName_, "",
               fmt::format("{}: not JSON: {}", lineAndColumn(text_, position), essence(error.what())));
    }

private:
    /// An object or array that is not closed yet.
    struct Level {
        Json value;
        std::string key = {};                       ///< objects: of the member to come
        std::unordered_set<std::string> keys = {};  ///< objects: seen so far
    };

    [[noreturn]] void failTooLarge(const std::string& number) const {
        const bool isLong = number.size() > maxQuoted;
        failAt(sourceName_, pointer(),
               fmt::format("{}{} is beyond the range of float32 (3.4e38)", number.substr(0, maxQuoted),
                           isLong ? "..." : ""));
    }

    /// Of the value that is being read.
    [[nodiscard]] std::string pointer() const {
        std::string result;
        for (const Level& level : levels_) {
            result +=
                level.value.is_object() ? pointerPart(level.key) : fmt::format("/{}", level.value.size());
        }
        return result;
    }

    bool add(Json&& value) {
        if (levels_.empty()) {
            root_ = std::move(value);
        } else if (Level& level = levels_.back(); level.value.is_object()) {
            // Not emplace(), which looks for the key among all others: that is quadratic.
            level.value.get_ref<Json::object_t&>().push_back({std::move(level.key), std::move(value)});
        } else {
            level.value.get_ref<Json::array_t&>().push_back(std::move(value));
        }
        return true;
    }

    bool open(Json&& value) {
        if (levels_.size() >= maxDepth) {
            failAt(sourceName_, pointer(), fmt::format("nested more than {} levels deep", maxDepth));
        }
        levels_.push_back({std::move(value)});
        return true;
    }

    bool close() {
        Json value = std::move(levels_.back().value);
        levels_.pop_back();
        return add(std::move(value));
    }

    std::string_view text_;
    std::string_view sourceName_;
    std::vector<Level> levels_;
    Json root_;
};

}  // namespace

std::string pointerPart(std::string_view key) {
    std::string part = "/";
    for (const char c : key) {
        if (c == '~') {
            part += "~0";
        } else if (c == '/') {
            part += "~1";
        } else if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') {
            // Not in RFC 6901, but a control character would end or colour the message.
            part += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            part += c;
        }
    }
    return part;
}

std::string describe(const Json& value) {
    if (value.is_object()) {
        return "an object";
    }
    constexpr std::size_t longestVector = 4;
    if (value.is_array() && value.size() > longestVector) {
        return fmt::format("an array of {}", value.size());
    }
    const std::string text = value.dump();
    if (text.size() <= maxQuoted) {
        return text;
    }
    return value.is_array() ? fmt::format("an array of {}", value.size()) : "a long string";
}

void failAt(std::string_view sourceName, const std::string& pointer, const std::string& fault) {
    throw Error(ExitCode::Scene, pointer.empty() ? fmt::format("{}: {}", sourceName, fault)
                                                 : fmt::format("{}: {}: {}", sourceName, pointer, fault));
}

Json parseStrictJson(std::string_view text, std::string_view sourceName) {
    TreeBuilder builder(text, sourceName);
    Json::sax_parse(text, &builder);
    return builder.take();
}

}  // namespace raytorus
