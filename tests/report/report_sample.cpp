// SPDX-License-Identifier: MIT
#include "report_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "image/channels.hpp"

namespace raytorus::test {
namespace {

using image::Image;

constexpr int width = 48;
constexpr int height = 32;
constexpr double pixelSize = 2.75 / height;  // the ring's major radius is 1

using image::ChannelKind;

const std::vector<std::string> valueNames =
    image::channelsOf({ChannelKind::Color, ChannelKind::Alpha, ChannelKind::Geometry});

// From the middle of a pixel to the circle in the middle of the tube, outwards.
struct Place {
    double angle = 0.0;
    double across = 0.0;
};

Place placeOf(int x, int y) {
    const double right = (x + 0.5 - width / 2.0) * pixelSize;
    const double up = (height / 2.0 - y - 0.5) * pixelSize;
    return {std::atan2(up, right), std::hypot(right, up) - 1.0};
}

// One of the three colours of a hue, 0 to 1.
double primary(double hue, double phase) {
    return 0.5 + 0.5 * std::cos(2.0 * std::numbers::pi * (hue + phase));
}

void fillPixel(Image& picture, int x, int y, double minorRadius, double hue, double turn) {
    const auto set = [&](const std::string& channel, double value) {
        picture.at(x, y, channel) = static_cast<float>(value);
    };
    set("A", 1.0);
    const Place place = placeOf(x, y);
    const bool hit = std::abs(place.across) < minorRadius;
    set("id", hit ? 0.0 : -1.0);
    if (!hit) {
        const double sky = 0.10 + 0.10 * y / height;
        set("R", sky);
        set("G", sky);
        set("B", 1.3 * sky);
        return;
    }
    const double z = std::sqrt(minorRadius * minorRadius - place.across * place.across);
    const double slope = place.across / minorRadius;
    const double u = place.angle / (2.0 * std::numbers::pi);
    const double v = std::atan2(z, place.across) / (2.0 * std::numbers::pi);
    set("t", 4.0 - z);
    set("position.x", (1.0 + place.across) * std::cos(place.angle));
    set("position.y", (1.0 + place.across) * std::sin(place.angle));
    set("position.z", z);
    set("normal.x", slope * std::cos(place.angle));
    set("normal.y", slope * std::sin(place.angle));
    set("normal.z", z / minorRadius);
    set("uv.u", u < 0.0 ? u + 1.0 : u);
    set("uv.v", v);
    set("count", 2.0);
    const bool dark = (static_cast<int>(std::floor(16.0 * (u + 1.0 + turn))) + (v < 0.25 ? 1 : 0)) % 2 == 0;
    const double light =
        (0.15 + 0.85 * std::max(0.0, 0.6 * z / minorRadius - 0.5 * slope * std::cos(place.angle - 2.2))) *
        (dark ? 0.55 : 1.0);
    set("R", light * (0.25 + 0.75 * primary(hue, 0.0)));
    set("G", light * (0.25 + 0.75 * primary(hue, 2.0 / 3.0)));
    set("B", light * (0.25 + 0.75 * primary(hue, 1.0 / 3.0)));
}

struct Sample {
    std::string name;
    std::string catches;
    std::optional<Image> expected;
    std::optional<Image> actual;
    std::string sentence;  // where there is nothing to compare
    std::string verdict;
};

report::ReportCase caseOf(Sample sample) {
    report::ReportCase reported;
    if (sample.expected && sample.actual) {
        compare::CompareRules rules;
        rules.allowedFlips = 16;
        const compare::Comparison comparison = compare::compare(*sample.expected, *sample.actual, rules);
        reported = report::reportCase(sample.name, *sample.expected, *sample.actual, comparison);
    } else {
        reported.name = sample.name;
        reported.expected = std::move(sample.expected);
        reported.actual = std::move(sample.actual);
        reported.sentence = std::move(sample.sentence);
        reported.verdict = std::move(sample.verdict);
    }
    reported.catches = std::move(sample.catches);
    reported.explainCommand =
        fmt::format("raytorus explain --scene 'my {{x}},{{y}}/{}.json' --pixel {{x}},{{y}}", reported.name);
    reported.rerunCommand = fmt::format("raytorus golden check {}", reported.name);
    reported.renewCommand = fmt::format("raytorus golden renew {} --reason \"...\"", reported.name);
    reported.seconds = 0.125;
    return reported;
}

// What rounding leaves of a right answer: each position and t off by a part of its tolerance.
Image rounded(Image picture) {
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            picture.at(x, y, "t") += 1e-6f * static_cast<float>((x * 7 + y * 3) % 5 - 2) / 5.0f;
            picture.at(x, y, "position.x") += 1e-6f * static_cast<float>((x + 5 * y) % 7 - 3) / 5.0f;
        }
    }
    return picture;
}

void makeMiss(Image& picture, int x, int y) {
    Image empty(width, height, valueNames);
    fillPixel(empty, x, y, 0.0, 0.0, 0.0);
    std::ranges::copy(empty.pixel(x, y), picture.pixel(x, y).begin());
}

// Pixels on the outline that were hit and are missed.
Image withFlips(Image picture, double minorRadius, int flips) {
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double edge = minorRadius - std::abs(placeOf(x, y).across);
            if (flips > 0 && edge > 0.0 && edge < 0.2 * pixelSize && (x + y) % 3 == 0) {
                makeMiss(picture, x, y);
                --flips;
            }
        }
    }
    return picture;
}

Image shifted(const Image& picture) {
    Image moved = picture;
    std::rotate(moved.pixels.begin(), moved.pixels.end() - picture.channelCount(), moved.pixels.end());
    return moved;
}

// A ring with a hole where there should be none.
Image withHole(Image picture) {
    for (int y = 9; y < 13; ++y) {
        for (int x = 30; x < 35; ++x) {
            makeMiss(picture, x, y);
        }
    }
    return picture;
}

Image withNan(Image picture) {
    picture.at(34, 20, "normal.x") = std::numeric_limits<float>::quiet_NaN();
    picture.at(34, 20, "R") = std::numeric_limits<float>::quiet_NaN();
    return picture;
}

// The last bits of t, some ulp too many on one side of the picture.
Image withDrift(Image picture) {
    for (int y = 0; y < height; ++y) {
        for (int x = width / 2; x < width; ++x) {
            picture.at(x, y, "t") *= 1.0f + 4e-7f * static_cast<float>(x - width / 2) / 8.0f;
        }
    }
    return picture;
}

}  // namespace

Image sampleRing(double minorRadius, double hue, double turn) {
    Image picture(width, height, valueNames);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            fillPixel(picture, x, y, minorRadius, hue, turn);
        }
    }
    return picture;
}

Image sampleTruth(double minorRadius, double hue, double turn) {
    const Image ring = sampleRing(minorRadius, hue, turn);
    Image truth(width, height,
                image::channelsOf({ChannelKind::Color, ChannelKind::Alpha, ChannelKind::Geometry,
                                   ChannelKind::Margin, ChannelKind::Tolerance}));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::ranges::copy(ring.pixel(x, y), truth.pixel(x, y).begin());
            const double edge = std::abs(std::abs(placeOf(x, y).across) - minorRadius);
            for (const std::string& name : image::channelsOf({ChannelKind::Margin})) {
                truth.at(x, y, name) = static_cast<float>(edge / (0.2 * pixelSize));
            }
            for (const std::string& name : image::channelsOf({ChannelKind::Tolerance})) {
                truth.at(x, y, name) = 1e-6f;
            }
        }
    }
    return truth;
}

std::vector<report::ReportCase> sampleCases() {
    const Image ring = sampleRing(0.35, 0.55);
    std::vector<Sample> samples;
    samples.push_back({"ring", "the plain ring: any hit at all", sampleTruth(0.35, 0.55), ring, "", ""});
    samples.push_back({"thin", "tubes thinner than a pixel", sampleTruth(0.06, 0.1),
                       rounded(withFlips(sampleRing(0.06, 0.1), 0.06, 4)), "", ""});
    samples.push_back({"hole", "hits lost where two roots are close", sampleTruth(0.35, 0.05),
                       withHole(rounded(sampleRing(0.35, 0.05))), "", ""});
    samples.push_back({"checker", "uv: the seam, and which way round it goes", sampleTruth(0.3, 0.3),
                       sampleRing(0.3, 0.3, 1.0 / 32.0), "", ""});
    samples.push_back({"shifted", "rays through the middles of the pixels", sampleTruth(0.25, 0.8),
                       shifted(sampleRing(0.25, 0.8)), "", ""});
    samples.push_back(
        {"nan", "a normal of length zero", sampleTruth(0.35, 0.65), withNan(sampleRing(0.35, 0.65)), "", ""});
    samples.push_back(
        {"small", "the size of the picture", sampleTruth(0.35, 0.2), Image(40, 32, valueNames), "", ""});
    samples.push_back(
        {"far", "t, to the last bits", sampleTruth(0.35, 0.45), withDrift(sampleRing(0.35, 0.45)), "", ""});
    samples.push_back({"lost", "a picture that nobody committed", std::nullopt, ring,
                       "cannot read \"golden/lost.exr\": there is no such file", "missing"});
    samples.push_back({"fat", "r near R: the hole is a dimple", sampleTruth(0.9, 0.9),
                       rounded(sampleRing(0.9, 0.9)), "", ""});
    std::vector<report::ReportCase> cases;
    for (Sample& sample : samples) {
        cases.push_back(caseOf(std::move(sample)));
    }
    const std::vector<std::string> names = {"ring", "spindle"};
    for (report::ReportCase& skipped : report::skippedCases(names, cases)) {
        cases.push_back(std::move(skipped));
    }
    return cases;
}

report::ReportHeading sampleHeading() {
    return {"Golden pictures", {{"device", "llvmpipe (LLVM 15.0.6, 256 bits)"}, {"driver", "Mesa 22.3.6"}}};
}

}  // namespace raytorus::test
