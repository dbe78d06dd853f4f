// SPDX-License-Identifier: MIT
// Which call is to fail, how and when: "present:out-of-date@3-5;submit:device-lost@9".
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace raytorus::test {

class FaultSchedule {
public:
    /// Faults separated by ';', each "<call>:<fault>@<first>[-[<last>]]": the first call of the kind is
    /// number 1,
    /// "@3" is the third alone, "@3-" all from the third on. Each fault that strikes is written to the file
    /// `log`, a line "<call>:<fault>@<number>"; none if it is empty.
    FaultSchedule(std::string_view text, std::string log);

    /// Counts the call, and names the fault that it has; empty if it has none.
    std::string_view strike(const std::string& call);

private:
    struct Fault {
        std::string call;
        std::string name;
        long first;
        long last;
    };

    std::vector<Fault> faults;
    std::string logFile;
    std::mutex mutex;
    std::map<std::string, long> counts;
};

}  // namespace raytorus::test
