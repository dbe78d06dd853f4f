// SPDX-License-Identifier: MIT
#include "window_test.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "compare/compare.hpp"
#include "image/image_io.hpp"

namespace raytorus::test {
namespace {

std::unique_ptr<Display>& sharedDisplay() {
    static std::unique_ptr<Display> instance;
    return instance;
}

// Before the sanitizers look for leaks.
class TakeDownDisplay : public testing::Environment {
    void TearDown() override { sharedDisplay().reset(); }
};

[[maybe_unused]] const testing::Environment* const registered =
    testing::AddGlobalTestEnvironment(new TakeDownDisplay);

bool inContinuousIntegration() {
    const char* value = std::getenv("CI");
    return value != nullptr && std::string(value) == "true";
}

}  // namespace

Display& WindowTest::display() {
    if (!sharedDisplay()) {
        sharedDisplay() = std::make_unique<Display>(std::filesystem::path(RAYTORUS_TEST_OUTPUT_DIR) /
                                                    fmt::format("display-{}.txt", getpid()));
    }
    return *sharedDisplay();
}

void WindowTest::SetUp() {
    if (const auto missing = missingForWindows()) {
        if (inContinuousIntegration()) {
            FAIL() << *missing;
        }
        GTEST_SKIP() << *missing;
    }
    display();
}

void WindowTest::TearDown() {
    if (viewer && !HasFailure()) {
        ADD_FAILURE() << "the viewer was not closed";
    }
}

void WindowTest::giveUp(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}\nevents:\n{}\nstandard error: {}", what, fmt::join(lines, "\n"),
                                         viewer ? viewer->errorText() : ""));
}

void WindowTest::start(const Arguments& arguments, const Environment& environment) {
    ProgramSettings settings;
    settings.folder = folder;
    settings.environment = environment;
    settings.environment.emplace("DISPLAY", display().name());
    Arguments all = arguments;
    all.insert(all.end(), {"--events", "--validate"});
    lines.clear();
    viewer = std::make_unique<LiveProcess>(RAYTORUS_VIEW, all, settings, folder / "errors.txt");
}

void WindowTest::open(const Arguments& arguments, const Environment& environment) {
    start(arguments, environment);
    await("open");
    window = display().window();
    hand({"windowfocus", "--sync", std::to_string(window)});
    await("settled");
}

WindowTest::Json WindowTest::nextEvent(LiveProcess::Clock::time_point deadline) {
    std::optional<std::string> line;
    try {
        line = viewer->readLine(deadline);
    } catch (const std::runtime_error& error) {
        giveUp(error.what());
    }
    if (!line) {
        giveUp("the viewer has closed its standard output");
    }
    lines.push_back(*line);
    Json event = Json::parse(*line, nullptr, false);
    if (!event.is_object() || !event.contains("event")) {
        giveUp("this is no event: " + *line);
    }
    if (event["event"] == "camera") {
        lastCamera = event;
    }
    return event;
}

WindowTest::Json WindowTest::await(const std::string& name, const std::function<bool(const Json&)>& accepts) {
    const auto deadline = LiveProcess::Clock::now() + LiveProcess::patience;
    try {
        for (;;) {
            Json event = nextEvent(deadline);
            if (event["event"] == name && accepts(event)) {
                return event;
            }
        }
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("waiting for \"{}\": {}", name, error.what()));
    }
}

WindowTest::Json WindowTest::await(const std::string& name) {
    return await(name, [](const Json&) { return true; });
}

void WindowTest::press(std::initializer_list<std::string> keys) {
    Arguments words = {"key"};
    words.insert(words.end(), keys);
    hand(words);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        await("key");
    }
}

void WindowTest::pressAndSettle(std::initializer_list<std::string> keys) {
    press(keys);
    await("settled");
}

void WindowTest::drag(int button, std::initializer_list<std::pair<int, int>> places,
                      const std::string& held) {
    Arguments words;
    const auto add = [&words](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
    if (!held.empty()) {
        add({"keydown", held});
    }
    bool pressed = false;
    for (const auto& [x, y] : places) {
        add({"mousemove", std::to_string(x), std::to_string(y)});
        if (!std::exchange(pressed, true)) {
            add({"mousedown", std::to_string(button)});
        }
    }
    add({"mouseup", std::to_string(button)});
    if (!held.empty()) {
        add({"keyup", held});
    }
    hand(words);
}

void WindowTest::resize(int width, int height) {
    hand({"windowsize", std::to_string(window), std::to_string(width), std::to_string(height)});
}

image::Image WindowTest::screenshot(const std::string& key) {
    press({key});
    return image::readImage(folder / await("screenshot")["file"].get<std::string>());
}

std::string WindowTest::expectEnd(ExitCode code) {
    if (!viewer) {
        ADD_FAILURE() << "no viewer was started";
        return {};
    }
    const auto deadline = LiveProcess::Clock::now() + LiveProcess::patience;
    while (const auto line = viewer->readLine(deadline)) {
        lines.push_back(*line);
    }
    const int status = viewer->wait();
    std::string errors = viewer->errorText();
    EXPECT_EQ(status, static_cast<int>(code))
        << errors << fmt::format("\nevents:\n{}", fmt::join(lines, "\n"));
    if (code == ExitCode::Ok) {
        EXPECT_EQ(errors, "");
        EXPECT_FALSE(lines.empty());
        EXPECT_EQ(lines.back(), R"({"event":"closed"})");
    } else {
        EXPECT_TRUE(errors.starts_with("raytorus-view: ") && errors.ends_with('\n')) << errors;
        EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
    }
    viewer.reset();
    return errors;
}

void WindowTest::close() {
    press({"q"});
    expectEnd();
}

ProgramResult WindowTest::runViewer(const Arguments& arguments, const Environment& environment) const {
    ProgramSettings settings;
    settings.folder = folder;
    settings.environment = environment;
    settings.environment.emplace("DISPLAY", display().name());
    return runProgram(RAYTORUS_VIEW, arguments, settings);
}

std::string WindowTest::runRaytorus(const Arguments& arguments) const {
    ProgramSettings settings;
    settings.folder = folder;
    const ProgramResult result = runProgram(RAYTORUS_PROGRAM, arguments, settings);
    EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(result);
    return result.out;
}

image::Image WindowTest::rendered(const Arguments& arguments, const std::string& file) const {
    Arguments all = {"render", "-o", file};
    all.insert(all.end(), arguments.begin(), arguments.end());
    runRaytorus(all);
    return image::readImage(folder / file);
}

std::string WindowTest::scene(const std::string& name) {
    return RAYTORUS_SOURCE_DIR "/scenes/" + name + ".json";
}

testing::AssertionResult sameBits(const image::Image& expected, const image::Image& actual) {
    const compare::Comparison comparison = compare::compare(expected, actual, {});
    if (comparison.verdict == compare::Verdict::Identical) {
        return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << comparison.sentence;
}

double largestCodeDifference(const image::Image& expected, const image::Image& actual) {
    if (expected.width != actual.width || expected.height != actual.height) {
        ADD_FAILURE() << fmt::format("{} x {} against {} x {}", expected.width, expected.height, actual.width,
                                     actual.height);
        return 255.0;
    }
    double largest = 0.0;
    for (int y = 0; y < expected.height; ++y) {
        for (int x = 0; x < expected.width; ++x) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const double difference = std::abs(static_cast<double>(expected.pixel(x, y)[channel]) -
                                                   static_cast<double>(actual.pixel(x, y)[channel]));
                largest = std::max(largest, 255.0 * difference);
            }
        }
    }
    return largest;
}

}  // namespace raytorus::test
