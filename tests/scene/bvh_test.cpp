// SPDX-License-Identifier: MIT
// The hierarchy is well formed, and walking it finds what testing every box finds.
#include "scene/bvh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace raytorus::scene {
namespace {

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}

    double number(double from, double to) {
        return from + (to - from) * std::generate_canonical<double, 53>(engine_);
    }
    glm::dvec3 vector(double from, double to) {
        return {number(from, to), number(from, to), number(from, to)};
    }

private:
    std::mt19937_64 engine_;
};

struct Input {
    std::string name;
    std::vector<Box> boxes;
};

std::vector<Input> inputs() {
    Random random(1);
    std::vector<Input> all = {
        {"one", {{{1, 2, 3}, {4, 5, 6}}}},
        {"two", {{{0, 0, 0}, {1, 1, 1}}, {{5, 0, 0}, {6, 1, 1}}}},
        {"all equal", std::vector<Box>(1000, {{-1, -1, -1}, {1, 1, 1}})},
        {"all points, and equal", std::vector<Box>(33, {{0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}})},
    };
    Input scattered{"scattered", {}};
    Input nested{"nested about one centre", {}};
    Input line{"on a line", {}};
    Input growing{"each twice as far as the one before", {}};
    Input tiny{"subnormal distances", {}};
    Input outlier{"all equal but one", std::vector<Box>(100, {{0, 0, 0}, {1, 1, 1}})};
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 corner = random.vector(-10, 10);
        scattered.boxes.push_back({corner, corner + random.vector(0, 0.7)});
    }
    for (int i = 0; i < 200; ++i) {
        nested.boxes.push_back({glm::dvec3(-i), glm::dvec3(i)});
        line.boxes.push_back({{i, 0, 0}, {i + 0.5, 0, 0}});
        const double place = std::ldexp(1.0, i / 2);
        growing.boxes.push_back({{place, 0, 0}, {place * 1.25, 1, 1}});
        const double small = i * std::numeric_limits<double>::denorm_min();
        tiny.boxes.push_back({{small, 0, 0}, {small, 0, 0}});
    }
    outlier.boxes.push_back({{1e30, 1e30, 1e30}, {2e30, 2e30, 2e30}});
    for (Input& input : {std::ref(scattered), std::ref(nested), std::ref(line), std::ref(growing),
                         std::ref(tiny), std::ref(outlier)}) {
        all.push_back(std::move(input));
    }
    return all;
}

bool isLeaf(const BvhNode& node) {
    return node.primitive >= 0;
}

TEST(Bvh, OfNothingIsNothing) {
    const Bvh bvh = buildBvh({});
    EXPECT_TRUE(bvh.nodes.empty());
    EXPECT_TRUE(bvh.order.empty());
}

TEST(Bvh, HoldsEachPrimitiveOnce) {
    for (const Input& input : inputs()) {
        const Bvh bvh = buildBvh(input.boxes);
        const std::size_t count = input.boxes.size();
        ASSERT_EQ(bvh.nodes.size(), 2 * count - 1) << input.name;

        std::vector<std::uint32_t> sorted = bvh.order;
        std::ranges::sort(sorted);
        ASSERT_EQ(sorted.size(), count) << input.name;
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_EQ(sorted[i], i) << input.name;
        }
        // The leaves stand in the order of their primitives.
        std::int32_t next = 0;
        for (const BvhNode& node : bvh.nodes) {
            ASSERT_GE(node.primitive, -1) << input.name;
            if (isLeaf(node)) {
                ASSERT_EQ(node.primitive, next++) << input.name;
            }
        }
        ASSERT_EQ(static_cast<std::size_t>(next), count) << input.name;
    }
}

TEST(Bvh, SkipsToTheEndOfEachSubtree) {
    for (const Input& input : inputs()) {
        const Bvh bvh = buildBvh(input.boxes);
        // From the back: a leaf ends at the next node, an inner node where its second child ends.
        for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
            const BvhNode& node = bvh.nodes[i];
            if (isLeaf(node)) {
                ASSERT_EQ(node.skip, static_cast<std::int32_t>(i + 1)) << input.name << ", node " << i;
            } else {
                const auto second = static_cast<std::size_t>(bvh.nodes.at(i + 1).skip);
                ASSERT_EQ(node.skip, bvh.nodes.at(second).skip) << input.name << ", node " << i;
            }
        }
        EXPECT_EQ(bvh.nodes.front().skip, static_cast<std::int32_t>(bvh.nodes.size())) << input.name;
    }
}

TEST(Bvh, BoxesHoldWhatIsBelowAndNoMore) {
    const auto above = [](float wide, double exact) {
        return static_cast<double>(wide) >= exact &&
               static_cast<double>(std::nextafter(wide, -std::numeric_limits<float>::infinity())) < exact;
    };
    for (const Input& input : inputs()) {
        const Bvh bvh = buildBvh(input.boxes);
        for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
            const BvhNode& node = bvh.nodes[i];
            Box box{glm::dvec3(1e300), glm::dvec3(-1e300)};
            for (auto j = i; j < static_cast<std::size_t>(node.skip); ++j) {
                if (isLeaf(bvh.nodes[j])) {
                    const Box& primitive =
                        input.boxes[bvh.order[static_cast<std::size_t>(bvh.nodes[j].primitive)]];
                    box = {glm::min(box.minimum, primitive.minimum),
                           glm::max(box.maximum, primitive.maximum)};
                }
            }
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_TRUE(above(node.maximum[axis], box.maximum[axis])) << input.name << ", node " << i;
                ASSERT_TRUE(above(-node.minimum[axis], -box.minimum[axis])) << input.name << ", node " << i;
            }
        }
    }
}

TEST(Bvh, RoundsBeyondTheRangeOfFloatToInfinity) {
    const std::vector<Box> boxes = {{glm::dvec3(-1e39), glm::dvec3(1e39)}};
    const Bvh bvh = buildBvh(boxes);
    EXPECT_EQ(bvh.nodes[0].minimum[0], -std::numeric_limits<float>::infinity());
    EXPECT_EQ(bvh.nodes[0].maximum[2], std::numeric_limits<float>::infinity());
}

/// Does the ray, from its origin on, meet the box? The ray has no component 0.
template <class Vector>
bool meets(const glm::dvec3& origin, const glm::dvec3& direction, const Vector& minimum,
           const Vector& maximum) {
    double from = 0.0;
    double to = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (static_cast<double>(minimum[axis]) - origin[axis]) / direction[axis];
        const double b = (static_cast<double>(maximum[axis]) - origin[axis]) / direction[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

TEST(Bvh, FindsWhatTestingEveryBoxFinds) {
    Random random(2);
    std::vector<Box> boxes;
    for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 corner = random.vector(-10, 10);
        boxes.push_back({corner, corner + random.vector(0, 2)});
    }
    const Bvh bvh = buildBvh(boxes);
    std::size_t found = 0;
    std::size_t visited = 0;
    constexpr std::size_t rays = 1000;
    for (std::size_t ray = 0; ray < rays; ++ray) {
        const glm::dvec3 origin = random.vector(-15, 15);
        const glm::dvec3 direction = random.vector(-1, 1);
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            if (meets(origin, direction, boxes[i].minimum, boxes[i].maximum)) {
                expected.push_back(i);
            }
        }
        std::vector<std::uint32_t> hit;
        for (std::size_t i = 0; i < bvh.nodes.size();) {
            const BvhNode& node = bvh.nodes[i];
            ++visited;
            const bool isMet = meets(origin, direction, node.minimum, node.maximum);
            if (isMet && isLeaf(node)) {
                const std::uint32_t primitive = bvh.order[static_cast<std::size_t>(node.primitive)];
                // The float box is a little wider than the primitive's own.
                if (meets(origin, direction, boxes[primitive].minimum, boxes[primitive].maximum)) {
                    hit.push_back(primitive);
                }
            }
            i = isMet && !isLeaf(node) ? i + 1 : static_cast<std::size_t>(node.skip);
        }
        std::ranges::sort(hit);
        ASSERT_EQ(hit, expected) << "ray " << ray;
        found += hit.size();
    }
    EXPECT_GT(found, rays);
    // What it is for: a ray visits few of the 5999 nodes.
    EXPECT_LT(visited, rays * 300);
}

}  // namespace
}  // namespace raytorus::scene
