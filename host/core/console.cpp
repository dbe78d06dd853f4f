// SPDX-License-Identifier: MIT
#include "core/console.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>

#include "core/error.hpp"
#include "core/file.hpp"

namespace raytorus {
namespace {

struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;  // 0: what begins here is no UTF-8
};

// The first character of a text that is not empty.
Character firstOf(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    if (lead < 0x80U) {
        return {lead, 1};
    }
    const std::size_t length = lead >= 0xF0U ? 4 : (lead >= 0xE0U ? 3 : 2);
    if (lead < 0xC2U || lead > 0xF4U || text.size() < length) {
        return {};
    }
    std::uint32_t code = lead & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return {};
        }
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    constexpr std::array<std::uint32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800U && code <= 0xDFFFU;
    return code < least[length] || surrogate || code > 0x10FFFFU ? Character() : Character{code, length};
}

bool isShown(std::uint32_t code) {
    const bool control = code < 0x20U || (code >= 0x7FU && code <= 0x9FU);
    const bool turns = (code >= 0x202AU && code <= 0x202EU) || (code >= 0x2066U && code <= 0x2069U) ||
                       code == 0x200EU || code == 0x200FU || code == 0x061CU;
    const bool breaksLine = code == 0x2028U || code == 0x2029U;
    const bool noncharacter = (code & 0xFFFEU) == 0xFFFEU || (code >= 0xFDD0U && code <= 0xFDEFU);
    return !control && !turns && !breaksLine && !noncharacter && code != 0xFEFFU;
}

std::string escaped(std::string_view bytes) {
    const Character character = firstOf(bytes);
    if (character.bytes == 0) {
        return fmt::format("\\x{:02x}", static_cast<unsigned char>(bytes.front()));
    }
    return character.code > 0xFFFFU ? fmt::format("\\U{:08x}", character.code)
                                    : fmt::format("\\u{:04x}", character.code);
}

// Up to `most` bytes; lines stay lines unless they are to be one.
std::string shown(std::string_view text, std::size_t most, bool oneLine, const Replacement& instead) {
    std::string result;
    while (!text.empty()) {
        const Character character = firstOf(text);
        const std::size_t bytes = character.bytes > 0 ? character.bytes : 1;
        const bool layout = !oneLine && (text.front() == '\n' || text.front() == '\t');
        std::string part(text.substr(0, bytes));
        if (character.bytes == 0 || (!layout && !isShown(character.code))) {
            part = instead(part);
        }
        if (result.size() + part.size() > most) {
            return result + "...";
        }
        result += part;
        text.remove_prefix(bytes);
    }
    return result;
}

void requireOutput(bool written) {
    if (!written) {
        const int code = errno;
        throw Error(ExitCode::File, fmt::format("cannot write to standard output: {}", systemReason(code)));
    }
}

}  // namespace

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const Character character = firstOf(text);
        if (character.bytes == 0) {
            return false;
        }
        text.remove_prefix(character.bytes);
    }
    return true;
}

std::string replaceHidden(std::string_view text, const Replacement& instead) {
    return shown(text, std::string::npos, false, instead);
}

std::string printable(std::string_view text) {
    return replaceHidden(text, escaped);
}

std::string excerpt(std::string_view text, std::size_t most) {
    return shown(text, most, true, escaped);
}

void writeOutput(std::string_view text) {
    const std::string clean = printable(text);
    errno = 0;
    requireOutput(std::fwrite(clean.data(), 1, clean.size(), stdout) == clean.size());
}

void flushOutput() {
    errno = 0;
    requireOutput(std::fflush(stdout) == 0 && std::ferror(stdout) == 0);
}

void writeError(std::string_view text) noexcept {
    try {
        const std::string clean = printable(text);
        static_cast<void>(std::fwrite(clean.data(), 1, clean.size(), stderr));
    } catch (...) {  // no memory for words
        static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
    }
}

}  // namespace raytorus
