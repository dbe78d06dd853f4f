// SPDX-License-Identifier: MIT
#include "bench/stopwatch.hpp"

#include <chrono>
#include <ctime>

namespace raytorus::bench {
namespace {

bool isProcessor(const gpu::DeviceInfo& info) {
    return info.type == "CPU";
}

double processorSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wallSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Stopwatch::Stopwatch(gpu::Context& deviceContext)
    : context(&deviceContext), onProcessor(isProcessor(deviceContext.info())), timestamps(deviceContext) {}

double Stopwatch::submit(const std::function<void(VkCommandBuffer)>& record) const {
    const double before = onProcessor ? processorSeconds() : wallSeconds();
    context->submit([&](VkCommandBuffer commands) {
        timestamps.begin(commands);
        record(commands);
        timestamps.end(commands);
    });
    const double elapsed = (onProcessor ? processorSeconds() : wallSeconds()) - before;
    return onProcessor ? elapsed : timestamps.seconds().value_or(elapsed);
}

std::string Stopwatch::clockOf(const gpu::DeviceInfo& info) {
    return isProcessor(info) ? "processor time" : info.timestampPeriod > 0.0 ? "device timestamps" : "wall";
}

}  // namespace raytorus::bench
