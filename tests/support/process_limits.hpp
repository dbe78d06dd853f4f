// SPDX-License-Identifier: MIT
// What this process may do for a while: how large a file may become, how many may be open, and whose they
// are.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace raytorus::test {

class Limit {
public:
    Limit(__rlimit_resource_t limited, rlim_t most) : resource(limited) {
        // A file that is too large shall be an error and not the end of the process.
        previous = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(resource, &before);
        const rlimit now = {most, before.rlim_max};
        if (setrlimit(resource, &now) != 0) {
            throw std::runtime_error("setrlimit");
        }
    }
    Limit(const Limit&) = delete;
    Limit& operator=(const Limit&) = delete;
    ~Limit() {
        setrlimit(resource, &before);
        std::signal(SIGXFSZ, previous);
    }

private:
    __rlimit_resource_t resource;
    rlimit before{};
    void (*previous)(int) = SIG_DFL;
};

/// What the file system forbids, it does not forbid to root: becomes somebody else for a while. Threads keep
/// what they were started with, and seteuid() tells those that there are.
class WithoutPrivileges {
public:
    WithoutPrivileges() { EXPECT_EQ(geteuid() == 0 ? seteuid(nobody) : 0, 0); }
    WithoutPrivileges(const WithoutPrivileges&) = delete;
    WithoutPrivileges& operator=(const WithoutPrivileges&) = delete;
    ~WithoutPrivileges() { EXPECT_EQ(getuid() == 0 ? seteuid(0) : 0, 0); }

private:
    static constexpr uid_t nobody = 65534;
};

}  // namespace raytorus::test
