// SPDX-License-Identifier: MIT
// What a command that needs no OpenImageIO must not load: it comes with some 250 libraries, and to link them
// takes longer than all else that a small command does.
#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

class ProgramStart : public ProgramTest {
protected:
    ProgramStart() {
        write("scene.json", smallScene);
        write("rays.csv", "3,0,0,0,-1,0,0,inf\n");
    }

    // glibc's loader tells of each file on standard error.
    [[nodiscard]] bool loadsOpenImageIo(const Arguments& arguments) const {
        const ProgramResult result = run(arguments, {{"LD_DEBUG", "files"}});
        EXPECT_EQ(result.exitCode, 0) << result.err.substr(result.err.rfind('\n', result.err.size() - 2) + 1);
        EXPECT_NE(result.err.find("libvulkan"), std::string::npos) << "the loader tells nothing";
        const auto loads = [&](const char* library) { return result.err.find(library) != std::string::npos; };
        EXPECT_TRUE(loads("libOpenImageIO") || !loads("libOpenEXR")) << "OpenEXR is loaded without it";
        return loads("libOpenImageIO");
    }
};

TEST_F(ProgramStart, LoadsOpenImageIoForExrAlone) {
    EXPECT_FALSE(loadsOpenImageIo({"--version"}));
    EXPECT_FALSE(loadsOpenImageIo({"trace", "rays.csv", "-o", "hits.csv", "--torus", "1,0.25"}));
    EXPECT_FALSE(loadsOpenImageIo({"render", "scene.json", "-o", "out.png"}));
    EXPECT_TRUE(loadsOpenImageIo({"render", "scene.json", "-o", "out.exr"}));
    EXPECT_FALSE(loadsOpenImageIo({"compare", "out.png", "out.png"}));
    EXPECT_TRUE(loadsOpenImageIo({"compare", "out.exr", "out.exr"}));
}

}  // namespace
}  // namespace raytorus::test
