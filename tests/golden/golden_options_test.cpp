// SPDX-License-Identifier: MIT
// The commands of a check: the options that were given, and no others.
#include "golden/golden_options.hpp"

#include <gtest/gtest.h>

namespace raytorus::test {
namespace {

golden::Case ring() {
    golden::Case row;
    row.name = "ring";
    return row;
}

TEST(GoldenOptions, WithoutAnyTheCommandsAreShort) {
    const golden::CheckOptions options;
    EXPECT_EQ(options.checkCommand(ring()), "raytorus golden check ring");
    EXPECT_EQ(options.renewCommand(ring()), "raytorus golden renew ring --reason \"...\"");
    EXPECT_EQ(options.bitsCommand(), "raytorus golden bits --reason \"...\"");
    EXPECT_EQ(options.explainCommand("golden/scenes/ring.json"),
              "raytorus explain --scene golden/scenes/ring.json --pixel {x},{y}");
    EXPECT_EQ(golden::listCommand("golden"), "raytorus golden list");
}

TEST(GoldenOptions, EachIsKeptWhereTheCommandHasIt) {
    golden::CheckOptions options;
    options.folder = "my goldens";
    options.device.device = "NVIDIA RTX";
    options.device.validate = true;
    options.device.timeoutSeconds = 2.5;
    options.shaderFolder = "/tmp/it's";
    options.toleranceFactor = 8.0F;
    const std::string device = R"( --device 'NVIDIA RTX' --validate --timeout 2.5 --shaders '/tmp/it'\''s')";
    EXPECT_EQ(options.checkCommand(ring()),
              "raytorus golden check ring --folder 'my goldens'" + device + " --tolerance-factor 8");
    EXPECT_EQ(options.renewCommand(ring()),
              "raytorus golden renew ring --folder 'my goldens' --reason \"...\"");
    EXPECT_EQ(options.bitsCommand(),
              "raytorus golden bits --folder 'my goldens'" + device + " --reason \"...\"");
    EXPECT_EQ(options.explainCommand("my goldens/scenes/ring.json"),
              "raytorus explain --scene 'my goldens/scenes/ring.json'" + device + " --pixel {x},{y}");
    EXPECT_EQ(golden::listCommand("my goldens"), "raytorus golden list --folder 'my goldens'");
}

TEST(GoldenOptions, AValueIsNotTakenForAnOption) {
    golden::CheckOptions options;
    options.folder = "--help";
    EXPECT_EQ(options.checkCommand(ring()), "raytorus golden check ring --folder=--help");
}

}  // namespace
}  // namespace raytorus::test
