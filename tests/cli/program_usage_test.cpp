// SPDX-License-Identifier: MIT
// Wrong command lines: exit code 5, a line that says what is wrong, and which --help tells more.
#include "support/program_test.hpp"

namespace raytorus::test {
namespace {

struct WrongLine {
    const char* name;
    std::vector<std::string> arguments;
    std::vector<std::string> words;
};

void PrintTo(const WrongLine& line, std::ostream* stream) {
    *stream << line.name;
}

class ProgramUsage : public ProgramTest, public testing::WithParamInterface<WrongLine> {};

TEST_P(ProgramUsage, IsRefused) {
    write("scene.json", smallScene);
    write("rays.csv", "3,0,0,0,-1,0,0,inf\n");
    // Found without a look at the device.
    expectFailure(GetParam().arguments, ExitCode::Usage, GetParam().words, noDriver());
}

std::vector<std::string> render(std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "scene.json", "-o", "out.png"});
    return options;
}

std::vector<std::string> trace(std::vector<std::string> options) {
    options.insert(options.begin(), {"trace", "rays.csv", "-o", "out.csv"});
    return options;
}

const WrongLine wrongLines[] = {
    {"NoCommand", {}, {"a command is missing", "render", "doctor", "raytorus --help"}},
    {"UnknownCommand", {"paint", "scene.json"}, {"there is no command \"paint\"", "raytorus --help"}},
    {"UnknownOption", {"--paint"}, {"there is no option --paint", "raytorus --help"}},
    {"NoScene", {"render", "-o", "out.png"}, {"scene is required", "raytorus render --help"}},
    {"NoPicture", {"render", "scene.json"}, {"--output is required", "raytorus render --help"}},
    {"NoPictureName", {"render", "scene.json", "-o"}, {"--output", "raytorus render --help"}},
    {"UnknownRenderOption", render({"--paint"}), {"there is no option --paint", "raytorus render --help"}},
    {"UnknownRenderOptionAlone",
     {"render", "--paint"},
     {"there is no option --paint", "raytorus render --help"}},
    {"TwoScenes", render({"other.json"}), {"\"other.json\" is one argument too many"}},
    {"TwoSizes", render({"--size", "8x8", "--size", "9x9"}), {"--size"}},
    {"NoHeight", render({"--size", "8"}), {"--size", "WIDTHxHEIGHT", "\"8\""}},
    {"ZeroWidth", render({"--size", "0x8"}), {"--size", "1 to 16384", "\"0x8\""}},
    {"NegativeHeight", render({"--size", "8x-8"}), {"--size", "\"8x-8\""}},
    {"WideSize", render({"--size", "16385x8"}), {"--size", "1 to 16384", "\"16385x8\""}},
    {"SamplesNotSquare", render({"--spp", "2"}), {"--spp", "square number", "\"2\""}},
    {"NoSamples", render({"--spp", "0"}), {"--spp", "\"0\""}},
    {"SamplesNegative", render({"--spp", "-4"}), {"--spp", "\"-4\""}},
    {"SamplesTooMany", render({"--spp", "4225"}), {"--spp", "4096", "\"4225\""}},
    {"SamplesNoNumber", render({"--spp", "four"}), {"--spp", "\"four\""}},
    {"UnknownRoute", render({"--route", "raster"}), {"--route", "fragment or compute", "\"raster\""}},
    {"RouteByNumber", render({"--route", "1"}), {"--route", "\"1\""}},
    {"UnknownStats", render({"--stats", "xml"}), {"--stats", "text or json", "\"xml\""}},
    {"StatsWithoutValue", render({"--stats"}), {"--stats"}},
    {"NoRepeat", render({"--repeat", "0"}), {"--repeat", "0"}},
    {"TimeoutZero", render({"--timeout", "0"}), {"--timeout", "0"}},
    {"TimeoutNoNumber", render({"--timeout", "soon"}), {"--timeout", "soon"}},
    {"PictureOfUnknownFormat",
     {"render", "scene.json", "-o", "out.jpg"},
     {"--output", ".exr or .png", "\"out.jpg\""}},
    {"PictureWithoutFormat", {"render", "scene.json", "-o", "out"}, {"--output", ".exr or .png", "\"out\""}},
    {"NoRays",
     {"trace", "-o", "out.csv", "--torus", "1,0.25"},
     {"rays is required", "raytorus trace --help"}},
    {"NoTorus", trace({}), {"--torus is required", "raytorus trace --help"}},
    {"NoHits", {"trace", "rays.csv", "--torus", "1,0.25"}, {"--output is required"}},
    {"OneRadius", trace({"--torus", "1"}), {"--torus", "R,r", "\"1\""}},
    {"ThreeRadii", trace({"--torus", "1,2,3"}), {"--torus", "R,r", "\"1,2,3\""}},
    {"NegativeMajorRadius", trace({"--torus", "-1,0.25"}), {"--torus", "R >= 0", "\"-1,0.25\""}},
    {"NoMinorRadius", trace({"--torus", "1,0"}), {"--torus", "r > 0", "\"1,0\""}},
    {"InfiniteRadius", trace({"--torus", "inf,1"}), {"--torus", "\"inf,1\""}},
    {"RadiusIsNan", trace({"--torus", "1,nan"}), {"--torus", "\"1,nan\""}},
    {"AllAndAny", trace({"--torus", "1,0.25", "--all", "--any"}), {"--all", "--any"}},
    {"HitsOverRays",
     {"trace", "rays.csv", "-o", "./rays.csv", "--torus", "1,0.25"},
     {"--output would overwrite", "rays.csv"}},
    {"OneImage", {"compare", "a.exr"}, {"ACTUAL is required", "raytorus compare --help"}},
    {"NegativeTolerance", {"compare", "a.exr", "b.exr", "--tolerance", "-1"}, {"not \"-1\""}},
    {"DoctorWithArgument", {"doctor", "now"}, {"\"now\" is one argument too many", "raytorus doctor --help"}},
};

INSTANTIATE_TEST_SUITE_P(Lines, ProgramUsage, testing::ValuesIn(wrongLines),
                         [](const testing::TestParamInfo<WrongLine>& line) { return line.param.name; });

}  // namespace
}  // namespace raytorus::test
