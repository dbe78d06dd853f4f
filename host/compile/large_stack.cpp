// SPDX-License-Identifier: MIT
#include "compile/large_stack.hpp"

#include <pthread.h>

#include <cstddef>

namespace raytorus::compile {
namespace {

// glslang 12.0 needs between 400 and 512 MiB for a sum that fills maxSourceBytes.
constexpr std::size_t stackBytes = std::size_t{1} << 30U;

void* runWork(void* work) {
    (*static_cast<const std::function<void()>*>(work))();
    return nullptr;
}

}  // namespace

void runWithLargeStack(const std::function<void()>& work) {
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) == 0) {
        pthread_t thread{};
        // pthread_create wants what it hands on without const; runWork puts the const back.
        void* argument = const_cast<std::function<void()>*>(&work);
        const bool started = pthread_attr_setstacksize(&attributes, stackBytes) == 0 &&
                             pthread_create(&thread, &attributes, runWork, argument) == 0;
        pthread_attr_destroy(&attributes);
        if (started) {
            pthread_join(thread, nullptr);
            return;
        }
    }
    work();
}

}  // namespace raytorus::compile
