// SPDX-License-Identifier: MIT
// raytorus render --time and --frames: the moments of an animated scene, one by one and all in one process.
#include <set>

#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

// A turn takes 4 s; half of it the tori are out of the picture.
constexpr const char* turningScene = R"({
    "image": {"width": 30, "height": 20},
    "camera": {"position": [6, -9, 3], "target": [6, 0, 0]},
    "tori": [{"majorRadius": 1, "minorRadius": 0.25, "translation": [6, 0, 0],
              "rotation": {"axis": [1, 0, 0], "degrees": 50}},
             {"majorRadius": 0.5, "minorRadius": 0.25, "translation": [5, 2, 0.5]}],
    "animation": {"turntable": {"secondsPerTurn": 4}}})";

class ProgramFrames : public ProgramTest {
protected:
    ProgramFrames() {
        write("scene.json", turningScene);
        write("still.json", smallScene);
    }

    // Its bytes.
    [[nodiscard]] std::string render(const std::string& output, Arguments options = {}) const {
        options.insert(options.begin(), {"render", "scene.json", "-o", output, "--validate"});
        EXPECT_EQ(expectOk(options), "");
        return output.find('#') == std::string::npos ? fileText(folder / output) : "";
    }

    [[nodiscard]] std::string frame(const std::string& name) const { return fileText(folder / name); }
};

TEST_F(ProgramFrames, AtTime0AndAfterWholeTurnsThePictureIsThatOfTheScene) {
    const std::string still = render("still.exr");
    EXPECT_EQ(render("zero.exr", {"--time", "0"}), still);
    EXPECT_EQ(render("turn.exr", {"--time", "4"}), still);
    EXPECT_EQ(render("back.exr", {"--time", "-12"}), still);
    EXPECT_NE(render("moved.exr", {"--time", "0.1"}), still);
    EXPECT_EQ(picture("turn.exr").pixels, picture("still.exr").pixels);
}

TEST_F(ProgramFrames, EachIsThePictureOfItsMoment) {
    for (const char* route : {"fragment", "compute"}) {
        std::ignore = render("#.exr", {"--frames", "9", "--fps", "2", "--route", route});
        std::set<std::string> different;
        for (char number = '0'; number < '9'; ++number) {
            different.insert(frame(std::string(1, number) + ".exr"));
        }
        EXPECT_GE(different.size(), 5U) << "the others show the background alone";
        EXPECT_TRUE(frame("8.exr") == frame("0.exr")) << "a whole turn";
        EXPECT_TRUE(frame("1.exr") == render("a.exr", {"--time", "0.5", "--route", route}));
        EXPECT_TRUE(frame("7.exr") == render("b.exr", {"--time", "3.5", "--route", route}));
    }
}

TEST_F(ProgramFrames, ThereAreNoOtherFiles) {
    std::filesystem::create_directory(folder / "out");
    std::ignore = render("out/#.png", {"--frames", "3", "--fps", "10"});
    EXPECT_EQ(namesIn(folder / "out"), (std::vector<std::string>{"0.png", "1.png", "2.png"}));
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"out", "scene.json", "still.json"}));
}

TEST_F(ProgramFrames, TimeIsThatOfTheFirst) {
    std::ignore = render("#.exr", {"--frames", "2", "--fps", "4", "--time", "1.25"});
    EXPECT_TRUE(frame("0.exr") == render("a.exr", {"--time", "1.25"}));
    EXPECT_TRUE(frame("1.exr") == render("b.exr", {"--time", "1.5"}));
}

TEST_F(ProgramFrames, OtherMethodsAndTheReferenceDrawThemToo) {
    for (const char* method : {"bracketed-newton", "reference"}) {
        const Arguments common = {"--size", "12x8", "--method", method};
        Arguments sequence = {"render", "scene.json", "-o", "#.png", "--frames", "2", "--fps", "8"};
        Arguments single = {"render", "scene.json", "-o", "b.png", "--time", "0.125"};
        for (Arguments* arguments : {&sequence, &single}) {
            arguments->insert(arguments->end(), common.begin(), common.end());
            expectOk(*arguments);
        }
        EXPECT_TRUE(frame("1.png") == frame("b.png")) << method;
        EXPECT_FALSE(frame("1.png") == frame("0.png")) << method;
    }
}

TEST_F(ProgramFrames, ReplaceWhatWasThereBefore) {
    write("1.png", "what was there before");
    std::ignore = render("#.png", {"--frames", "2", "--fps", "1"});
    EXPECT_EQ(picture("1.png").width, 30);
}

TEST_F(ProgramFrames, HashesWithoutFramesAreACharacter) {
    std::ignore = render("a##.png");
    EXPECT_EQ(picture("a##.png").width, 30);
}

TEST_F(ProgramFrames, SceneThatStandsStillIsRefused) {
    const std::vector<std::string> words = {"still.json has no animation", "--time"};
    expectFailure({"render", "still.json", "-o", "a.png", "--time", "0"}, ExitCode::Usage, words, noDriver());
    expectFailure({"render", "still.json", "-o", "#.png", "--frames", "2", "--fps", "1"}, ExitCode::Usage,
                  words, noDriver());
}

TEST_F(ProgramFrames, WrongOptionsAreRefused) {
    const auto expectRefused = [this](Arguments options, const std::vector<std::string>& words) {
        options.insert(options.begin(), {"render", "scene.json"});
        expectFailure(options, ExitCode::Usage, words, noDriver());
    };
    expectRefused({"-o", "a.png", "--time", "soon"}, {"--time", "\"soon\""});
    expectRefused({"-o", "a.png", "--frames", "2", "--fps", "1"}, {"run of #", "\"a.png\""});
    expectRefused({"-o", "#.png", "--frames", "2"}, {"--frames needs --fps"});
    expectRefused({"-o", "#.png", "--fps", "2"}, {"--fps needs --frames"});
    expectRefused({"-o", "#.jpg", "--frames", "2", "--fps", "1"}, {".exr or .png"});
    expectRefused({"-o", "#.png", "--frames", "2", "--fps", "1", "--stats", "text"}, {"--stats", "--frames"});
    expectRefused({"-o", "#.png", "--frames", "2", "--fps", "1", "--repeat", "3"}, {"--repeat", "--frames"});
}

// Seen before anything is drawn, although it is the last file.
TEST_F(ProgramFrames, FileThatCannotBeWritten) {
    std::filesystem::create_directory(folder / "2.png");
    expectFailure({"render", "scene.json", "-o", "#.png", "--frames", "3", "--fps", "1"}, ExitCode::File,
                  {"\"2.png\"", "it is a directory"}, noDriver());
    expectFailure({"render", "scene.json", "-o", "missing/#.png", "--frames", "3", "--fps", "1"},
                  ExitCode::File, {"missing/0.png", "no such file or directory"}, noDriver());
}

// As on a disk that is full by then: the first pictures show the background alone and are small.
TEST_F(ProgramFrames, ErrorsOfTheWriterEndTheRun) {
    write("5.png", "what was there before");
    ProgramSettings settings;
    settings.folder = folder;
    settings.environment = {{"MESA_SHADER_CACHE_DISABLE", "true"}};  // the limit is not for those files
    // 12 blocks of 512 bytes. A write beyond that fails instead of ending the program by a signal.
    const ProgramResult result = runProgram(
        "/bin/sh",
        {"-c", "trap '' XFSZ; ulimit -f 12; exec \"$0\" \"$@\"", RAYTORUS_PROGRAM, "render", "scene.json",
         "-o", "#.png", "--time", "1.5", "--frames", "9", "--fps", "2", "--size", "240x160"},
        settings);
    EXPECT_EQ(result.exitCode, static_cast<int>(ExitCode::File)) << testing::PrintToString(result);
    EXPECT_TRUE(result.err.starts_with("raytorus: cannot write \"")) << result.err;
    EXPECT_NE(result.err.find(".png\": file too large\n"), std::string::npos) << result.err;
    const char failed = result.err.at(result.err.find(".png") - 1);
    EXPECT_GT(failed, '0') << "no picture was small enough";
    EXPECT_LT(failed, '8');
    // Those before it are whole, of it and those after it there is nothing new.
    for (char number = '0'; number < '9'; ++number) {
        const std::string name = std::string(1, number) + ".png";
        if (number < failed) {
            EXPECT_EQ(picture(name).width, 240);
        } else if (number == '5') {
            EXPECT_EQ(frame(name), "what was there before");
        } else {
            EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
        }
    }
    for (const std::string& name : namesIn(folder)) {
        EXPECT_FALSE(name.starts_with('.')) << name;
    }
}

}  // namespace
}  // namespace raytorus::test
