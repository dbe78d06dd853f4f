// SPDX-License-Identifier: MIT
// A limit of this process for a while: how large a file may become, how many may be open.
#pragma once

#include <sys/resource.h>

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

}  // namespace raytorus::test
