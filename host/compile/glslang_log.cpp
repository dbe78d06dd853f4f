// SPDX-License-Identifier: MIT
#include "compile/glslang_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "core/parse_number.hpp"

namespace raytorus::compile {
namespace {

// "@3" in "ERROR: @3:12: 'x' : undeclared identifier".
constexpr char sourceMark = '@';
// "@3@" in "ERROR: @0:1: '#include' : @3@ for header name: x.glsl".
constexpr std::string_view includeStart = "'#include' : @";

// Without spaces at the ends and with one between words. Bytes that may be no text show themselves as
// numbers.
std::string tidy(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isgraph(byte) != 0) {
            result += c;
        } else if (std::isspace(byte) == 0) {
            result += fmt::format("\\x{:02x}", byte);
        } else if (!result.empty() && result.back() != ' ') {
            result += ' ';
        }
    }
    while (!result.empty() && (result.back() == ' ' || result.back() == '.')) {
        result.pop_back();
    }
    return result;
}

bool skip(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) {
        return false;
    }
    text.remove_prefix(prefix.size());
    return true;
}

// Takes "name:line: " from the front.
std::optional<CompileError> takeLocation(std::string_view& message) {
    for (std::size_t colon = message.find(':'); colon != std::string_view::npos;
         colon = message.find(':', colon + 1)) {
        const std::size_t end = message.find(": ", colon + 1);
        if (end == std::string_view::npos) {
            break;
        }
        if (const auto line = parseNumber<int>(message.substr(colon + 1, end - colon - 1))) {
            CompileError error{std::string(message.substr(0, colon)), *line, {}};
            message.remove_prefix(end + 2);
            return error;
        }
    }
    return std::nullopt;
}

class LogReader {
public:
    LogReader(const IncludeSearch& where, const std::vector<std::string>& sentences)
        : search(where), refusals(sentences) {}

    CompileError errorIn(std::string_view message) const {
        CompileError error{search.sources().front().name, 0, {}};
        if (auto located = takeLocation(message)) {
            error = std::move(*located);
            error.file = fileNamed(error.file);
        } else if (message.starts_with("#version") || message.starts_with("version not supported")) {
            error.line = versionLine();
        }
        skip(message, "'' :");
        if (message.starts_with("Linking ")) {
            message.remove_prefix(std::min(message.size(), message.find(": ") + 2));
        }
        error.text = tidy(message);
        if (error.text == "missing #endif") {
            placeMissingEndif(error);
        } else if (const std::string* sentence = refusalIn(message)) {
            error.text = *sentence;
        } else if (error.text.starts_with("'#include' : ")) {
            placeMissingQuote(error);
        }
        return error;
    }

private:
    std::string fileNamed(const std::string& name) const {
        const bool marked = name.starts_with(sourceMark);
        const auto id = marked ? parseNumber<std::size_t>(std::string_view(name).substr(1)) : std::nullopt;
        if (id && *id < search.sources().size()) {
            return search.sources()[*id].name;
        }
        return name == "-1" ? "the given macros" : name;  // glslang's number for what goes before the entry
    }

    int versionLine() const {
        for (const Directive& directive : search.sources().front().directives) {
            if (directive.keyword == "version") {
                return directive.line;
            }
        }
        return 1;
    }

    void placeMissingEndif(CompileError& error) const {
        for (const Source& source : search.sources()) {
            if (const auto open = unclosedConditional(source.directives)) {
                error = {source.name, open->line, fmt::format("'#{}' : missing #endif", open->keyword)};
                return;
            }
        }
    }

    // glslang reads on to the next quotation mark, lines below.
    void placeMissingQuote(CompileError& error) const {
        for (const Source& source : search.sources()) {
            for (const Directive& directive : source.directives) {
                if (source.name == error.file && directive.line <= error.line &&
                    directive.keyword == "include" &&
                    std::count(directive.rest.begin(), directive.rest.end(), '"') == 1) {
                    error.line = directive.line;
                    error.text = "'#include' : missing closing quotation mark";
                    return;
                }
            }
        }
    }

    const std::string* refusalIn(std::string_view message) const {
        if (!skip(message, includeStart)) {
            return nullptr;
        }
        const auto number = parseNumber<std::size_t>(message.substr(0, message.find('@')));
        return number && *number < refusals.size() ? &refusals[*number] : nullptr;
    }

    const IncludeSearch& search;
    const std::vector<std::string>& refusals;
};

// What says only that there were errors.
bool isNoise(const CompileError& error) {
    return error.text == "compilation terminated" || error.text.ends_with("No code generated");
}

}  // namespace

std::string logName(std::size_t sourceId) {
    return fmt::format("{}{}", sourceMark, sourceId);
}

std::string logRefusal(std::size_t refusal) {
    return fmt::format("@{}@", refusal);
}

std::vector<CompileError> readLog(std::string_view log, const IncludeSearch& search,
                                  const std::vector<std::string>& refusals) {
    const LogReader reader(search, refusals);
    std::vector<CompileError> errors;
    bool inError = false;
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size() - 1);
        std::string_view line = log.substr(0, end + 1);
        log.remove_prefix(end + 1);
        if (skip(line, "ERROR: ") || skip(line, "INTERNAL ERROR: ") || skip(line, "UNIMPLEMENTED: ")) {
            errors.push_back(reader.errorIn(line));
            inError = !isNoise(errors.back());
            if (!inError) {
                errors.pop_back();
            }
        } else if (inError && line.starts_with("    ")) {  // the details of an error in linking
            errors.back().text = tidy(errors.back().text + std::string(line));
        } else {
            inError = false;  // a warning, or the rest of a text with line ends in it
        }
    }
    return errors;
}

}  // namespace raytorus::compile
