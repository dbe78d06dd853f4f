// SPDX-License-Identifier: MIT
// Files that promise more than they hold, and parts of the system that are damaged:
// tests/reliability/reliability_test.cpp tells how these are to be read.
#include <cstdint>

#include "reliability.hpp"
#include "support/png_damage.hpp"

namespace raytorus::test {
namespace {

class ReliabilityMemory : public Reliability {
protected:
    // The picture, with a header that promises another size.
    void promise(const std::string& name, std::uint32_t width, std::uint32_t height) const {
        writeText(folder / name, promising(text(name), width, height));
    }

    // Damage that no checksum tells.
    void damageData(const std::string& name) const { writeText(folder / name, withDamagedData(text(name))); }
};

TEST_F(ReliabilityMemory, APictureOfAnotherSizeIsNotDecoded) {
    ASSERT_EQ(shell("raytorus render ring.json -o a.png").exitCode, 0);
    ASSERT_EQ(shell("raytorus render ring.json -o b.png --size 3000x2000").exitCode, 0);
    const std::size_t ordinary = shell("exec raytorus compare a.png a.png").peakMemory;
    for (const char* command : {"exec raytorus compare a.png b.png", "exec raytorus compare b.png a.png"}) {
        const ProgramResult result = shell(command);
        EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::SizeDiffers)) << result.err;
        EXPECT_NE(result.out.find("3000 x 2000"), std::string::npos) << result.out;
        // 72 MB for the values alone, and all at once: 6.4 GB for 16384 x 16384
        EXPECT_LT(result.peakMemory, ordinary + 40'000'000U) << command;
    }
}

TEST_F(ReliabilityMemory, APictureThatPromisesMoreThanItHolds) {
    ASSERT_EQ(shell("raytorus render ring.json -o a.png && cp a.png b.png && cp a.png c.png").exitCode, 0);
    promise("b.png", 16384, 16384);
    // 4, with 1 GB
    expectEnd("raytorus compare b.png b.png", ExitCode::File, {"b.png", "cannot hold 16384 x 16384 pixels"});
    EXPECT_LT(shell("exec raytorus compare b.png b.png").peakMemory, 300'000'000);
    promise("c.png", 65537, 3);
    expectEnd("raytorus compare a.png c.png", ExitCode::File, {"c.png", "65536"});
}

TEST_F(ReliabilityMemory, ADamagedPngIsOneLine) {
    ASSERT_EQ(shell("raytorus render ring.json -o a.png && cp a.png b.png").exitCode, 0);
    damageData("b.png");
    // 4, with another line: "libpng error: ..."
    expectEnd("raytorus compare a.png b.png", ExitCode::File, {"b.png", "truncated or corrupt ("});
}

TEST_F(ReliabilityMemory, ADifferenceThatIsNoPng) {
    ASSERT_EQ(shell("raytorus render ring.json -o a.exr").exitCode, 0);
    // 0, with an EXR that no document tells of
    for (const char* name : {"d.exr", "d.jpg", "d"}) {
        expectEnd(std::string("raytorus compare a.exr a.exr --difference ") + name, ExitCode::Usage,
                  {"must end in .png"});
        EXPECT_FALSE(std::filesystem::exists(folder / name));
    }
}

// 14. Parts of the system that are damaged.

// With sanitizers the modules are linked.
#ifndef __SANITIZE_ADDRESS__
TEST_F(ReliabilityMemory, AModuleThatCannotBeLoaded) {
    ASSERT_EQ(shell("raytorus render ring.json -o a.exr").exitCode, 0);
    const Environment modules = {{"LD_PRELOAD", RAYTORUS_FAILING_MODULES}, {"FAIL_MODULES", folder.string()}};
    writeText(folder / "raytorus-openimageio.so", "no library");
    // 4, without a reason
    expectEnd("raytorus compare a.exr a.exr", ExitCode::File,
              {"a.exr", "/raytorus-openimageio.so: file too short", "/raytorus-openexr.so: cannot open"},
              modules);
    expectEnd("raytorus render ring.json -o a.png && raytorus compare a.png a.png", ExitCode::Ok, {},
              modules);
}
#endif

// The drivers of this machine, after a file that is damaged.
TEST_F(ReliabilityMemory, ADamagedDriverFileHidesNoGoodOne) {
    std::filesystem::create_directories(folder / "data/vulkan/icd.d");
    for (const char* damage : {"{\"ICD\": {", "[1, 2]", "{\"ICD\": {\"library_path\": 5}}", "\xff\xfe", ""}) {
        writeText(folder / "data/vulkan/icd.d/bad.json", damage);
        // 9, "VK_ERROR_OUT_OF_HOST_MEMORY"; 134 and 139 by crashes of the loader
        const ProgramResult result =
            shell("unset VK_DRIVER_FILES VK_ICD_FILENAMES; raytorus render ring.json -o a.png",
                  {{"XDG_DATA_HOME", (folder / "data").string()}});
        EXPECT_EQ(result.exitCode, 0) << damage << result.err;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_NE(result.err.find("data/vulkan/icd.d/bad.json\": it "), std::string::npos) << result.err;
        expectEnd("raytorus render ring.json -o a.png", ExitCode::NoDevice,
                  {"bad.json\": it ", "there is no other"},
                  {{"VK_DRIVER_FILES", (folder / "data/vulkan/icd.d/bad.json").string()}});
    }
}

}  // namespace
}  // namespace raytorus::test
