// SPDX-License-Identifier: MIT
#include "random_scene.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "reference/random.hpp"

namespace raytorus::test {
namespace {

using reference::Random;

constexpr std::array thicknesses = {0.003, 0.01, 0.05, 0.1, 0.3, 0.6, 0.9, 1.0, 1.2, 2.0};
constexpr std::array cameraNames = {"near", "far", "inside", "grazing", "close"};

template <class Array>
auto oneOf(Random& random, const Array& choices) {
    return choices[static_cast<std::size_t>(random.below(static_cast<int>(choices.size())))];
}

glm::dvec3 toGlm(const reference::DoubleVec3& v) {
    return {v[0], v[1], v[2]};
}

double logUniform(Random& random, double low, double high) {
    return low * std::exp(random.uniform() * std::log(high / low));
}

glm::dvec3 reflectance(Random& random, double most) {
    return {random.uniform(0.0, most), random.uniform(0.0, most), random.uniform(0.0, most)};
}

scene::Material randomMaterial(Random& random, int index) {
    scene::Material material;
    material.name = fmt::format("material {}", index);
    material.diffuse = reflectance(random, 1.0);
    material.specular = reflectance(random, random.below(2) == 0 ? 0.05 : 1.0);
    material.roughness = random.uniform(0.1, 1.0);
    if (random.below(2) == 0) {
        material.checker =
            scene::Checker{2 * (1 + random.below(40)), 2 * (1 + random.below(12)), reflectance(random, 1.0)};
    }
    return material;
}

scene::TorusInstance randomTorus(Random& random, bool alone, std::size_t materials) {
    scene::TorusInstance torus;
    torus.majorRadius = logUniform(random, 0.3, 3.0);
    torus.minorRadius = torus.majorRadius * oneOf(random, thicknesses);
    torus.scale = random.below(2) == 0 ? 1.0 : logUniform(random, 0.2, 5.0);
    torus.materialIndex = static_cast<std::size_t>(random.below(static_cast<int>(materials)));
    if (!alone || random.below(2) == 0) {
        const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        torus.rotation = glm::angleAxis(angle, toGlm(random.onSphere()));
        torus.translation = 4.0 * toGlm(random.inBall());
    }
    return torus;
}

scene::Light randomLight(Random& random, const scene::TorusInstance& subject) {
    scene::Light light;
    const double size = subject.scale * (subject.majorRadius + subject.minorRadius);
    light.color = reflectance(random, 1.5);
    light.vector = toGlm(random.onSphere());
    if (random.below(3) == 0) {
        const double distance = size * logUniform(random, 0.3, 20.0);
        light.type = scene::Light::Type::Point;
        light.vector = subject.translation + distance * light.vector;
        light.color *= distance * distance;
    }
    return light;
}

// A point of the surface and its normal, in the world.
struct Footing {
    glm::dvec3 position, normal;
};
Footing randomFooting(Random& random, const scene::TorusInstance& torus) {
    const double u = random.uniform(0.0, 2.0 * std::numbers::pi);
    // On the outer half, where a spindle has no inner sheet.
    const double v = random.uniform(-0.5, 0.5) * std::numbers::pi;
    const glm::dvec3 outwards(std::cos(u), std::sin(u), 0.0);
    const glm::dvec3 normal = std::cos(v) * outwards + std::sin(v) * glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 local = torus.majorRadius * outwards + torus.minorRadius * normal;
    return {torus.translation + torus.scale * (torus.rotation * local), torus.rotation * normal};
}

// Looks at the subject so that it fills the picture, or at a piece of its surface.
scene::Camera randomCamera(Random& random, const scene::TorusInstance& subject, std::string& name) {
    scene::Camera camera;
    const double size = subject.scale * (subject.majorRadius + subject.minorRadius);
    const double tube = subject.scale * subject.minorRadius;
    const Footing footing = randomFooting(random, subject);
    const glm::dvec3 along = glm::normalize(glm::cross(footing.normal, toGlm(random.onSphere())));
    const int kind = random.below(static_cast<int>(cameraNames.size()));
    name = cameraNames[static_cast<std::size_t>(kind)];
    camera.target = footing.position;
    camera.verticalFieldOfView = random.uniform(20.0, 90.0);
    if (kind <= 1) {
        const double distance = size * (kind == 0 ? random.uniform(1.5, 5.0) : logUniform(random, 10.0, 1e6));
        camera.position = subject.translation + distance * toGlm(random.onSphere());
        camera.target = subject.translation;
        camera.verticalFieldOfView = glm::degrees(2.0 * std::atan(1.1 * size / distance));
    } else if (kind == 2) {
        camera.position = footing.position - random.uniform(0.2, 1.0) * tube * footing.normal;
        camera.target = camera.position + toGlm(random.onSphere());
    } else if (kind == 3) {
        camera.position = footing.position + size * (1.5 * along + 0.02 * footing.normal);
    } else {
        camera.position = footing.position + tube * (random.uniform(0.3, 2.0) * footing.normal + along);
    }
    camera.up = toGlm(random.onSphere());
    return camera;
}

}  // namespace

RandomScene randomScene(std::uint64_t seed, std::uint64_t index) {
    constexpr std::uint64_t stream = 2000;
    Random random(seed, stream, index);
    RandomScene drawn;
    scene::Scene& scene = drawn.scene;
    scene.background = {reflectance(random, 1.0), reflectance(random, 1.0)};
    scene.ambient = {reflectance(random, 0.5), reflectance(random, 0.5)};
    for (int i = 0; i < 3; ++i) {
        scene.materials.push_back(randomMaterial(random, i));
    }
    const int tori = random.below(2) == 0 ? 1 : 2 + random.below(5);
    for (int i = 0; i < tori; ++i) {
        scene.tori.push_back(randomTorus(random, tori == 1, scene.materials.size()));
    }
    const scene::TorusInstance& subject = scene.tori.front();
    const int lights = random.below(4);
    for (int i = 0; i < lights; ++i) {
        scene.lights.push_back(randomLight(random, subject));
    }
    std::string camera;
    scene.camera = randomCamera(random, subject, camera);
    drawn.description = fmt::format("scene {}: {} tori, r/R {:g}, {} lights, camera {}", index, tori,
                                    subject.minorRadius / subject.majorRadius, lights, camera);
    return drawn;
}

}  // namespace raytorus::test
