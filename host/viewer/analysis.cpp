// SPDX-License-Identifier: MIT
#include "viewer/analysis.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "reference/double_double.hpp"
#include "reference/intersect.hpp"
#include "scene/pack.hpp"
#include "trace/pixel_ray.hpp"
#include "viewer/view_io.h"

namespace raytorus::viewer {
namespace {

using Vector = std::array<double, 3>;

constexpr int tileSide = 32;

double distanceOf(const Vector& a, const Vector& b) {
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                     (a[2] - b[2]) * (a[2] - b[2]));
}

// A hit of the reference in its torus' frame.
struct TrueHit {
    int torus = -1;  // of the scene
    const scene_io::SceneTorus* placed = nullptr;
    double t = std::numeric_limits<double>::infinity();
    Vector position{};
};

// sceneFromTorus() and sceneOriginOf() of scene.glsl, without their roundings.
Vector toWorld(const scene_io::SceneTorus& torus, const Vector& v) {
    Vector world{};
    for (int i = 0; i < 3; ++i) {
        world[static_cast<std::size_t>(i)] = v[0] * static_cast<double>(torus.row0[i]) +
                                             v[1] * static_cast<double>(torus.row1[i]) +
                                             v[2] * static_cast<double>(torus.row2[i]);
    }
    return {world[0] + static_cast<double>(torus.row0.w), world[1] + static_cast<double>(torus.row1.w),
            world[2] + static_cast<double>(torus.row2.w)};
}

// From the world into the frame. The rows are floats and not quite orthonormal: two rounds of refinement
// invert them.
Vector toFrame(const scene_io::SceneTorus& torus, const Vector& world) {
    const auto turned = [&torus](const Vector& w) {
        const std::array rows = {&torus.row0, &torus.row1, &torus.row2};
        Vector v{};
        for (std::size_t i = 0; i < 3; ++i) {
            v[i] = static_cast<double>(rows[i]->x) * w[0] + static_cast<double>(rows[i]->y) * w[1] +
                   static_cast<double>(rows[i]->z) * w[2];
        }
        return v;
    };
    Vector v{};
    for (int round = 0; round < 3; ++round) {
        const Vector at = toWorld(torus, v);
        const Vector step = turned({world[0] - at[0], world[1] - at[1], world[2] - at[2]});
        v = {v[0] + step[0], v[1] + step[1], v[2] + step[2]};
    }
    return v;
}

double unitOf(const scene_io::SceneTorus& torus) {
    const double centre =
        std::max({std::abs(static_cast<double>(torus.row0.w)), std::abs(static_cast<double>(torus.row1.w)),
                  std::abs(static_cast<double>(torus.row2.w))});
    return std::ldexp(static_cast<double>(torus.radii.x) + static_cast<double>(torus.radii.y) + centre, -24);
}

// Can the ray come near the torus at all? In double, with room for every rounding.
bool mayMeet(const scene_io::SceneTorus& torus, const trace::TraceRay& ray) {
    double along = 0.0;
    double square = 0.0;
    double length = 0.0;
    const std::array centre = {torus.row0.w, torus.row1.w, torus.row2.w};
    for (std::size_t i = 0; i < 3; ++i) {
        const double d = static_cast<double>(ray.direction[i]);
        const double o = static_cast<double>(ray.origin[i]) - static_cast<double>(centre[i]);
        along += o * d;
        square += o * o;
        length += d * d;
    }
    const double radius = 1.001 * (static_cast<double>(torus.radii.x) + static_cast<double>(torus.radii.y));
    const double apart = square - along * along / length;
    return apart <= radius * radius + 1e-6 * square && (along <= 0.0 || square <= radius * radius);
}

struct Truth {
    TrueHit nearest;
    int count = 0;
};

template <class Real, class Solving>
void meet(const scene_io::SceneTorus& placed, const reference::Ray& ray, Truth& truth) {
    const reference::Torus torus{placed.radii.x, placed.radii.y};
    const auto found = reference::intersectAs<Real, Solving>(reference::BasicTorus<Real>(torus),
                                                             reference::BasicRay<Real>(ray));
    truth.count += found.count;
    if (found.count == 0) {
        return;
    }
    const double t = reference::toDouble(found.hits[0].t);
    if (t < truth.nearest.t) {
        truth.nearest = {placed.names.x, &placed, t, {}};
        for (std::size_t i = 0; i < 3; ++i) {
            truth.nearest.position[i] = reference::toDouble(found.hits[0].position[i]);
        }
    }
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

struct PixelJudge::Data {
    scene_io::SceneFrame frame;
    std::vector<scene_io::SceneTorus> tori;

    template <class Real, class Solving>
    [[nodiscard]] Truth trace(const trace::TraceRay& ray) const {
        Truth truth;
        for (const scene_io::SceneTorus& torus : tori) {
            if (mayMeet(torus, ray)) {
                meet<Real, Solving>(torus, std::bit_cast<reference::Ray>(trace::rayInFrame(torus, ray)),
                                    truth);
            }
        }
        return truth;
    }
};

PixelJudge::PixelJudge(const scene::Scene& scene, int width, int height)
    : data(std::make_unique<Data>(Data{scene::makeFrame(scene, width, height), {}})) {
    for (std::size_t i = 0; i < scene.tori.size(); ++i) {
        data->tori.push_back(scene::makeTorus(scene.tori[i], i));
    }
}

PixelJudge::~PixelJudge() = default;
PixelJudge::PixelJudge(PixelJudge&&) noexcept = default;

PixelAnalysis PixelJudge::judge(const image::Image& picture, int x, int y) const {
    const std::span<const float> pixel = picture.pixel(x, y);
    const auto value = [&](const char* channel) {
        return static_cast<double>(pixel[static_cast<std::size_t>(picture.channelIndex(channel))]);
    };
    const int id = static_cast<int>(value("id"));
    const int count = static_cast<int>(value("count"));
    const trace::TraceRay ray = trace::cameraRay(data->frame, x, y);
    Truth truth = data->trace<reference::DoubleDouble, double>(ray);
    const auto agrees = [&] { return truth.nearest.torus == id && truth.count == count; };
    if (!agrees()) {  // only the arbiter may accuse
        truth = data->trace<reference::Quad, reference::Quad>(ray);
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
    const scene_io::SceneTorus& torus = *truth.nearest.placed;
    const Vector found{value("position.x"), value("position.y"), value("position.z")};
    const double unit = unitOf(torus);
    const Vector local = toFrame(torus, found);
    const double fromRing =
        std::sqrt(local[0] * local[0] + local[1] * local[1]) - static_cast<double>(torus.radii.x);
    result.state = ANALYSIS_HIT;
    result.fromSurface =
        (std::sqrt(fromRing * fromRing + local[2] * local[2]) - static_cast<double>(torus.radii.y)) / unit;
    result.fromReference = distanceOf(found, toWorld(torus, truth.nearest.position)) / unit;
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
