// SPDX-License-Identifier: MIT
// A bounding volume hierarchy that a shader walks without a stack: depth-first nodes with skip links.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace raytorus::scene {

/// An axis-aligned box; minimum <= maximum in each component.
struct Box {
    glm::dvec3 minimum{0.0};
    glm::dvec3 maximum{0.0};
};

/// One node, as the shader reads it (std430: two vec4 with an integer in w).
///
/// Walk: start at node 0; while node < nodes.size(): if the ray misses the box, go to skip; else, if it is a
/// leaf (primitive >= 0), test the primitive and go to skip; else go to node + 1.
struct BvhNode {
    float minimum[3];   ///< rounded towards -infinity from the double boxes
    std::int32_t skip;  ///< the node after this one's subtree; nodes.size() ends the walk
    float maximum[3];   ///< rounded towards +infinity
    std::int32_t
        primitive;  ///< leaf: index into Bvh::order (the position among the sorted primitives); inner: -1
};
static_assert(sizeof(BvhNode) == 32);

struct Bvh {
    std::vector<BvhNode> nodes;  ///< depth first, the root first; 2n-1 nodes for n boxes, none for none
    std::vector<std::uint32_t>
        order;  ///< order[i]: the index, in the given boxes, of the i-th sorted primitive
};

/// Binned surface area heuristic, one primitive a leaf; the i-th leaf in depth-first order holds order[i].
/// Boxes are finite, and fewer than 2^30.
Bvh buildBvh(std::span<const Box> boxes);

/// The tight box of a placed torus: along e_i it reaches R*sqrt(1-a_i^2) + r, a being the turned axis.
/// Widened by a few float32 roundings of the torus' coordinates, so that it also holds the torus that the
/// shader sees.
Box boundsOf(const TorusInstance& torus);

}  // namespace raytorus::scene
