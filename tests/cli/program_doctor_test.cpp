// SPDX-License-Identifier: MIT
// raytorus doctor: what it tells of a machine that works, and of one without a driver.
#include "support/patterns.hpp"
#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

class ProgramDoctor : public ProgramTest {};

TEST_F(ProgramDoctor, NamesLoaderLayersAndDevice) {
    const std::string text = expectOk({"doctor"});
    for (const char* pattern : {
             "^raytorus [0-9]+\\.[0-9]+\\.[0-9]+\n",
             "\nVulkan loader 1\\.[0-9]+\\.[0-9]+\n",
             "\nLayers\n",
             "\n  VK_LAYER_KHRONOS_validation 1\\.[0-9]+\\.[0-9]+: ",
             "\n  --validate works\n",
             "\nDevices\n  0: .+\\), Vulkan 1\\.[0-9]+\\.[0-9]+\n     driver .+\n     [0-9.]+ GiB of device "
             "memory, ",
             "\n     has dynamicRendering\n",
             "\n     suitable\n",
             "\nraytorus uses device [0-9]+, .+, unless --device says otherwise\n  its arithmetic holds what "
             "the "
             "exact tier rests on\n  its fma\\(\\) rounds (once: shaders may|twice: shaders must not) define "
             "TORUS_FUSED_FMA\n  numbers below 2\\^-126 are (kept|taken for 0, which changes no answer)\n$",
         }) {
        EXPECT_FALSE(matchesIn(text, pattern).empty()) << pattern << " is not in: " << text;
    }
}

TEST_F(ProgramDoctor, ShowsTheVariablesThatChangeWhatTheLoaderFinds) {
    const std::string text = expectOk({"doctor"}, {{"VK_LAYER_PATH", "/there/are/no/layers"}});
    EXPECT_NE(text.find("\n  VK_LAYER_PATH=/there/are/no/layers\n"), std::string::npos) << text;
    EXPECT_NE(text.find("--validate needs VK_LAYER_KHRONOS_validation"), std::string::npos) << text;
}

// Here a part of the report comes before the message: it is what helps.
TEST_F(ProgramDoctor, NoDeviceWithoutADriver) {
    const ProgramResult result = run({"doctor"}, noDriver());
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::NoDevice));
    EXPECT_NE(result.out.find("Vulkan loader 1."), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("VK_DRIVER_FILES=/there/is/no/driver.json"), std::string::npos) << result.out;
    EXPECT_TRUE(isLike(result.err, "raytorus: no Vulkan driver was found: .+\n")) << result.err;
}

TEST_F(ProgramDoctor, ValidationNeedsItsLayer) {
    write("scene.json", smallScene);
    expectFailure({"render", "scene.json", "-o", "out.png", "--validate"}, ExitCode::NoDevice,
                  {"VK_LAYER_KHRONOS_validation", "not installed"},
                  {{"VK_LAYER_PATH", "/there/are/no/layers"}});
}

}  // namespace
}  // namespace raytorus::test
