// SPDX-License-Identifier: MIT
// raytorus trace: the answers, their order and their files.
#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <random>
#include <sstream>

#include "support/program_test.hpp"
#include "support/special_floats.hpp"

namespace raytorus::test {
namespace {

std::string headerOf(const std::string& csv) {
    return csv.substr(0, csv.find('\n'));
}

std::string bytesOf(const std::vector<float>& numbers) {
    std::string bytes(numbers.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

class ProgramTrace : public ProgramTest {
protected:
    // The text of the hits of rays in a CSV text.
    [[nodiscard]] std::string trace(const std::string& rays, Arguments options = {}) const {
        write("rays.csv", rays);
        options.insert(options.begin(), {"trace", "rays.csv", "-o", "hits.csv", "--torus", "1,0.25"});
        EXPECT_EQ(expectOk(options), "");
        return fileText(folder / "hits.csv");
    }

    void expectHits(const std::string& hits, const std::vector<float>& expected) const {
        const std::vector<float> numbers = numbersIn(hits);
        ASSERT_EQ(numbers.size(), expected.size()) << hits;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (std::isinf(expected[i])) {
                EXPECT_EQ(numbers[i], expected[i]) << "number " << i << " of " << hits;
            } else {
                // Some roundings of float32 (6e-8 relative) of numbers up to 6.
                EXPECT_NEAR(numbers[i], expected[i], 2e-6F) << "number " << i << " of " << hits;
            }
        }
    }
};

// Along the axes, where the answer is known: the tube is met at 1.25 and 0.75 from the centre, on both sides.
constexpr const char* axisRays =
    "3,0,0,0,-1,0,0,inf\n"  // through the whole ring
    "3,0,0,0,-2,0,0,inf\n"  // the same with a longer direction: t is in its units
    "0,-3,0,2,0,1,0,inf\n"  // from t = 2 on: the first surface is passed
    "1,0,5,0,0,0,-1,inf\n"  // down onto the tube
    "1,0,0,0,1,0,0,inf\n"   // from inside the tube
    "0,0,5,0,0,0,-1,inf\n"  // down through the hole
    "3,0,0,0,-1,0,0,1.5\n"  // ends before the torus
    "3,0,0,0,1,0,0,inf\n";  // away from it

TEST_F(ProgramTrace, NearestHitsOfAxisRays) {
    const std::string hits = trace(axisRays);
    EXPECT_EQ(headerOf(hits), "hit,t,x,y,z,normalX,normalY,normalZ");
    expectHits(hits, {
                         1, 1.75F,    1.25F, 0,      0,     1, 0, 0,  //
                         1, 0.875F,   1.25F, 0,      0,     1, 0, 0,  //
                         1, 2.25F,    0,     -0.75F, 0,     0, 1, 0,  //
                         1, 4.75F,    1,     0,      0.25F, 0, 0, 1,  //
                         1, 0.25F,    1.25F, 0,      0,     1, 0, 0,  //
                         0, infinity, 0,     0,      0,     0, 0, 0,  //
                         0, 1.5F,     0,     0,      0,     0, 0, 0,  //
                         0, infinity, 0,     0,      0,     0, 0, 0,
                     });
}

TEST_F(ProgramTrace, AllHitsOfAxisRays) {
    const std::string hits =
        trace("3,0,0,0,-1,0,0,inf\n0,-3,0,2,0,1,0,4\n1,0,5,0,0,0,-1,inf\n3,0,0,0,1,0,0,7\n", {"--all"});
    EXPECT_EQ(headerOf(hits), "count,t0,t1,t2,t3,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3");
    expectHits(
        hits,
        {
            4,     1.75F, 2.25F, 3.75F,    4.25F,                                                        //
            1.25F, 0,     0,     0.75F,    0,        0,      -0.75F, 0, 0, -1.25F, 0, 0,                 //
            2,     2.25F, 3.75F, 4,        4,        0,      -0.75F, 0, 0, 0.75F,  0, 0, 0, 0, 0, 0, 0,  //
            2,     4.75F, 5.25F, infinity, infinity,                                                     //
            1,     0,     0.25F, 1,        0,        -0.25F, 0,      0, 0, 0,      0, 0,                 //
            0,     7,     7,     7,        7,        0,      0,      0, 0, 0,      0, 0, 0, 0, 0, 0, 0,
        });
}

TEST_F(ProgramTrace, AnyHitOfAxisRays) {
    EXPECT_EQ(trace(axisRays, {"--any"}), "hit\n1\n1\n1\n1\n1\n0\n0\n0\n");
}

// Random rays near the torus, as float32 and as the shortest decimals that give the same float32.
TEST_F(ProgramTrace, CsvAndRawGiveTheSameBits) {
    std::mt19937 random(7);
    const auto number = [&random] { return static_cast<float>(random()) / 4294967296.0F * 2.0F - 1.0F; };
    std::vector<float> rays;
    std::string csv;
    for (int i = 0; i < 1000; ++i) {
        const std::array<float, 8> ray = {number(), number(), number(), 0.0F,
                                          number(), number(), number(), infinity};
        rays.insert(rays.end(), ray.begin(), ray.end());
        csv += fmt::format("{}\n", fmt::join(ray, ","));
    }
    write("rays.bin", bytesOf(rays));
    for (const Arguments& query : {Arguments{}, Arguments{"--all"}, Arguments{"--any"}}) {
        Arguments arguments = {"trace", "rays.bin", "-o", "hits.bin", "--torus", "1,0.25"};
        arguments.insert(arguments.end(), query.begin(), query.end());
        expectOk(arguments);
        const std::string raw = fileText(folder / "hits.bin");
        EXPECT_TRUE(bytesOf(numbersIn(trace(csv, query))) == raw) << testing::PrintToString(query);
        EXPECT_EQ(raw.size() % 4000, 0U);
    }
}

TEST_F(ProgramTrace, TakesHeaderCommentsBlankLinesAndLineEnds) {
    const std::string plain = trace("3,0,0,0,-1,0,0,inf\n1,0,5,0,0,0,-1,inf\n");
    EXPECT_EQ(trace("originX,originY,originZ,tMin,directionX,directionY,directionZ,tMax\n3,0,0,0,-1,0,0,"
                    "inf\n1,0,5,0,0,0,-1,inf\n"),
              plain);
    EXPECT_EQ(trace("# two rays\n\n3,0,0,0,-1,0,0,inf\n  # and\n   \n1,0,5,0,0,0,-1,inf"), plain);
    EXPECT_EQ(trace("3,0,0,0,-1,0,0,inf\r\n\r\n1,0,5,0,0,0,-1,inf\r\n"), plain);
    EXPECT_EQ(trace(" 3 , 0,\t0,0,-1.0,+0,0e5,Inf \n1,0,5,0,0,0,-1,infinity\n"), plain);
    EXPECT_EQ(trace("\xEF\xBB\xBF"
                    "3,0,0,0,-1,0,0,inf\n1,0,5,0,0,0,-1,inf\n"),
              plain);
}

TEST_F(ProgramTrace, NoRaysHaveNoHits) {
    EXPECT_EQ(trace(""), "hit,t,x,y,z,normalX,normalY,normalZ\n");
    EXPECT_EQ(trace("# none\n", {"--any"}), "hit\n");
    write("rays.bin", "");
    expectOk({"trace", "rays.bin", "-o", "hits.bin", "--torus", "1,0.25"});
    EXPECT_EQ(fileText(folder / "hits.bin"), "");
}

TEST_F(ProgramTrace, DamagedFilesAreNamedWithTheirLine) {
    const auto expectDamage = [this](const std::string& rays, const std::vector<std::string>& words) {
        write("rays.csv", rays);
        expectFailure({"trace", "rays.csv", "-o", "hits.csv", "--torus", "1,0.25"}, ExitCode::File, words);
    };
    const std::string good = "# rays\n3,0,0,0,-1,0,0,inf\n\n";
    expectDamage(good + "3,0,0,0,-1,0,0\n", {"rays.csv", "line 4", "7 values instead of 8"});
    expectDamage(good + "3,0,0,0,-1,0,0,1,\n", {"rays.csv", "line 4", "9 values instead of 8"});
    expectDamage(good + "3,0,0,0,-1,zero,0,1\n", {"rays.csv", "line 4", "\"zero\""});
    expectDamage(good + "3,0,0,0,-1,,0,1\n", {"rays.csv", "line 4", "\"\""});
    expectDamage(good + "3,0,0,0,-1,1e39,0,1\n", {"rays.csv", "line 4", "\"1e39\""});
    expectDamage("3 0 0 0 -1 0 0 inf\n", {"rays.csv", "line 1", "1 values instead of 8"});
    expectDamage("x,y,z\n3,0,0,0,-1,0,0,inf\n", {"rays.csv", "line 1", "3 values instead of 8"});
}

TEST_F(ProgramTrace, RawFileIsAWholeNumberOfRays) {
    write("rays.bin", std::string(8 * 32 + 4, '\0'));
    expectFailure({"trace", "rays.bin", "-o", "hits.csv", "--torus", "1,0.25"}, ExitCode::File,
                  {"rays.bin", "260 bytes", "32 bytes"});
}

// NaN is a miss and no fault.
TEST_F(ProgramTrace, NanInARayMisses) {
    EXPECT_EQ(
        trace("nan,0,0,0,-1,0,0,5\n3,0,0,0,nan,0,0,5\n3,0,0,nan,-1,0,0,5\n3,0,0,0,-1,0,0,nan\n", {"--any"}),
        "hit\n0\n0\n0\n0\n");
}

TEST_F(ProgramTrace, ValidationLayersAgree) {
    for (const Arguments& options :
         {Arguments{"--validate"}, Arguments{"--validate", "--all"}, Arguments{"--validate", "--any"}}) {
        EXPECT_NE(trace(axisRays, options), "");
    }
}

TEST_F(ProgramTrace, TakesShadersFromAFolder) {
    EXPECT_EQ(trace(axisRays, {"--shaders", shaderFolder().string()}), trace(axisRays));
}

}  // namespace
}  // namespace raytorus::test
