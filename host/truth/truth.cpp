// SPDX-License-Identifier: MIT
#include "truth/truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <mutex>
#include <span>
#include <thread>

#include "core/error.hpp"
#include "image/channels.hpp"
#include "truth/sample.hpp"
#include "truth/sharpness.hpp"

namespace raytorus::truth {
namespace {

std::vector<std::string> channelNames(const TruthOptions& options) {
    using image::ChannelKind;
    std::vector<std::string> names = image::channelsOf({ChannelKind::Color, ChannelKind::Alpha});
    const auto add = [&names](const std::vector<std::string>& more) {
        names.insert(names.end(), more.begin(), more.end());
    };
    if (options.aovs) {
        add(image::channelsOf({ChannelKind::Geometry}));
    }
    if (options.sharpness) {
        add(image::channelsOf({ChannelKind::Margin, ChannelKind::Tolerance}));
    }
    return names;
}

float marginAsStored(double margin) {
    const double most = static_cast<double>(largestMargin);
    return margin > 0.0 ? static_cast<float>(std::exp2(std::floor(std::log2(std::min(margin, most))))) : 0.0F;
}

// What is beyond float32's range becomes its largest power of two: then anything agrees, but nothing is
// infinite.
float toleranceAsStored(double tolerance) {
    return tolerance > 0.0 ? static_cast<float>(std::exp2(std::ceil(std::log2(std::min(tolerance, 0x1p127)))))
                           : 0.0F;
}

// The values of one pixel, in the order of the channels.
class PixelWriter {
public:
    explicit PixelWriter(std::span<float> values) : to(values) {}

    template <class Real>
    void write(const Real& value) {
        to[next++] = static_cast<float>(value);
    }
    template <class Real>
    void write(const Vec3<Real>& v) {
        write(v[0]);
        write(v[1]);
        write(v[2]);
    }

private:
    std::span<float> to;
    std::size_t next = 0;
};

class Renderer {
public:
    Renderer(const scene::Scene& scene, int width, int height, const TruthOptions& wanted)
        : data(makeSceneData(scene, width, height)), options(wanted) {}

    void renderRow(image::Image& picture, int y) const {
        for (int x = 0; x < picture.width; ++x) {
            if (options.precision == Precision::Bits113) {
                renderPixel<Quad, Quad>(x, y, picture.pixel(x, y));
            } else {
                renderPixel<DoubleDouble, double>(x, y, picture.pixel(x, y));
            }
        }
    }

private:
    template <class Surface>
    struct Traced {
        Sample<Surface> sample;
        Sharpness sharpness;
    };

    template <class Real, class Surface>
    Traced<Surface> trace(int x, int y, int i, int j, int side) const {
        Traced<Surface> traced;
        traced.sample =
            traceSample<Real, Surface>(data, cameraRay(data.frame, samplePoint<Real>(x, y, i, j, side)));
        if (options.sharpness) {
            const Sample<Surface>& sample = traced.sample;
            const Seen seen{sample.torus, toDouble(sample.t), sample.otherField, sample.reaching};
            traced.sharpness =
                sharpnessOf(data, samplePoint<Rounded>(x, y, i, j, side),
                            cameraRay(data.frame, samplePoint<DoubleDouble>(x, y, i, j, side)), seen);
        }
        return traced;
    }

    template <class Real, class Surface>
    void renderPixel(int x, int y, std::span<float> values) const {
        const int side = options.samplesPerSide;
        const double samples = static_cast<double>(side) * side;
        Vec3<Surface> color = uniform<Surface>(0.0);
        double marginColor = static_cast<double>(largestMargin);
        double toleranceColor = 0.0;
        Traced<Surface> middle;
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const auto traced = trace<Real, Surface>(x, y, i, j, side);
                color = color + Surface(1.0 / samples) * traced.sample.color;
                marginColor = std::min(marginColor, traced.sharpness.marginColor);
                toleranceColor += traced.sharpness.color / samples;
                if (2 * i + 1 == side && 2 * j + 1 == side) {
                    middle = traced;
                }
            }
        }
        if (side % 2 == 0 && (options.aovs || options.sharpness)) {
            middle = trace<Real, Surface>(x, y, 0, 0, 1);
        }
        // Summing n colours rounds n times, and dividing once.
        const double brightest = std::max({toDouble(color[0]), toDouble(color[1]), toDouble(color[2])});
        toleranceColor += samples > 1.0 ? (samples + 1.0) * floatRounding * brightest : 0.0;

        PixelWriter to(values);
        to.write(color);
        to.write(1.0);
        if (options.aovs) {
            const Sample<Surface>& sample = middle.sample;
            to.write(sample.t);
            to.write(sample.point.position);
            to.write(sample.point.outward);
            to.write(sample.point.uv[0]);
            to.write(sample.point.uv[1]);
            to.write(sample.count);
            to.write(sample.torus);
        }
        if (options.sharpness) {
            const Sharpness& sharp = middle.sharpness;
            to.write(marginAsStored(sharp.margin));
            to.write(marginAsStored(sharp.marginCount));
            to.write(marginAsStored(marginColor));
            for (const double tolerance : {toleranceColor, sharp.t, sharp.position, sharp.normal, sharp.uv}) {
                to.write(toleranceAsStored(tolerance));
            }
        }
    }

    SceneData data;
    TruthOptions options;
};

}  // namespace

image::Image renderTruth(const scene::Scene& scene, int width, int height, const TruthOptions& options) {
    const std::vector<std::string> names = channelNames(options);
    const std::string problem = image::shapeProblem(width, height, names);
    if (!problem.empty()) {
        throw Error(ExitCode::OutOfMemory, fmt::format("the picture is too large: {}", problem));
    }
    image::Image picture(width, height, names);
    const Renderer renderer(scene, width, height, options);
    std::atomic<int> nextRow = 0;
    std::mutex reporting;
    int rowsDone = 0;
    const auto work = [&] {
        for (int y = nextRow++; y < height; y = nextRow++) {
            renderer.renderRow(picture, y);
            const std::lock_guard lock(reporting);
            ++rowsDone;
            if (options.progress) {
                options.progress(static_cast<double>(rowsDone) / height);
            }
        }
    };
    const unsigned threads = options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
    std::vector<std::future<void>> others;
    for (unsigned i = 1; i < threads; ++i) {
        others.push_back(std::async(std::launch::async, work));
    }
    work();
    for (std::future<void>& other : others) {
        other.get();  // throws what was thrown there
    }
    return picture;
}

std::vector<Disagreement> disagreements(const scene::Scene& scene, int width, int height,
                                        const TruthOptions& options) {
    TruthOptions plain = options;
    plain.sharpness = false;
    plain.precision = Precision::Bits113;
    const image::Image arbiter = renderTruth(scene, width, height, plain);
    plain.precision = Precision::Bits104;
    const image::Image other = renderTruth(scene, width, height, plain);
    std::vector<Disagreement> found;
    const auto channels = static_cast<std::size_t>(arbiter.channelCount());
    for (std::size_t i = 0; i < arbiter.pixels.size(); ++i) {
        const double a = static_cast<double>(arbiter.pixels[i]);
        const double b = static_cast<double>(other.pixels[i]);
        if (!(std::abs(a - b) <= std::max(0x1p-22 * std::max(std::abs(a), std::abs(b)), 1e-9))) {
            const auto pixel = static_cast<int>(i / channels);
            found.push_back({pixel % width, pixel / width, arbiter.channelNames[i % channels],
                             arbiter.pixels[i], other.pixels[i]});
        }
    }
    return found;
}

}  // namespace raytorus::truth
