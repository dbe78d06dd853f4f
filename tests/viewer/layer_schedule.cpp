// SPDX-License-Identifier: MIT
#include "layer_schedule.hpp"

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <utility>

namespace raytorus::test {
namespace {

[[noreturn]] void refuse(std::string_view fault) {
    std::fprintf(stderr, "the fault layer cannot read \"%.*s\"\n", static_cast<int>(fault.size()),
                 fault.data());
    std::abort();
}

long numberOf(std::string_view text, long otherwise, std::string_view fault) {
    if (text.empty()) {
        return otherwise;
    }
    const std::string digits(text);
    char* end = nullptr;
    const long number = std::strtol(digits.c_str(), &end, 10);
    if (*end != '\0' || number < 1) {
        refuse(fault);
    }
    return number;
}

}  // namespace

FaultSchedule::FaultSchedule(std::string_view text, std::string log) : logFile(std::move(log)) {
    while (!text.empty()) {
        const std::string_view fault = text.substr(0, text.find(';'));
        text.remove_prefix(fault.size() == text.size() ? fault.size() : fault.size() + 1);
        const std::size_t colon = fault.find(':');
        const std::size_t at = fault.find('@');
        if (colon == std::string_view::npos || at == std::string_view::npos || at < colon) {
            refuse(fault);
        }
        const std::string_view range = fault.substr(at + 1);
        const std::size_t dash = range.find('-');
        const long first = numberOf(range.substr(0, dash), 0, fault);
        const long last = dash == std::string_view::npos
                              ? first
                              : numberOf(range.substr(dash + 1), std::numeric_limits<long>::max(), fault);
        faults.push_back({std::string(fault.substr(0, colon)),
                          std::string(fault.substr(colon + 1, at - colon - 1)), first, last});
    }
}

std::string_view FaultSchedule::strike(const std::string& call) {
    const std::scoped_lock lock(mutex);
    const long number = ++counts[call];
    for (const Fault& fault : faults) {
        if (fault.call != call || number < fault.first || number > fault.last) {
            continue;
        }
        if (std::FILE* file = logFile.empty() ? nullptr : std::fopen(logFile.c_str(), "a")) {
            std::fprintf(file, "%s:%s@%ld\n", call.c_str(), fault.name.c_str(), number);
            std::fclose(file);
        }
        return fault.name;
    }
    return {};
}

}  // namespace raytorus::test
