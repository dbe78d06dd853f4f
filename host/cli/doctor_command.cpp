// SPDX-License-Identifier: MIT
// raytorus doctor: what Vulkan offers here, and whether raytorus can use it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "cli/command.hpp"
#include "core/console.hpp"
#include "gpu/context.hpp"
#include "gpu/result.hpp"
#include "options/device_options.hpp"
#include "trace/self_check.hpp"

namespace raytorus::cli {
namespace {

constexpr const char* doctorFooter = R"(Ends with 0 if there is a device that raytorus can use, else with 8.

Examples:
  raytorus doctor
  VK_DRIVER_FILES=/path/to/driver.json raytorus doctor     look at one driver alone)";

void printLoader() {
    std::uint32_t loader = 0;
    gpu::check(vkEnumerateInstanceVersion(&loader), "vkEnumerateInstanceVersion");
    print("raytorus {}\nVulkan loader {}\n", version(), gpu::versionText(loader));
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_ADD_DRIVER_FILES",
                             "VK_LOADER_DRIVERS_SELECT", "VK_LAYER_PATH", "VK_INSTANCE_LAYERS"}) {
        if (const char* value = std::getenv(name)) {
            print("  {}={}\n", name, value);
        }
    }
}

void printLayers() {
    print("Layers\n");
    for (const VkLayerProperties& layer : gpu::instanceLayers()) {
        print("  {} {}: {}\n", layer.layerName, gpu::versionText(layer.specVersion), layer.description);
    }
    print("  --validate {}\n", gpu::validationLayerAvailable()
                                   ? "works"
                                   : "needs VK_LAYER_KHRONOS_validation (Debian: vulkan-validationlayers)");
}

void printDevice(const gpu::DeviceInfo& device) {
    print("  {}: {} ({}), Vulkan {}\n     driver {}, {}\n     {:.1f} GiB of device memory, timestamps {}\n",
          device.index, device.name, device.type, gpu::versionText(device.apiVersion), device.driverName,
          device.driverInfo, std::ldexp(static_cast<double>(device.deviceMemory), -30),
          device.timestampPeriod > 0.0 ? fmt::format("every {} ns", device.timestampPeriod) : "none");
    for (const std::string& fact : device.features) {
        print("     has {}\n", fact);
    }
    for (const std::string& refusal : device.refusals) {
        print("     refused: {}\n", refusal);
    }
    if (device.suitable()) {
        print("     suitable\n");
    }
}

ExitCode runDoctor() {
    printLoader();
    printLayers();
    const std::vector<gpu::DeviceInfo> devices = gpu::surveyDevices();
    print("Devices\n");
    for (const gpu::DeviceInfo& device : devices) {
        printDevice(device);
    }
    const gpu::DeviceInfo chosen = gpu::pickDevice(devices, "");
    print("raytorus uses device {}, {}, unless --device says otherwise\n", chosen.index, chosen.name);
    options::withDevice({}, [](gpu::Context& context) {
        const trace::SelfCheck found = trace::selfCheck(context);
        print("  its arithmetic {}\n",
              found.exact ? "holds what the exact tier rests on"
                          : "does not hold what the exact tier rests on: answers may be wrong");
        print("  its fma() {}\n", found.fusedFma ? "rounds once: shaders may define TORUS_FUSED_FMA"
                                                 : "rounds twice: shaders must not define TORUS_FUSED_FMA");
        print("  numbers below 2^-126 are {}\n",
              found.denormals ? "kept" : "taken for 0, which changes no answer");
    });
    return ExitCode::Ok;
}

}  // namespace

void addDoctorCommand(CLI::App& app, Action& action) {
    CLI::App* sub = app.add_subcommand("doctor", "Show the Vulkan loader, layers, drivers and devices");
    sub->footer(doctorFooter);
    sub->callback([&action] { action = runDoctor; });
}

}  // namespace raytorus::cli
