// SPDX-License-Identifier: MIT
// Nothing is lost and nothing passes in silence, case by case (docs/reliability.md). Each is a command as
// people type it, run by a shell in a folder of its own. Behind each stands how it ended when it was found.
#include "reliability.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace raytorus::test {
namespace {

// 1. A read error is not the end of a file.

TEST_F(Reliability, ReadErrorsInRays) {
    std::string rays;
    for (int i = 0; i < 20'000; ++i) {
        rays += "3,0,0,0,-1,0.0001220703125,0,inf\n";
    }
    writeText(folder / "rays.csv", rays);
    // 0, with 863 of 20 000 rows
    expectEnd(traceTo, ExitCode::File, {"cannot read \"rays.csv\": input/output error"},
              failingRead("rays.csv", 100'000));
    EXPECT_EQ(text("hits.csv"), "old");
    writeText(folder / "rays.bin", std::string(32 * 5000, '\0'));
    expectEnd("raytorus trace rays.bin -o hits.csv --torus 1,0.25", ExitCode::File,
              {"rays.bin", "input/output error"}, failingRead("rays.bin", 100'000));
    EXPECT_EQ(text("hits.csv"), "old");
    EXPECT_EQ(namesIn(folder), std::vector<std::string>({"hits.csv", "rays.bin", "rays.csv", "ring.json"}));
}

TEST_F(Reliability, ReadErrorsInAllElse) {
    ASSERT_EQ(shell("raytorus render ring.json -o a.png && raytorus render ring.json -o a.exr").exitCode, 0);
    for (const char* name : {"a.png", "a.exr"}) {
        expectEnd(fmt::format("raytorus compare {0} {0}", name), ExitCode::File, {name, "input/output error"},
                  failingRead(name, 100));
    }
    expectEnd("raytorus render ring.json -o out.png", ExitCode::File, {"ring.json", "input/output error"},
              failingRead("ring.json", 10));
    writeText(folder / "manifest.json", "{}");
    expectEnd("raytorus compare a.png a.png --manifest manifest.json", ExitCode::File,
              {"manifest.json", "input/output error"}, failingRead("manifest.json", 1));
    writeText(folder / "before.json", "{}");
    expectEnd(
        "raytorus-bench --quick --rounds 3 --rays 4096 --method ray-sphere --workload tiles/0.25/near/30 "
        "--against before.json",
        ExitCode::File, {"before.json", "input/output error"}, failingRead("before.json", 1));
    expectEnd("raytorus golden check dark --folder " RAYTORUS_SOURCE_DIR "/golden", ExitCode::File,
              {"cases.json", "input/output error"}, failingRead("cases.json", 1));
}

TEST_F(Reliability, ALineThatDoesNotFit) {
    const std::size_t ordinary = shell("exec raytorus trace rays.csv -o other.csv --torus 1,0.25").peakMemory;
    // Not by this process: what a process holds when it starts another counts as that one's, too.
    ASSERT_EQ(shell("(cat rays.csv; head -c 400000000 /dev/zero | tr '\\0' 1; echo; cat rays.csv) >long.csv; "
                    "mv long.csv rays.csv")
                  .exitCode,
              0);
    // 0, with the rows before, where memory was short
    expectEnd(traceTo, ExitCode::File, {"rays.csv", "line 2", "longer than 65536"});
    EXPECT_EQ(text("hits.csv"), "old");
    EXPECT_LT(shell("exec " + traceTo).peakMemory, ordinary + 200'000'000) << "half of the line";
    std::filesystem::remove(folder / "rays.csv");
}

// 2. A first ray is not taken for a header.

TEST_F(Reliability, FirstRaysThatAreMisspelt) {
    const std::string rest = "3,0,0,0,-1,0,0,inf\n";
    for (const auto& [line, word] :
         {std::pair<std::string, std::string>{"\"3\",\"0\",\"0\",\"0\",\"-1\",\"0\",\"0\",\"9\"",
                                              "\"\"3\"\""},
          {"0x1p1,0x0p0,0x0p0,0x0p0,-0x1p0,0x0p0,0x0p0,0x1p3", "\"0x1p1\""},
          {"1e39,1e39,1e39,1e39,1e39,1e39,1e39,1e39", "\"1e39\""},
          {"a,b,c,d,e,f,g,h", "\"a\""},
          {"originY,originX,originZ,tMin,directionX,directionY,directionZ,tMax", "\"originY\""}}) {
        writeText(folder / "rays.csv", line + "\n" + rest);
        // 0, without the first ray
        expectEnd(traceTo, ExitCode::File, {"rays.csv", "line 1", "column 1", word});
        EXPECT_EQ(text("hits.csv"), "old");
    }
    writeText(folder / "rays.csv",
              "originX,originY,originZ,tMin,directionX,directionY,directionZ,tMax\n" + rest);
    expectEnd(traceTo, ExitCode::Ok);
    EXPECT_NE(text("hits.csv").find("\n1,1.75,"), std::string::npos);
}

// 3. There is no torus that nobody sees.

TEST_F(Reliability, ToriBeyondTheRange) {
    const auto scene = [this](const std::string& torus) {
        writeText(folder / "far.json", R"({"image": {"width": 8, "height": 8}, "tori": [)" + torus + "]}");
        return "raytorus render far.json -o far.png";
    };
    // 0, and the background alone
    for (const char* torus : {R"({"majorRadius": 1, "minorRadius": 0.25, "scale": 1e18})",
                              R"({"majorRadius": 1e18, "minorRadius": 1e17})",
                              R"({"majorRadius": 1, "minorRadius": 0.25, "scale": 1e-19})",
                              R"({"majorRadius": 0, "minorRadius": 1e-20})"}) {
        expectEnd(scene(torus), ExitCode::Scene, {"far.json: /tori/0", "1e-18 to 1e+18"});
        EXPECT_FALSE(std::filesystem::exists(folder / "far.png"));
    }
    for (const char* radii : {"1e18,1e17", "1e-19,1e-20", "0,1e-20"}) {
        expectEnd(fmt::format("raytorus trace rays.csv -o hits.csv --torus {}", radii), ExitCode::Usage,
                  {"R + r from 1e-18 to 1e+18", radii});
    }
    EXPECT_EQ(text("hits.csv"), "old");
    // 0, with "the library is wrong"
    expectEnd("raytorus explain --torus 1e18,1e17 --origin 3,0,0 --direction -1,0,0", ExitCode::Usage,
              {"--torus needs R + r from 1e-18 to 1e+18"});
    for (const char* program : {"raytorus explain", "raytorus-verify"}) {
        expectEnd(fmt::format("{} --replay '1e18 1e17 3 0 0 0 -1 0 0 inf'", program), ExitCode::Usage,
                  {"--replay needs R + r from 1e-18 to 1e+18"});
    }
    for (const char* torus : {R"({"majorRadius": 7e17, "minorRadius": 1e17})",
                              R"({"majorRadius": 1e-18, "minorRadius": 1e-19})"}) {
        expectEnd(scene(torus), ExitCode::Ok);
    }
}

// 4. Words that cannot be said.

TEST_F(Reliability, StandardOutputThatIsFull) {
    const std::string explain = "raytorus explain --torus 1,0.25 --origin 3,0,0 --direction -1,0,0";
    for (const std::string& command :
         {std::string("raytorus doctor"), std::string("raytorus --help"), std::string("raytorus --version"),
          std::string("raytorus render --help"),
          std::string("raytorus render ring.json -o a.png --stats text"), explain, explain + " --json",
          std::string("raytorus-verify --help"), std::string("raytorus-verify --class camera --rays 10"),
          std::string("raytorus-bench --list"), std::string("raytorus-bench --version"),
          std::string("raytorus-view --list-keys"), std::string("raytorus-view --help")}) {
        for (const char* closed : {" >/dev/full", " >&-"}) {
            // 0, or 1 with "internal error"
            expectEnd(command + closed, ExitCode::File, {"cannot write to standard output"});
        }
    }
}

TEST_F(Reliability, StandardErrorThatIsFull) {
    for (const char* program : {"raytorus", "raytorus-verify", "raytorus-bench", "raytorus-view"}) {
        for (const char* closed : {"2>/dev/full", "2>&-", ">/dev/full 2>/dev/full", ">&- 2>&- <&-"}) {
            // 134, aborted
            const ProgramResult result = shell(fmt::format("{} --nonsense {}", program, closed));
            EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::Usage)) << program << closed;
        }
    }
}

// What is opened after a stream was closed has the stream's number, and is not written to by mistake.
TEST_F(Reliability, StandardStreamsThatAreClosed) {
    expectEnd("raytorus render ring.json -o a.png <&- >&- 2>&-", ExitCode::Ok);
    EXPECT_EQ(shell("raytorus render ring.json -o b.png && cmp a.png b.png").exitCode, 0);
    // The table would stand in the file.
    expectEnd("raytorus-verify --class camera --radius .25 --distance 3 --rays 10 --json out.json >&-",
              ExitCode::File, {"cannot write to standard output"});
    EXPECT_FALSE(std::filesystem::exists(folder / "out.json"));
}

// 9. What is left behind.

// A slow run: the reference's, of many rays. The signal goes out as soon as the temporary file is there. (A
// shell without a terminal starts its children deaf to INT.)
std::string interrupted(const std::string& signal) {
    return "env --default-signal=INT raytorus trace many.bin -o hits.csv --torus 1,0.25 --method reference & "
           "child=$!; "
           "for i in $(seq 2000); do ls .hits.csv.* >/dev/null 2>&1 && break; sleep 0.01; done; "
           "ls .hits.csv.* >there; kill -" +
           signal + " $child; wait $child";
}

TEST_F(Reliability, SignalsLeaveNothing) {
    writeText(folder / "many.bin", std::string(32 * 2'000'000, '\1'));
    for (const auto& [name, number] : {std::pair("INT", 2), std::pair("TERM", 15), std::pair("HUP", 1)}) {
        const ProgramResult result = shell(interrupted(name));
        EXPECT_EQ(result.exitCode, 128 + number) << result.err;
        EXPECT_NE(text("there").find(".hits.csv."), std::string::npos) << "there was something to leave";
        EXPECT_EQ(text("hits.csv"), "old");
        EXPECT_EQ(namesIn(folder),
                  std::vector<std::string>({"hits.csv", "many.bin", "rays.csv", "ring.json", "there"}));
    }
}

TEST_F(Reliability, TheNextRunRemovesWhatAKilledOneLeft) {
    writeText(folder / "many.bin", std::string(32 * 2'000'000, '\1'));
    EXPECT_EQ(shell(interrupted("KILL")).exitCode, 128 + 9);
    EXPECT_EQ(namesIn(folder).size(), 6U) << "a file that nobody could remove";
    expectEnd(traceTo, ExitCode::Ok);
    EXPECT_EQ(namesIn(folder),
              std::vector<std::string>({"hits.csv", "many.bin", "rays.csv", "ring.json", "there"}));
}

TEST_F(Reliability, FilesThatOutgrowTheLimit) {
    writeText(folder / "many.bin", std::string(32 * 50'000, '\1'));
    // -25, ended by SIGXFSZ, with a temporary file
    expectEnd("ulimit -f 100; raytorus trace many.bin -o hits.csv --torus 1,0.25", ExitCode::File,
              {"cannot write \"hits.csv\": file too large"});
    EXPECT_EQ(text("hits.csv"), "old");
    EXPECT_EQ(namesIn(folder).size(), 4U);
}

TEST_F(Reliability, WritesThatFailAtTheEnd) {
    // 0 where a small file could not be closed
    expectEnd(traceTo, ExitCode::File, {"cannot write \"hits.csv\": no space left on device"},
              failing("/.hits.csv.", "FAIL_CLOSE"));
    expectEnd(traceTo, ExitCode::File, {"cannot write \"hits.csv\": read-only file system"},
              failing("hits.csv", "FAIL_RENAME"));
    EXPECT_EQ(text("hits.csv"), "old");
    EXPECT_EQ(namesIn(folder), std::vector<std::string>({"hits.csv", "rays.csv", "ring.json"}));
}

TEST_F(Reliability, OutputsThatAreLinks) {
    std::filesystem::create_symlink("hits.csv", folder / "link.csv");
    std::filesystem::permissions(folder / "hits.csv", std::filesystem::perms(0640));
    // The link was replaced by a file, with other permissions.
    expectEnd("raytorus trace rays.csv -o link.csv --torus 1,0.25", ExitCode::Ok);
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.csv"));
    EXPECT_NE(text("hits.csv"), "old");
    EXPECT_EQ(std::filesystem::status(folder / "hits.csv").permissions(), std::filesystem::perms(0640));
}

TEST_F(Reliability, NamesThatAreLong) {
    const std::string name(251, 'n');
    // 4 from 239 bytes on
    expectEnd(fmt::format("raytorus trace rays.csv -o {}.csv --torus 1,0.25", name), ExitCode::Ok);
    EXPECT_TRUE(std::filesystem::exists(folder / (name + ".csv")));
}

// 10. Numbers that are none.

TEST_F(Reliability, NumbersOnCommandLines) {
    for (const std::string& command : {std::string("raytorus render ring.json -o a.png --repeat 0x2"),
                                       std::string("raytorus render ring.json -o a.png --repeat 010"),
                                       std::string("raytorus render ring.json -o a.png --repeat=-1"),
                                       std::string("raytorus render ring.json -o a.png --repeat 1.5"),
                                       std::string("raytorus render ring.json -o a.png --timeout nan"),
                                       std::string("raytorus render ring.json -o a.png --timeout inf"),
                                       std::string("raytorus render ring.json -o a.png --timeout 0x10"),
                                       std::string("raytorus render ring.json -o a.png --size +-8x8"),
                                       std::string("raytorus render ring.json -o a.png --spp 0x4"),
                                       std::string("raytorus-verify --rays 0x10"),
                                       std::string("raytorus-verify --rays 010"),
                                       std::string("raytorus-verify --seed=-1"),
                                       std::string("raytorus-verify --radius nan"),
                                       std::string("raytorus-verify --distance inf"),
                                       std::string("raytorus-verify --threads 0x2"),
                                       std::string("raytorus-bench --seed=-1"),
                                       std::string("raytorus-bench --seed 0x7"),
                                       std::string("raytorus-bench --rounds 1e1"),
                                       std::string("raytorus-bench --rays 0x1000"),
                                       std::string("raytorus-view ring.json --time nan --frames 1"),
                                       std::string("raytorus-view ring.json --time inf"),
                                       std::string("raytorus-view ring.json --frames 0x1"),
                                       std::string("raytorus trace rays.csv -o hits.csv --torus 1,+-1"),
                                       std::string("raytorus trace rays.csv -o hits.csv --torus nan,1")}) {
        // 0, another number, or no end at all
        expectEnd(command, ExitCode::Usage);
    }
    EXPECT_EQ(text("hits.csv"), "old");
}

// 13. Characters that a terminal obeys.

TEST_F(Reliability, ControlCharactersInFiles) {
    writeText(folder / "rays.csv", "3,0,0,0,-1,0,\x1b[31mred\xff\u009b,inf\n");
    expectEnd(traceTo, ExitCode::File, {"\\u001b[31mred\\xff\\u009b"});
    writeText(folder / "bad.json", "{\"tori\": [], \"\x1b]0;title\\u0007\": 1}");
    const ProgramResult scene = shell("raytorus render bad.json -o a.png");
    EXPECT_EQ(scene.exitCode, static_cast<int>(ExitCode::Scene));
    EXPECT_EQ(scene.err.find('\x1b'), std::string::npos) << scene.err;
    const ProgramResult name = shell("raytorus render \"$(printf 'no\\033[7msuch.json')\" -o a.png");
    EXPECT_EQ(name.exitCode, static_cast<int>(ExitCode::File));
    EXPECT_NE(name.err.find("no\\u001b[7msuch.json"), std::string::npos) << name.err;
}

// 14. Small ones.

TEST_F(Reliability, InputsAreNotOverwritten) {
    expectEnd("raytorus explain --scene ring.json --pixel 3,3 --svg ./ring.json", ExitCode::Usage,
              {"--svg would overwrite"});
    EXPECT_EQ(text("ring.json"), smallScene);
    expectEnd("raytorus trace rays.csv -o ./rays.csv --torus 1,0.25", ExitCode::Usage,
              {"--output would overwrite"});
}

TEST_F(Reliability, AFileIsNotCalledDash) {
    for (const char* command :
         {"raytorus trace rays.csv -o - --torus 1,0.25",
          "raytorus explain --torus 1,0.25 --origin 3,0,0 --direction -1,0,0 --svg -"}) {
        expectEnd(command, ExitCode::Usage, {"not standard output", "./-"});
    }
    expectEnd("raytorus trace rays.csv -o ./- --torus 1,0.25", ExitCode::Ok);
}

TEST_F(Reliability, WhatWasMeant) {
    expectEnd("raytorus rendre ring.json", ExitCode::Usage,
              {"there is no command \"rendre\"; did you mean render?"});
    expectEnd("raytorus render ring.json -o a.png --sise 8x8", ExitCode::Usage,
              {"no option --sise; did you mean --size?"});
    expectEnd("raytorus-verify --ray 10", ExitCode::Usage, {"no option --ray; did you mean --rays?"});
    expectEnd("raytorus-bench --method=x --quik", ExitCode::Usage,
              {"no option --quik; did you mean --quick?"});
    expectEnd("raytorus paint", ExitCode::Usage, {"there is no command \"paint\" (see"});
}

TEST_F(Reliability, TooFewThreads) {
    // 1, with "internal error"
    expectEnd(traceTo + " --method reference", ExitCode::OutOfMemory, {"the system allows no more threads"},
              failing("nothing", "FAIL_THREADS"));
    EXPECT_EQ(text("hits.csv"), "old");
}

TEST_F(Reliability, ARoughnessOfNothing) {
    writeText(
        folder / "ring.json",
        R"({"materials": {"m": {"roughness": 1e-300}}, "tori": [{"majorRadius": 1, "minorRadius": 0.25, "material": "m"}]})");
    expectEnd("raytorus render ring.json -o a.png --method reference", ExitCode::Scene,
              {"/materials/m/roughness"});
}

// 12. Text without end in a message.
TEST_F(Reliability, LongFieldsAreCut) {
    writeText(folder / "rays.csv", "3,0,0,0,-1,0," + std::string(60'000, 'x') + ",inf\n");
    const ProgramResult result = shell(traceTo);
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::File));
    EXPECT_LT(result.err.size(), 400U) << result.err;
    EXPECT_NE(result.err.find("xxx...\""), std::string::npos) << result.err;
}

}  // namespace
}  // namespace raytorus::test
