// SPDX-License-Identifier: MIT
// raytorus trace with more rays than it takes at a time (2^17, in two places): every answer in its place, and
// memory that does not grow with the file.
#include <cstring>
#include <fstream>
#include <limits>

#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

constexpr std::size_t rayFloats = 8;
constexpr std::size_t hitFloats = 8;

// Ray i starts at x = 3 + i mod 1000 on the axis and goes towards the torus, which it meets at x = 1.25.
float startOf(std::size_t index) {
    return 3.0F + static_cast<float>(index % 1000);
}

void writeRays(const std::filesystem::path& path, std::size_t count) {
    std::vector<float> rays(count * rayFloats);
    for (std::size_t i = 0; i < count; ++i) {
        float* ray = rays.data() + i * rayFloats;
        ray[0] = startOf(i);
        ray[4] = -1.0F;
        ray[7] = std::numeric_limits<float>::infinity();
    }
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(rays.data()),
               static_cast<std::streamsize>(rays.size() * sizeof(float)));
    ASSERT_TRUE(file.flush());
}

class ProgramBulk : public ProgramTest {
protected:
    ~ProgramBulk() override { std::filesystem::remove_all(folder); }  // half a gigabyte is too much to leave

    // AddressSanitizer, if it is there, keeps freed memory for a while.
    [[nodiscard]] ProgramResult traceRays(std::size_t count) const {
        writeRays(folder / "rays.bin", count);
        return run({"trace", "rays.bin", "-o", "hits.bin", "--torus", "1,0.25"},
                   {{"ASAN_OPTIONS", "quarantine_size_mb=1"}});
    }
};

TEST_F(ProgramBulk, EveryHitIsInItsPlace) {
    constexpr std::size_t count = 1300000;
    const ProgramResult result = traceRays(count);
    EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
    EXPECT_EQ(result.out + result.err, "");
    const std::string bytes = fileText(folder / "hits.bin");
    ASSERT_EQ(bytes.size(), count * hitFloats * sizeof(float));
    std::vector<float> hits(count * hitFloats);
    std::memcpy(hits.data(), bytes.data(), bytes.size());
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i) {
        // Rays 1000 apart are equal and neighbours differ by 1: a tolerance of 2^-10, some roundings of
        // numbers up to 1000, tells them apart.
        const float t = startOf(i) - 1.25F;
        wrong += hits[i * hitFloats] == 1.0F && std::abs(hits[i * hitFloats + 1] - t) <= 0x1p-10F ? 0U : 1U;
    }
    EXPECT_EQ(wrong, 0U);
}

// A file of several batches is checked to its end: nothing is written, and the line has its number.
TEST_F(ProgramBulk, DamageFarIntoAFileIsNamedWithItsLine) {
    std::string rays;
    for (int i = 0; i < 400000; ++i) {
        rays += "3,0,0,0,-1,0,0,inf\n";
    }
    write("rays.csv", rays + "3,0,0,0,-1,0,zero,inf\n");
    expectFailure({"trace", "rays.csv", "-o", "hits.csv", "--torus", "1,0.25"}, ExitCode::File,
                  {"rays.csv", "line 400001", "\"zero\""});
}

// Both need several batches, so that all that a batch needs is there in both. More by 3.7 million rays, the
// second would need at least 118 MB more if it held its rays (32 bytes each), and as much again if it held
// its hits.
TEST_F(ProgramBulk, MemoryDoesNotGrowWithTheFile) {
    const ProgramResult small = traceRays(1300000);
    const ProgramResult large = traceRays(5000000);
    EXPECT_EQ(small.exitCode, 0) << testing::PrintToString(small);
    EXPECT_EQ(large.exitCode, 0) << testing::PrintToString(large);
    EXPECT_EQ(std::filesystem::file_size(folder / "hits.bin"), 5000000 * hitFloats * sizeof(float));
    // They differ by less than 1 MiB; with sanitizers the allocator keeps up to 63 MiB.
    constexpr std::size_t allowed = std::size_t{96} << 20U;
    EXPECT_LT(large.peakMemory, small.peakMemory + allowed);
}

}  // namespace
}  // namespace raytorus::test
