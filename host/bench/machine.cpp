// SPDX-License-Identifier: MIT
#include "bench/machine.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "bench/stopwatch.hpp"

namespace raytorus::bench {
namespace {

// "AMD EPYC 7B13": Linux' own words; empty where there are none.
std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "";
}

}  // namespace

Machine describeMachine(const gpu::Context& context) {
    const gpu::DeviceInfo& info = context.info();
    const char* threads = std::getenv("LP_NUM_THREADS");
    Machine machine;
    machine.device = info.name;
    machine.driver = info.driverName + " " + info.driverInfo;
    machine.deviceType = info.type;
    machine.vulkan = gpu::versionText(info.apiVersion);
    machine.processor = processorName();
    machine.processors = std::thread::hardware_concurrency();
    machine.lavapipeThreads = threads != nullptr ? threads : "";
    machine.clock = Stopwatch::clockOf(info);
    return machine;
}

std::string machineText(const Machine& machine) {
    const bool lavapipe = machine.device.starts_with("llvmpipe");
    const std::string threads =
        !lavapipe ? ""
                  : fmt::format(", LP_NUM_THREADS{}",
                                machine.lavapipeThreads.empty() ? " not set" : "=" + machine.lavapipeThreads);
    return fmt::format("{} ({}), Vulkan {}{}, {} x {}, {}", machine.device, machine.driver, machine.vulkan,
                       threads, machine.processors, machine.processor, machine.clock);
}

}  // namespace raytorus::bench
