// SPDX-License-Identifier: MIT
// Every exit code that raytorus publishes, provoked through the program. Those of compare and of the command
// line have files of their own; code 1 is a fault of the program, for which no cause is known.
#include <sys/stat.h>

#include <cstdint>

#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

class ProgramExitCode : public ProgramTest {
protected:
    ProgramExitCode() {
        write("scene.json", smallScene);
        write("rays.csv", "3,0,0,0,-1,0,0,inf\n");
    }
};

TEST_F(ProgramExitCode, FileWhenTheInputIsMissing) {
    expectFailure({"render", "missing.json", "-o", "out.png"}, ExitCode::File, {"missing.json"});
    expectFailure({"trace", "missing.csv", "-o", "out.csv", "--torus", "1,0.25"}, ExitCode::File,
                  {"missing.csv"});
    expectFailure({"trace", "missing.bin", "-o", "out.bin", "--torus", "1,0.25"}, ExitCode::File,
                  {"missing.bin"});
}

TEST_F(ProgramExitCode, FileWhenTheInputIsAFolder) {
    std::filesystem::create_directory(folder / "input");
    expectFailure({"render", "input", "-o", "out.png"}, ExitCode::File, {"input"});
    expectFailure({"trace", "input", "-o", "out.csv", "--torus", "1,0.25"}, ExitCode::File, {"input"});
}

TEST_F(ProgramExitCode, FileWhenTheFolderOfTheOutputIsMissing) {
    expectFailure({"render", "scene.json", "-o", "missing/out.png"}, ExitCode::File, {"missing/out.png"});
    expectFailure({"trace", "rays.csv", "-o", "missing/out.csv", "--torus", "1,0.25"}, ExitCode::File,
                  {"missing/out.csv"});
}

TEST_F(ProgramExitCode, FileWhenTheOutputIsAFolder) {
    std::filesystem::create_directory(folder / "out.exr");
    expectFailure({"render", "scene.json", "-o", "out.exr"}, ExitCode::File,
                  {"out.exr", "it is a directory"});
    expectFailure({"trace", "rays.csv", "-o", "out.exr", "--torus", "1,0.25"}, ExitCode::File,
                  {"out.exr", "it is a directory"});
}

// To rename over a pipe or a device would put a file in its place.
TEST_F(ProgramExitCode, FileWhenTheOutputIsAPipe) {
    ASSERT_EQ(mkfifo((folder / "out.png").c_str(), 0600), 0);
    expectFailure({"render", "scene.json", "-o", "out.png"}, ExitCode::File,
                  {"out.png", "not a regular file"});
    expectFailure({"trace", "rays.csv", "-o", "out.png", "--torus", "1,0.25"}, ExitCode::File,
                  {"out.png", "not a regular file"});
    EXPECT_TRUE(std::filesystem::is_fifo(folder / "out.png"));
}

// A picture may take minutes: that there is no driver either would be found first.
TEST_F(ProgramExitCode, FileBeforeTheWorkIsDone) {
    expectFailure({"render", "scene.json", "-o", "missing/out.png"}, ExitCode::File, {"missing/out.png"},
                  noDriver());
}

TEST_F(ProgramExitCode, FileWhenTheShaderIsMissing) {
    const std::string shaders = shaderFolder();
    std::filesystem::remove(shaders + "/scene.frag.spv");
    expectFailure({"render", "scene.json", "-o", "out.png", "--shaders", shaders}, ExitCode::File,
                  {"scene.frag.spv"});
}

TEST_F(ProgramExitCode, SceneWithTheJsonPath) {
    write("wrong.json", R"({"tori": [{"majorRadius": 1, "minorRadius": -1}]})");
    expectFailure({"render", "wrong.json", "-o", "out.png"}, ExitCode::Scene,
                  {"wrong.json", "/tori/0/minorRadius", "-1"});
    write("damaged.json", "{\"tori\": [\n");
    expectFailure({"render", "damaged.json", "-o", "out.png"}, ExitCode::Scene, {"damaged.json", "line 2"});
}

TEST_F(ProgramExitCode, ShaderWhenItIsCutOff) {
    const std::filesystem::path shaders = shaderFolder();
    for (const char* name : {"scene.frag.spv", "scene.comp.spv", "trace.comp.spv"}) {
        std::filesystem::resize_file(shaders / name, std::filesystem::file_size(shaders / name) - 40);
    }
    const std::string option = shaders.string();
    expectFailure({"render", "scene.json", "-o", "out.png", "--shaders", option}, ExitCode::Shader,
                  {"scene.frag"});
    expectFailure({"render", "scene.json", "-o", "out.exr", "--route", "compute", "--shaders", option},
                  ExitCode::Shader, {"scene.comp"});
    expectFailure({"trace", "rays.csv", "-o", "out.csv", "--torus", "1,0.25", "--shaders", option},
                  ExitCode::Shader, {"trace.comp"});
    // Not even a whole number of words.
    std::filesystem::resize_file(shaders / "scene.frag.spv", 1001);
    expectFailure({"render", "scene.json", "-o", "out.png", "--shaders", option}, ExitCode::Shader,
                  {"scene.frag", "1001"});
}

TEST_F(ProgramExitCode, NoDeviceWithoutADriver) {
    expectFailure({"render", "scene.json", "-o", "out.png"}, ExitCode::NoDevice,
                  {"no Vulkan driver", "VK_DRIVER_FILES"}, noDriver());
    expectFailure({"trace", "rays.csv", "-o", "out.csv", "--torus", "1,0.25"}, ExitCode::NoDevice,
                  {"no Vulkan driver", "VK_DRIVER_FILES"}, noDriver());
}

TEST_F(ProgramExitCode, NoDeviceOfThatNameAndWhatThereIs) {
    for (const char* name : {"nonsense", "99"}) {
        expectLongFailure({"render", "scene.json", "-o", "out.png", "--device", name}, ExitCode::NoDevice,
                          {name, "there are:\n  0: "});
    }
}

// The largest size there is, with all channels: more values than a picture may have, whatever the device.
TEST_F(ProgramExitCode, OutOfMemory) {
    for (const char* route : {"fragment", "compute"}) {
        expectFailure({"render", "scene.json", "-o", "out.exr", "--size", "16384x16384", "--route", route},
                      ExitCode::OutOfMemory, {"16384 x 16384"});
    }
}

// One microsecond is less than any device takes for 4096 samples of each of 65536 pixels.
TEST_F(ProgramExitCode, DeviceLostWhenItDoesNotFinishInTime) {
    for (const char* route : {"fragment", "compute"}) {
        expectFailure({"render", "scene.json", "-o", "out.png", "--size", "256x256", "--spp", "4096",
                       "--route", route, "--timeout", "0.000001"},
                      ExitCode::DeviceLost, {"did not finish", "1e-06 s"});
    }
}

// A million rays that the march has work with. Rays that are none take so little time that a busy machine's
// device is done before it is asked.
TEST_F(ProgramExitCode, DeviceLostWhenTracingTakesTooLong) {
    constexpr std::array<float, 8> ray = {3, 0.25F, 0.125F, 0, -1, 0.03125F, 0.015625F, 100};
    std::string rays;
    for (int i = 0; i < 1 << 20; ++i) {
        rays.append(reinterpret_cast<const char*>(ray.data()), sizeof ray);
    }
    write("many.bin", rays);
    expectFailure({"trace", "many.bin", "-o", "out.bin", "--torus", "1,0.25", "--timeout", "0.000001"},
                  ExitCode::DeviceLost, {"did not finish"});
}

// A shader that reads a push constant, of which its pipeline has none: an error, but one that drivers
// survive.
TEST_F(ProgramExitCode, ValidationMessage) {
    const std::filesystem::path shaders = shaderFolder();
    std::filesystem::copy_file(RAYTORUS_TEST_SHADER_FOLDER "/undeclared_push_constant.frag.spv",
                               shaders / "scene.frag.spv", std::filesystem::copy_options::overwrite_existing);
    const Arguments arguments = {"render",    "scene.json",     "-o",        "out.png",
                                 "--shaders", shaders.string(), "--validate"};
    expectLongFailure(arguments, ExitCode::ValidationMessage, {"validation layers reported", "VUID-"});
}

TEST_F(ProgramExitCode, NonFiniteWhenTheSumOfLightsIsInfinite) {
    write("bright.json",
          R"({"tori": [{"majorRadius": 1, "minorRadius": 0.25}], "image": {"width": 32, "height": 32},
        "lights": [{"type": "directional", "direction": [0, 0, 1], "radiance": [3e38, 3e38, 3e38]},
                   {"type": "directional", "direction": [0, 0.1, 1], "radiance": [3e38, 3e38, 3e38]}]})");
    for (const char* output : {"out.exr", "out.png"}) {
        expectFailure({"render", "bright.json", "-o", output}, ExitCode::NonFinite,
                      {"inf", "channel R", "nothing was"});
    }
}

}  // namespace
}  // namespace raytorus::test
