// SPDX-License-Identifier: MIT
#include "viewer/analysis.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "reference/intersect.hpp"
#include "trace/pixel_ray.hpp"
#include "trace/trace_ray.hpp"
#include "truth/crossings.hpp"
#include "viewer/view_io.h"

namespace raytorus::viewer {
namespace {

using reference::DoubleDouble;
using reference::Quad;
using reference::Vec3;
using truth::operator+;
using truth::operator-;

constexpr int tileSide = 32;

Vec3<double> toWorld(const scene_io::SceneTorus& torus, const Vec3<double>& v) {
    return truth::fromTorus(torus, v) + truth::originOf<double>(torus);
}

// From the world into the frame. The rows are floats and not quite orthonormal: two rounds of refinement
// invert them.
Vec3<double> toFrame(const scene_io::SceneTorus& torus, const Vec3<double>& world) {
    Vec3<double> v{};
    for (int round = 0; round < 3; ++round) {
        v = v + truth::toTorus(torus, world - toWorld(torus, v));
    }
    return v;
}

double unitOf(const scene_io::SceneTorus& torus) {
    const Vec3<double> centre = truth::originOf<double>(torus);
    const double largest = std::max({std::abs(centre[0]), std::abs(centre[1]), std::abs(centre[2])});
    return std::ldexp(truth::outerRadius(torus) + largest, -24);
}

// What the ray crosses that the shaders send through a pixel, as they give it to the library.
template <class Real, class Solving>
truth::Crossings<double> shaderCrossings(const truth::SceneData& scene, const trace::TraceRay& ray) {
    const auto found = truth::crossings<Real, Solving>(
        scene,
        [&ray](const scene_io::SceneTorus& torus) {
            const reference::BasicRay<Real> local(trace::asReferenceRay(trace::rayInFrame(torus, ray)));
            return truth::SceneRay<Real>{local.origin, local.direction};
        },
        truth::farthest);
    return {found.torus, reference::toDouble(found.t), truth::toDoubles(found.position), found.count};
}

std::vector<std::pair<int, int>> tilesFromTheMiddle(int width, int height) {
    std::vector<std::pair<int, int>> tiles;
    for (int y = 0; y < height; y += tileSide) {
        for (int x = 0; x < width; x += tileSide) {
            tiles.emplace_back(x, y);
        }
    }
    std::ranges::stable_sort(tiles, {}, [&](const std::pair<int, int>& tile) {
        const double x = tile.first + 0.5 * tileSide - 0.5 * width;
        const double y = tile.second + 0.5 * tileSide - 0.5 * height;
        return x * x + y * y;
    });
    return tiles;
}

}  // namespace

PixelJudge::PixelJudge(const scene::Scene& scene, int width, int height)
    : data(truth::makeSceneData(scene, width, height)) {}

PixelAnalysis PixelJudge::judge(const image::Image& picture, int x, int y) const {
    const std::span<const float> pixel = picture.pixel(x, y);
    const auto value = [&](const char* channel) {
        return static_cast<double>(pixel[static_cast<std::size_t>(picture.channelIndex(channel))]);
    };
    const int id = static_cast<int>(value("id"));
    const int count = static_cast<int>(value("count"));
    const trace::TraceRay ray = trace::cameraRay(data.frame, x, y);
    truth::Crossings<double> right = shaderCrossings<DoubleDouble, double>(data, ray);
    const auto agrees = [&] { return right.torus == id && right.count == count; };
    if (!agrees()) {  // only the arbiter may accuse
        right = shaderCrossings<Quad, Quad>(data, ray);
    }
    PixelAnalysis result;
    if (!agrees()) {
        result.state = ANALYSIS_WRONG;
        return result;
    }
    if (id < 0) {
        result.state = ANALYSIS_MISS;
        return result;
    }
    const scene_io::SceneTorus& torus = data.tori[static_cast<std::size_t>(id)];
    const Vec3<double> found{value("position.x"), value("position.y"), value("position.z")};
    const double unit = unitOf(torus);
    result.state = ANALYSIS_HIT;
    result.fromSurface =
        reference::tubeDistance(reference::BasicTorus<double>(truth::shapeOf(torus)), toFrame(torus, found)) /
        unit;
    result.fromReference = truth::length(found - toWorld(torus, right.position)) / unit;
    if (!std::isfinite(result.fromReference)) {  // no number, which is larger than no bound
        result = {ANALYSIS_WRONG, 0.0, 0.0};
    }
    return result;
}

void Analysis::start(const scene::Scene& scene, image::Image picture) {
    stop();
    known = {picture.width, picture.height, {}};
    known.values.assign(
        std::size_t{4} * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height),
        0.0F);
    now = {};
    news = true;
    stopping = false;
    worker = std::thread([this, judge = PixelJudge(scene, picture.width, picture.height),
                          kept = std::move(picture)] { work(judge, kept); });
}

void Analysis::stop() {
    stopping = true;
    if (worker.joinable()) {
        worker.join();
    }
}

void Analysis::work(const PixelJudge& judge, const image::Image& picture) {
    const double all = static_cast<double>(picture.width) * picture.height;
    for (const auto& [left, top] : tilesFromTheMiddle(picture.width, picture.height)) {
        const int right = std::min(left + tileSide, picture.width);
        const int bottom = std::min(top + tileSide, picture.height);
        std::vector<PixelAnalysis> tile;
        for (int y = top; y < bottom; ++y) {
            for (int x = left; x < right; ++x) {
                if (stopping) {
                    return;
                }
                tile.push_back(judge.judge(picture, x, y));
            }
        }
        const std::scoped_lock lock(mutex);
        for (std::size_t i = 0; i < tile.size(); ++i) {
            const int row = static_cast<int>(i) / (right - left);
            const int column = static_cast<int>(i) % (right - left);
            float* to = &known.values[4 * (static_cast<std::size_t>(top + row) *
                                               static_cast<std::size_t>(known.width) +
                                           static_cast<std::size_t>(left + column))];
            to[0] = static_cast<float>(tile[i].state);
            to[1] = static_cast<float>(std::abs(tile[i].fromSurface));
            to[2] = static_cast<float>(tile[i].fromReference);
            now.wrong += tile[i].state == ANALYSIS_WRONG ? 1 : 0;
            now.largest = std::max(now.largest, tile[i].fromReference);
        }
        now.part = std::min(now.part + static_cast<double>(tile.size()) / all, 0.999999);
        news = true;
    }
    const std::scoped_lock lock(mutex);
    now.part = 1.0;
    news = true;
}

bool Analysis::take(AnalysisPixels& pixels, Progress& progress) {
    const std::scoped_lock lock(mutex);
    if (!std::exchange(news, false)) {
        return false;
    }
    pixels = known;
    progress = now;
    return true;
}

}  // namespace raytorus::viewer
