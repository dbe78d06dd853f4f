// SPDX-License-Identifier: MIT
// Building the hierarchy: binned surface area heuristic after Wald, "On fast Construction of SAH-based
// Bounding Volume Hierarchies" (2007), with an explicit stack, so that no input is too deep.
#include "scene/bvh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace raytorus::scene {
namespace {

constexpr std::size_t binCount = 16;

/// Contains nothing; the neutral element of merge.
constexpr Box emptyBox{glm::dvec3(std::numeric_limits<double>::infinity()),
                       glm::dvec3(-std::numeric_limits<double>::infinity())};

struct Bin {
    Box box = emptyBox;
    std::size_t count = 0;
};

/// Where to cut: primitives whose bin along the axis is below `bin` go left. No axis: all centres coincide.
struct Split {
    int axis = -1;
    std::size_t bin = 0;
    double cost = std::numeric_limits<double>::infinity();
};

Box merge(const Box& a, const Box& b) {
    return {glm::min(a.minimum, b.minimum), glm::max(a.maximum, b.maximum)};
}

/// Half the surface. The factor does not matter to the heuristic.
double area(const Box& box) {
    const glm::dvec3 size = box.maximum - box.minimum;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

glm::dvec3 centreOf(const Box& box) {
    return 0.5 * box.minimum + 0.5 * box.maximum;
}

/// The first division keeps the quotient in [0,1] even where the extent is subnormal.
std::size_t binOf(double centre, double minimum, double extent) {
    const double position = (centre - minimum) / extent * static_cast<double>(binCount);
    return std::min(static_cast<std::size_t>(position), binCount - 1);
}

/// The cheapest cut between two bins of one axis. Both sides are never empty: the outermost bins are not.
void improve(Split& best, int axis, const std::array<Bin, binCount>& bins) {
    std::array<double, binCount> costOnTheRight{};
    Bin right;
    for (std::size_t i = binCount - 1; i > 0; --i) {
        right = {merge(right.box, bins[i].box), right.count + bins[i].count};
        costOnTheRight[i] = area(right.box) * static_cast<double>(right.count);
    }
    Bin left;
    for (std::size_t i = 1; i < binCount; ++i) {
        left = {merge(left.box, bins[i - 1].box), left.count + bins[i - 1].count};
        const double cost = area(left.box) * static_cast<double>(left.count) + costOnTheRight[i];
        if (cost < best.cost) {
            best = {axis, i, cost};
        }
    }
}

class Builder {
public:
    explicit Builder(std::span<const Box> boxes) : boxes_(boxes) {
        bvh_.order.resize(boxes.size());
        std::iota(bvh_.order.begin(), bvh_.order.end(), 0U);
        centres_.reserve(boxes.size());
        std::ranges::transform(boxes, std::back_inserter(centres_), centreOf);
    }

    Bvh build() {
        if (boxes_.empty()) {
            return {};
        }
        bvh_.nodes.reserve(2 * boxes_.size() - 1);
        std::vector<Range> pending{{0, boxes_.size()}};
        while (!pending.empty()) {
            const Range range = pending.back();
            pending.pop_back();
            appendNode(range);
            if (range.end - range.begin > 1) {
                const std::size_t middle = partition(range);
                pending.push_back({middle, range.end});
                pending.push_back({range.begin, middle});  // on top: the left subtree follows its parent
            }
        }
        return std::move(bvh_);
    }

private:
    struct Range {
        std::size_t begin;
        std::size_t end;
    };

    std::span<std::uint32_t> primitives(Range range) {
        return std::span(bvh_.order).subspan(range.begin, range.end - range.begin);
    }

    void appendNode(Range range) {
        Box box = emptyBox;
        for (const std::uint32_t primitive : primitives(range)) {
            box = merge(box, boxes_[primitive]);
        }
        // A binary tree over n leaves has 2n-1 nodes: the end of the subtree is known before it is built.
        const std::size_t count = range.end - range.begin;
        BvhNode node{};
        for (int i = 0; i < 3; ++i) {
            node.minimum[i] = floatBelow(box.minimum[i]);
            node.maximum[i] = floatAbove(box.maximum[i]);
        }
        node.skip = static_cast<std::int32_t>(bvh_.nodes.size() + 2 * count - 1);
        node.primitive = count == 1 ? static_cast<std::int32_t>(range.begin) : -1;
        bvh_.nodes.push_back(node);
    }

    /// Sorts the range into two parts and returns where the second begins; neither part is empty.
    std::size_t partition(Range range) {
        glm::dvec3 minimum = emptyBox.minimum;
        glm::dvec3 maximum = emptyBox.maximum;
        for (const std::uint32_t primitive : primitives(range)) {
            minimum = glm::min(minimum, centres_[primitive]);
            maximum = glm::max(maximum, centres_[primitive]);
        }
        const glm::dvec3 extent = maximum - minimum;
        Split split;
        for (int axis = 0; axis < 3; ++axis) {
            if (extent[axis] > 0.0) {
                std::array<Bin, binCount> bins;
                for (const std::uint32_t primitive : primitives(range)) {
                    Bin& bin = bins[binOf(centres_[primitive][axis], minimum[axis], extent[axis])];
                    bin = {merge(bin.box, boxes_[primitive]), bin.count + 1};
                }
                improve(split, axis, bins);
            }
        }
        if (split.axis < 0) {
            return range.begin + (range.end - range.begin) / 2;
        }
        const auto secondPart = std::ranges::partition(primitives(range), [&](std::uint32_t primitive) {
            return binOf(centres_[primitive][split.axis], minimum[split.axis], extent[split.axis]) <
                   split.bin;
        });
        return range.end - secondPart.size();
    }

    static float floatBelow(double value) {
        const float nearest = nearestFloat(value);
        return static_cast<double>(nearest) <= value
                   ? nearest
                   : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
    }

    static float floatAbove(double value) { return -floatBelow(-value); }

    /// The conversion of a double beyond the range of float is undefined in C++.
    static float nearestFloat(double value) {
        constexpr double largest = std::numeric_limits<float>::max();
        if (std::abs(value) > largest) {
            return std::copysign(std::numeric_limits<float>::infinity(),
                                 static_cast<float>(std::copysign(1.0, value)));
        }
        return static_cast<float>(value);
    }

    std::span<const Box> boxes_;
    std::vector<glm::dvec3> centres_;
    Bvh bvh_;
};

}  // namespace

Bvh buildBvh(std::span<const Box> boxes) {
    return Builder(boxes).build();
}

Box boundsOf(const TorusInstance& torus) {
    const glm::dvec3 axis = torus.rotation * glm::dvec3(0.0, 0.0, 1.0);
    const double major = torus.scale * torus.majorRadius;
    const double minor = torus.scale * torus.minorRadius;
    // The shader places the torus with float32 values, each half an epsilon off at most: a few of them in
    // all.
    constexpr double roundingOfTheShader = 4.0 * std::numeric_limits<float>::epsilon();
    Box box;
    for (int i = 0; i < 3; ++i) {
        // hypot of the other two components, not sqrt(1 - axis[i]^2), which loses half its digits near 1.
        const double sine = std::hypot(axis[(i + 1) % 3], axis[(i + 2) % 3]);
        const double margin = roundingOfTheShader * (std::abs(torus.translation[i]) + major + minor);
        const double reach = major * sine + minor + margin;
        box.minimum[i] = torus.translation[i] - reach;
        box.maximum[i] = torus.translation[i] + reach;
    }
    return box;
}

}  // namespace raytorus::scene
