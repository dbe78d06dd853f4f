// SPDX-License-Identifier: MIT
#include "compile/directives.hpp"

#include <algorithm>
#include <cctype>

namespace raytorus::compile {
namespace {

bool isSpace(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool isNameCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isSpace(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && isSpace(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

// Lines as the preprocessor has them: joined where a backslash ends one, with a space for each comment.
class LogicalLines {
public:
    explicit LogicalLines(std::string_view source) : text(source) {}

    // False at the end of the text. `first` is the number of the line on which its first word stands.
    bool next(std::string& line, int& first) {
        line.clear();
        first = number;
        bool begun = false;
        if (at == text.size()) {
            return false;
        }
        while (at < text.size()) {
            if (skip("\\\n") || skip("\\\r\n")) {
                ++number;
            } else if (skip("//")) {
                skipLineComment();
            } else if (skip("/*")) {
                skipBlockComment();
                line += ' ';
            } else if (skip("\n")) {
                ++number;
                return true;
            } else {
                if (!begun && !isSpace(text[at])) {
                    begun = true;
                    first = number;
                }
                line += text[at++];
            }
        }
        return true;
    }

private:
    bool skip(std::string_view what) {
        if (!text.substr(at).starts_with(what)) {
            return false;
        }
        at += what.size();
        return true;
    }

    void skipLineComment() {
        while (at < text.size() && text[at] != '\n') {
            if (skip("\\\n") || skip("\\\r\n")) {
                ++number;
            } else {
                ++at;
            }
        }
    }

    void skipBlockComment() {
        while (at < text.size() && !skip("*/")) {
            number += text[at++] == '\n' ? 1 : 0;
        }
    }

    std::string_view text;
    std::size_t at = 0;
    int number = 1;
};

bool opens(const Directive& directive) {
    return directive.keyword == "if" || directive.keyword == "ifdef" || directive.keyword == "ifndef";
}

// The name that must not be defined yet for the file to say anything; empty if there is none.
std::string guardedName(const Directive& directive) {
    std::string_view name = directive.rest;
    if (directive.keyword == "if") {
        std::string compact;
        std::copy_if(name.begin(), name.end(), std::back_inserter(compact),
                     [](char c) { return !isSpace(c); });
        constexpr std::string_view test = "!defined";
        if (!compact.starts_with(test)) {
            return {};
        }
        compact.erase(0, test.size());
        if (compact.starts_with('(') && compact.ends_with(')')) {
            compact = compact.substr(1, compact.size() - 2);
        }
        return std::all_of(compact.begin(), compact.end(), isNameCharacter) ? compact : std::string();
    }
    return directive.keyword == "ifndef" ? std::string(name) : std::string();
}

}  // namespace

std::vector<Directive> findDirectives(std::string_view text) {
    std::vector<Directive> found;
    LogicalLines lines(text);
    std::string line;
    for (int number = 1; lines.next(line, number);) {
        std::string_view rest = trimmed(line);
        if (!rest.starts_with('#')) {
            continue;
        }
        rest = trimmed(rest.substr(1));
        const auto end = std::find_if_not(rest.begin(), rest.end(), isNameCharacter);
        const std::string_view keyword(rest.begin(), end);
        found.push_back({number, std::string(keyword), std::string(trimmed(rest.substr(keyword.size())))});
    }
    return found;
}

std::optional<Directive> unclosedConditional(const std::vector<Directive>& directives) {
    std::vector<Directive> open;
    for (const Directive& directive : directives) {
        if (opens(directive)) {
            open.push_back(directive);
        } else if (directive.keyword == "endif" && !open.empty()) {
            open.pop_back();
        }
    }
    return open.empty() ? std::nullopt : std::optional(open.back());
}

bool hasIncludeGuard(const std::vector<Directive>& directives) {
    if (directives.size() < 3) {
        return false;
    }
    const std::string name = guardedName(directives[0]);
    const std::string_view defined = directives[1].rest;
    if (name.empty() || directives[1].keyword != "define" || defined.substr(0, defined.find(' ')) != name) {
        return false;
    }
    int depth = 0;
    for (const Directive& directive : directives) {
        depth += opens(directive) ? 1 : 0;
        depth -= directive.keyword == "endif" ? 1 : 0;
        if (depth == 0) {
            return &directive == &directives.back();
        }
    }
    return false;  // never closed: not a guard but an error
}

}  // namespace raytorus::compile
