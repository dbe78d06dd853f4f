// SPDX-License-Identifier: MIT
#include "options/frame_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/parse_number.hpp"

namespace raytorus::options {
namespace {

constexpr int maxFrames = 1'000'000;

[[noreturn]] void fail(const std::string& sentence) {
    throw Error(ExitCode::Usage, sentence);
}

double timeOf(const std::string& text) {
    const auto seconds = text.empty() ? std::optional(0.0) : parseNumber<double>(text);
    if (!seconds || !std::isfinite(*seconds)) {
        fail(fmt::format("--time takes a number of seconds, not \"{}\"", text));
    }
    return *seconds;
}

double rateOf(const std::string& text) {
    const auto rate = parseNumber<double>(text);
    if (!rate || !(*rate > 0.0 && std::isfinite(*rate))) {
        fail(fmt::format("--fps takes a positive number of frames a second, not \"{}\"", text));
    }
    return *rate;
}

int countOf(const std::string& text) {
    const auto count = parseNumber<int>(text);
    if (!count || *count < 1 || *count > maxFrames) {
        fail(fmt::format("--frames takes a number from 1 to {}, not \"{}\"", maxFrames, text));
    }
    return *count;
}

// The one place for the number.
struct Pattern {
    std::string before;
    std::size_t digits;
    std::string after;

    [[nodiscard]] std::string name(int number) const {
        return fmt::format("{}{:0{}}{}", before, number, digits, after);
    }
};

Pattern patternOf(const std::string& output) {
    const std::size_t nameStart = output.find_last_of('/') + 1;  // 0 without a folder
    const std::size_t first = output.find('#', nameStart);
    if (first == std::string::npos) {
        fail(
            fmt::format("--frames needs a run of # for the number in the file's name, as in "
                        "frame-####.png, not \"{}\"",
                        output));
    }
    const std::size_t end = std::min(output.find_first_not_of('#', first), output.size());
    if (output.find('#', end) != std::string::npos) {
        fail(fmt::format("--frames needs one run of # in the file's name, and \"{}\" has more", output));
    }
    return {output.substr(0, first), end - first, output.substr(end)};
}

}  // namespace

void addFrameOptions(CLI::App& command, FrameOptions& options) {
    command.add_option("--time", options.time, "The moment of an animated scene, or of the first frame")
        ->option_text("SECONDS [0]");
    command
        .add_option("--frames", options.count,
                    "Render so many pictures, numbered from 0 where the name of the file has ####")
        ->option_text("N");
    command.add_option("--fps", options.rate, "Frames a second of the scene's time, with --frames")
        ->option_text("F");
}

std::vector<SequenceFrame> framesOf(const FrameOptions& options, const std::string& output) {
    const double start = timeOf(options.time);
    if (!options.sequence()) {
        if (!options.rate.empty()) {
            fail("--fps needs --frames");
        }
        return {{output, start}};
    }
    if (options.rate.empty()) {
        fail("--frames needs --fps");
    }
    const int count = countOf(options.count);
    const double rate = rateOf(options.rate);
    const Pattern pattern = patternOf(output);
    const std::string last = std::to_string(count - 1);
    if (last.size() > pattern.digits) {
        fail(fmt::format("the {} # in \"{}\" have no room for the number {} of the last frame",
                         pattern.digits, output, last));
    }
    std::vector<SequenceFrame> frames;
    for (int k = 0; k < count; ++k) {
        frames.push_back({pattern.name(k), start + k / rate});
    }
    if (!std::isfinite(frames.back().seconds)) {
        fail(fmt::format("--time and --fps lead to no time for frame {}", last));
    }
    return frames;
}

}  // namespace raytorus::options
