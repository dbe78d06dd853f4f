// SPDX-License-Identifier: MIT
// raytorus render --stats: the numbers of docs/cli.md, and that they fit together.
#include <nlohmann/json.hpp>
#include <set>

#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

using Json = nlohmann::json;

std::set<std::string> keysOf(const Json& object) {
    std::set<std::string> keys;
    for (const auto& [key, value] : object.items()) {
        keys.insert(key);
    }
    return keys;
}

const std::set<std::string> keys = {"device",
                                    "driver",
                                    "route",
                                    "width",
                                    "height",
                                    "samplesPerPixel",
                                    "seconds",
                                    "pixels",
                                    "nanosecondsPerPixel",
                                    "cameraRaysPerSecond",
                                    "speedOf"};
const std::set<std::string> secondsKeys = {"scene",    "instance", "pipeline", "firstBand",     "render",
                                           "readBack", "write",    "total",    "renderOnDevice"};

class ProgramStats : public ProgramTest {
protected:
    ProgramStats() { write("scene.json", smallScene); }

    [[nodiscard]] Json stats(const std::string& size, const std::string& route,
                             Arguments options = {}) const {
        options.insert(options.begin(), {"render", "scene.json", "-o", "out.exr", "--size", size, "--route",
                                         route, "--stats", "json"});
        return Json::parse(expectOk(options));
    }
};

TEST_F(ProgramStats, JsonHasTheDocumentedKeys) {
    const Json once = stats("40x30", "compute");
    EXPECT_EQ(keysOf(once), keys);
    EXPECT_EQ(keysOf(once.at("seconds")), secondsKeys);
    EXPECT_EQ(keysOf(once.at("pixels")), (std::set<std::string>{"firstBand", "render"}));
    std::set<std::string> withRepeat = secondsKeys;
    withRepeat.insert("fastestRepeat");
    EXPECT_EQ(keysOf(stats("40x30", "compute", {"--repeat", "2"}).at("seconds")), withRepeat);

    const std::string documentation = fileText(RAYTORUS_SOURCE_DIR "/docs/cli.md");
    for (const std::set<std::string>& group : {keys, withRepeat}) {
        for (const std::string& key : group) {
            EXPECT_NE(documentation.find("`" + key + "`"), std::string::npos) << key;
        }
    }
}

TEST_F(ProgramStats, JsonSaysWhatWasRendered) {
    const Json json = stats("40x30", "compute", {"--spp", "4"});
    EXPECT_EQ(json.at("route"), "compute");
    EXPECT_EQ(json.at("width"), 40);
    EXPECT_EQ(json.at("height"), 30);
    EXPECT_EQ(json.at("samplesPerPixel"), 4);
    EXPECT_NE(expectOk({"doctor"}).find(json.at("device").get<std::string>()), std::string::npos);
    EXPECT_EQ(stats("40x30", "fragment").at("route"), "fragment");
}

// The speed is that of `pixels` pixels in `seconds` seconds.
void expectSpeed(const Json& json, double pixels, double seconds, const char* of) {
    // Relative: some roundings of double.
    EXPECT_NEAR(json.at("nanosecondsPerPixel").get<double>() / (1e9 * seconds / pixels), 1.0, 1e-12);
    EXPECT_NEAR(json.at("cameraRaysPerSecond").get<double>() / (4.0 * pixels / seconds), 1.0, 1e-12);
    EXPECT_EQ(json.at("speedOf"), of);
}

// A size that is rendered in one band, and one that needs more; once, and again.
TEST_F(ProgramStats, NumbersFitTogether) {
    for (const auto& [size, pixels, oneBand] :
         {std::tuple("40x30", 1200, true), std::tuple("512x512", 262144, false)}) {
        for (const bool again : {false, true}) {
            const Json json =
                stats(size, again ? "compute" : "fragment", {"--spp", "4", "--repeat", again ? "3" : "1"});
            SCOPED_TRACE(json.dump(2));
            const Json& seconds = json.at("seconds");
            const std::int64_t firstPixels = json.at("pixels").at("firstBand");
            const std::int64_t otherPixels = json.at("pixels").at("render");
            EXPECT_GT(firstPixels, 0);
            EXPECT_EQ(otherPixels == 0, oneBand);
            EXPECT_EQ(firstPixels + otherPixels, pixels);
            EXPECT_EQ(seconds.at("render") == 0.0, oneBand);
            EXPECT_GE(seconds.at("renderOnDevice"), 0.0);
            double sum = 0.0;
            for (const char* part : {"scene", "instance", "pipeline", "firstBand", "readBack", "write"}) {
                EXPECT_GT(seconds.at(part), 0.0) << part;
                sum += seconds.at(part).get<double>();
            }
            EXPECT_LE(sum + seconds.at("render").get<double>(), seconds.at("total"));
            if (again) {
                EXPECT_GT(seconds.at("fastestRepeat"), 0.0);
                expectSpeed(json, pixels, seconds.at("fastestRepeat"), "fastest repeat");
            } else if (oneBand) {
                expectSpeed(json, pixels, seconds.at("firstBand"), "one band, compiling included");
            } else {
                expectSpeed(json, static_cast<double>(otherPixels), seconds.at("render"),
                            "bands after the first");
            }
        }
    }
}

TEST_F(ProgramStats, RepeatGivesTheSamePicture) {
    expectOk({"render", "scene.json", "-o", "once.exr"});
    expectOk({"render", "scene.json", "-o", "again.exr", "--repeat", "3"});
    EXPECT_TRUE(fileText(folder / "once.exr") == fileText(folder / "again.exr"));
}

TEST_F(ProgramStats, TextNamesTheParts) {
    const std::string text =
        expectOk({"render", "scene.json", "-o", "out.png", "--spp", "4", "--stats", "text"});
    for (const char* word : {"fragment route, 24x16, 4 sample(s) a pixel", "scene ", "instance ", "pipeline ",
                             "first band ", "384 pixels", "read back ", "write ", "total ", " ms",
                             "ns a pixel", "million camera rays a second"}) {
        EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
    }
}

}  // namespace
}  // namespace raytorus::test
