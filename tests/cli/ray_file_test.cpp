// SPDX-License-Identifier: MIT
// Ray and hit files a piece at a time: what is read, what is written, and when it appears.
#include "cli/ray_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "support/expect_error.hpp"
#include "support/scratch_folder.hpp"

namespace raytorus::cli {
namespace {

using test::expectError;
using test::fileText;
using test::namesIn;
using test::scratchFolder;
using test::writeText;
using trace::Query;
using trace::TraceRay;

class RayFile : public testing::Test {
protected:
    std::filesystem::path file(const std::string& name, const std::string& text) const {
        writeText(folder / name, text);
        return folder / name;
    }

    std::filesystem::path folder = scratchFolder();
};

std::vector<TraceRay> readSome(RayReader& reader, std::size_t most) {
    std::vector<TraceRay> rays(most);
    rays.resize(reader.read(rays));
    return rays;
}

std::string rawRays(int count) {
    std::vector<float> values(static_cast<std::size_t>(count) * 8);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<float>(i);
    }
    std::string bytes(values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

TEST_F(RayFile, FormatIsThatOfTheExtension) {
    EXPECT_EQ(formatOf("a.csv"), RayFormat::Csv);
    EXPECT_EQ(formatOf("a.CSV"), RayFormat::Csv);
    for (const char* name : {"a.bin", "a", "csv", ".csv", "a.csv.bin", "a.txt"}) {
        EXPECT_EQ(formatOf(name), RayFormat::Raw) << name;
    }
}

TEST_F(RayFile, RawRaysComeInPieces) {
    RayReader reader(file("rays.bin", rawRays(5)), RayFormat::Raw);
    EXPECT_EQ(reader.done(), 0.0);
    EXPECT_EQ(readSome(reader, 2).size(), 2U);
    EXPECT_EQ(reader.done(), 0.4);
    const std::vector<TraceRay> rays = readSome(reader, 2);
    ASSERT_EQ(rays.size(), 2U);
    EXPECT_EQ(rays[0].origin[0], 16.0F);
    EXPECT_EQ(rays[0].origin[2], 18.0F);
    EXPECT_EQ(rays[0].tMin, 19.0F);
    EXPECT_EQ(rays[1].direction[1], 29.0F);
    EXPECT_EQ(rays[1].tMax, 31.0F);
    EXPECT_EQ(readSome(reader, 2).size(), 1U);
    EXPECT_EQ(reader.done(), 1.0);
    EXPECT_TRUE(readSome(reader, 2).empty());
}

TEST_F(RayFile, CsvRaysComeInPieces) {
    RayReader reader(file("rays.csv",
                          "originX,originY,originZ,tMin,directionX,directionY,directionZ,tMax\n1,2,3,4,5,6,7,"
                          "8\n# no ray\n-1,-2,-3,-4,-5,-6,-7,inf\n9,9,9,9,9,9,9,9"),
                     RayFormat::Csv);
    EXPECT_EQ(readSome(reader, 1).size(), 1U);
    const std::vector<TraceRay> rays = readSome(reader, 1);
    ASSERT_EQ(rays.size(), 1U);
    EXPECT_EQ(rays[0].origin[1], -2.0F);
    EXPECT_EQ(rays[0].tMin, -4.0F);
    EXPECT_EQ(rays[0].direction[2], -7.0F);
    EXPECT_EQ(rays[0].tMax, std::numeric_limits<float>::infinity());
    EXPECT_EQ(readSome(reader, 8).size(), 1U);
    EXPECT_TRUE(readSome(reader, 8).empty());
}

// Other names, or a second line of them, are no header.
TEST_F(RayFile, HeaderIsTheFirstLineAlone) {
    const auto readAll = [this](const std::string& text) {
        RayReader reader(file("rays.csv", text), RayFormat::Csv);
        readSome(reader, 100);
    };
    const std::string header = "originX,originY,originZ,tMin,directionX,directionY,directionZ,tMax\n";
    readAll("\n# comment\n" + header + "1,2,3,4,5,6,7,8\n");
    expectError([&] { readAll(header + header); }, ExitCode::File, {"line 2", "column 1", "\"originX\""});
    expectError([&] { readAll("1,2,3,4,5,6,7,8\n" + header); }, ExitCode::File, {"line 2", "\"originX\""});
    expectError([&] { readAll("a,b,c,d,e,f,g,h\n"); }, ExitCode::File,
                {"line 1", "column 1, originX: \"a\""});
    expectError([&] { readAll("a,b,c,d,e,f,g,8\n"); }, ExitCode::File, {"line 1", "\"a\""});
    expectError([&] { readAll("a,b,c\n"); }, ExitCode::File, {"line 1", "3 values"});
}

TEST_F(RayFile, LinesAreCountedAcrossPieces) {
    RayReader reader(file("rays.csv", "1,2,3,4,5,6,7,8\n\n1,2,3,4,5,6,7,8\n1,2,3,4\n"), RayFormat::Csv);
    EXPECT_EQ(readSome(reader, 1).size(), 1U);
    EXPECT_EQ(readSome(reader, 1).size(), 1U);
    expectError([&] { static_cast<void>(readSome(reader, 1)); }, ExitCode::File,
                {"rays.csv", "line 4", "4 values"});
}

TEST_F(RayFile, FilesThatCannotBeRead) {
    expectError([this] { RayReader(folder / "missing.bin", RayFormat::Raw); }, ExitCode::File,
                {"missing.bin"});
    expectError([this] { RayReader(folder, RayFormat::Raw); }, ExitCode::File, {"directory"});
    for (const std::size_t size : {1U, 31U, 33U}) {
        const auto path = file("odd.bin", std::string(size, 'x'));
        expectError([&] { RayReader(path, RayFormat::Raw); }, ExitCode::File,
                    {"odd.bin", std::to_string(size) + " bytes"});
    }
}

TEST_F(RayFile, RawFileThatShrinksMeanwhile) {
    const auto path = file("rays.bin", rawRays(4));
    RayReader reader(path, RayFormat::Raw);
    std::filesystem::resize_file(path, 40);
    expectError([&] { static_cast<void>(readSome(reader, 4)); }, ExitCode::File, {"rays.bin", "ended"});
}

TEST_F(RayFile, CsvHitsAreTheShortestDecimals) {
    HitWriter writer(folder / "hits.csv", RayFormat::Csv, Query::Nearest);
    const std::vector<float> hits = {
        1, 0.1F, 16777216.0F, -0.0F, 1e-30F, 0, 0, 1, 0, std::numeric_limits<float>::infinity(),
        0, 0,    0,           0,     0,      0};
    writer.write(hits);
    writer.write(std::vector<float>(8, 0.5F));
    writer.commit();
    EXPECT_EQ(fileText(folder / "hits.csv"),
              "hit,t,x,y,z,normalX,normalY,normalZ\n1,0.1,16777216,-0,1e-30,0,0,1\n0,inf,0,0,0,0,0,0\n"
              "0.5,0.5,0.5,0.5,0.5,0.5,0.5,0.5\n");
}

// More rows than are put into words at a time, with the longest words there are.
TEST_F(RayFile, ManyCsvHitsAreAllThere) {
    const std::vector<float> values = {
        -1.17549435e-38F, -3.4028235e+38F, -0.00012345679F, -123456790000.0F, -1.1754942e-38F, 0, 1, -1};
    const std::string row =
        "-1.1754944e-38,-3.4028235e+38,-0.00012345679,-123456790000,-1.1754942e-38,0,1,-1\n";
    std::string expected = "hit,t,x,y,z,normalX,normalY,normalZ\n";
    std::vector<float> hits;
    for (int i = 0; i < 1500; ++i) {
        hits.insert(hits.end(), values.begin(), values.end());
        expected += row;
    }
    HitWriter writer(folder / "hits.csv", RayFormat::Csv, Query::Nearest);
    writer.write(hits);
    writer.commit();
    EXPECT_TRUE(fileText(folder / "hits.csv") == expected);
}

TEST_F(RayFile, RawHitsAreTheBytes) {
    const std::string bytes = rawRays(3);
    std::vector<float> hits(24);
    std::memcpy(hits.data(), bytes.data(), bytes.size());
    HitWriter writer(folder / "hits.bin", RayFormat::Raw, Query::Nearest);
    writer.write(std::span(hits).first(8));
    writer.write(std::span(hits).subspan(8));
    writer.commit();
    EXPECT_TRUE(fileText(folder / "hits.bin") == bytes);
}

TEST_F(RayFile, HitsAppearWhenTheyAreComplete) {
    file("hits.csv", "what was there before");
    {
        HitWriter writer(folder / "hits.csv", RayFormat::Csv, Query::Any);
        writer.write(std::vector<float>(3, 1.0F));
        EXPECT_EQ(fileText(folder / "hits.csv"), "what was there before");
    }
    EXPECT_EQ(fileText(folder / "hits.csv"), "what was there before");
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"hits.csv"}));
}

}  // namespace
}  // namespace raytorus::cli
