// SPDX-License-Identifier: MIT
// A scene as plain data: what is in the picture, where it stands and from where it is seen. In double, before
// the GPU.
#pragma once

#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raytorus::scene {

inline constexpr std::size_t maxLights = 16;
inline constexpr int maxImageSize = 16384;     ///< each way, in pixels
inline constexpr int maxCheckerCount = 65536;  ///< each way, in fields

struct Camera {
    glm::dvec3 position{0.0, -4.0, 2.0};
    glm::dvec3 target{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    double verticalFieldOfView = 40.0;  ///< degrees, between the bottom and the top edge of the picture

    bool operator==(const Camera&) const = default;
};

/// What a ray sees that hits nothing: from bottom at -z to top at +z, linear RGB.
struct Background {
    glm::dvec3 top{1.0};
    glm::dvec3 bottom{0.66, 0.68, 0.70};

    bool operator==(const Background&) const = default;
};

/// Hemisphere light, without shadows: what a surface receives that faces +z (sky) or -z (ground), linear RGB.
struct Ambient {
    glm::dvec3 sky{0.30, 0.33, 0.38};
    glm::dvec3 ground{0.15, 0.13, 0.11};

    bool operator==(const Ambient&) const = default;
};

struct Light {
    enum class Type { Directional, Point };

    Type type = Type::Directional;
    /// Directional: from the scene towards the light, not zero, any length. Point: the light's position.
    glm::dvec3 vector{0.0, 0.0, 1.0};
    /// Directional: radiance. Point: intensity, which falls off with the square of the distance. Linear RGB.
    glm::dvec3 color{1.0};

    bool operator==(const Light&) const = default;
};

/// A chessboard over the uv of the surface: every other field has this diffuse colour instead of the
/// material's.
struct Checker {
    int countU = 24;  ///< fields round the axis, even so that they close
    int countV = 12;  ///< fields round the tube, even so that they close
    glm::dvec3 diffuse{0.1};

    bool operator==(const Checker&) const = default;
};

struct Material {
    std::string name;
    glm::dvec3 diffuse{0.5};    ///< reflectance, linear RGB in [0,1]
    glm::dvec3 specular{0.04};  ///< reflectance at normal incidence (F0), linear RGB in [0,1]
    double roughness = 0.4;     ///< in (0,1]
    std::optional<Checker> checker;

    bool operator==(const Material&) const = default;
};

/// A torus about +z, scaled, then rotated, then moved.
struct TorusInstance {
    double majorRadius = 1.0;   ///< of the ring, >= 0
    double minorRadius = 0.25;  ///< of the tube, > 0
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  ///< w, x, y, z; unit
    double scale = 1.0;                       ///< > 0
    std::size_t materialIndex = 0;            ///< into Scene::materials

    bool operator==(const TorusInstance&) const = default;
};

/// All tori turn rigidly about an axis, counter-clockwise seen from its tip; camera and lights stay.
struct Turntable {
    double secondsPerTurn = 10.0;    ///< > 0
    glm::dvec3 axis{0.0, 0.0, 1.0};  ///< not zero, any length
    glm::dvec3 center{0.0};          ///< a point that stays where it is

    bool operator==(const Turntable&) const = default;
};

struct Scene {
    std::string description;
    int imageWidth = 960;
    int imageHeight = 640;
    Camera camera;
    Background background;
    Ambient ambient;
    std::vector<Light> lights;           ///< at most maxLights
    std::vector<Material> materials;     ///< never empty in a scene that was read
    std::vector<TorusInstance> tori;     ///< at time 0
    std::optional<Turntable> turntable;  ///< none: nothing moves

    bool operator==(const Scene&) const = default;
};

struct Sphere {
    glm::dvec3 center{0.0};
    double radius = 0.0;
};

/// A sphere round all tori, of which there is one at least.
Sphere enclosingSphere(std::span<const TorusInstance> tori);

/// How far from its middle a camera has to be for the sphere to touch the edges of the narrower side of its
/// picture. aspectRatio: width / height.
double framingDistance(const Camera& camera, double radius, double aspectRatio);

/// A three-quarter view that frames the sphere round all tori.
/// aspectRatio: width / height of the picture. No tori: Camera's own defaults.
Camera framingCamera(const std::vector<TorusInstance>& tori, double aspectRatio);

/// A key light from the upper front left and a weak, cooler fill from the right: for scenes that name no
/// lights.
std::vector<Light> defaultLights();

/// The scene with its tori where they are at this time, which is finite; negative is before the start. At 0,
/// and whenever whole turns have passed, as nearly as a double tells time, they are exactly where the scene
/// has them. A scene in which nothing moves stays as it is.
[[nodiscard]] Scene sceneAt(const Scene& scene, double seconds);

}  // namespace raytorus::scene
