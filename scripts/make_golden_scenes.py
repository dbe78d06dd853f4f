#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the scenes of the golden pictures, golden/scenes/*.json, and their table, golden/cases.json. The build does not
need it: the written files are committed. A golden whose scene has changed must be renewed (golden/README.md).

Usage: scripts/make_golden_scenes.py [folder]      (default: golden/ beside this script's folder)
"""
import math
import pathlib
import sys

from make_scenes import METALS, camera, directional, facing, mul, point, text, torus, unit

SIZE = (48, 32)

SKY = {"top": [0.55, 0.7, 0.95], "bottom": [0.3, 0.22, 0.18]}
SOFT = {"sky": [0.3, 0.33, 0.38], "ground": [0.15, 0.13, 0.11]}
SUN = directional([-0.5, -0.55, 0.9], [0.9, 0.86, 0.79])
LOW_SUN = directional([0.8, -0.5, 0.15], [0.8, 0.55, 0.35])
TILES = {"diffuse": [0.72, 0.65, 0.52], "specular": [0.05, 0.05, 0.05], "roughness": 0.3,
         "checker": {"counts": [24, 10], "diffuse": [0.012, 0.105, 0.14]}}
CLAY = {"diffuse": [0.6, 0.25, 0.1], "specular": [0.045, 0.045, 0.045], "roughness": 0.4}
MATERIALS = {"tiles": TILES, "clay": CLAY, "gold": METALS["gold"], "steel": METALS["steel"]}
# Oblique, so that no symmetry hides a swapped axis or a sign.
OBLIQUE = unit([0.36, -0.79, 0.5])

CASES = []


def case(name, catches, view, tori, lights=(SUN, LOW_SUN), materials=None, samples=1, ambient=SOFT, background=SKY,
         methods=None, size=SIZE):
    used = {t["material"] for t in tori}
    materials = materials or {key: value for key, value in MATERIALS.items() if key in used}
    scene = {"$schema": "../../docs/scene.schema.json", "description": catches,
             "image": {"width": size[0], "height": size[1]}, "camera": view, "background": background,
             "ambient": ambient, "lights": list(lights), "materials": materials, "tori": list(tori)}
    CASES.append((name, catches, scene, samples, methods))


def tilted(major, minor, material="tiles", translation=None):
    return torus(major, minor, material, translation, [1, 0.3, 0], 8)


def from_afar(distance, height, target=(0, 0, 0), direction=OBLIQUE):
    """A camera at this distance that sees `height` at the target from bottom to top."""
    position = [t + distance * d for t, d in zip(target, direction)]
    return camera(position, list(target), 2 * math.degrees(math.atan(0.5 * height / distance)))


def thicknesses():
    for ratio, name in [(0.5, "half"), (0.25, "quarter"), (0.75, "three_quarters"), (0.9, "fat"), (0.99, "nearly_horn")]:
        case(f"ring_{name}", f"an ordinary ring, r/R = {ratio:g}: hits, order, shading, checker by uv",
             from_afar(4, 2.6 * (1 + ratio) / 1.5), [tilted(1, ratio)],
             methods={"bracketed-newton": 0, "closed-form-polished": 0} if ratio == 0.5 else None)
    for ratio in (0.1, 0.03, 0.01, 0.003, 0.001):
        spot = [0.8 * math.cos(1.1), 0.8 * math.sin(1.1), 0.0]
        case(f"thin_{ratio:g}".replace("0.", ""), f"a tube of r/R = {ratio:g} from 3 R: its verdicts need the tube function",
             from_afar(3, 8 * ratio, [spot[0] / 0.8, spot[1] / 0.8, 0]), [torus(1, ratio, "tiles" if ratio > 0.02 else "gold")])
    case("horn", "r = R: the surface ends in a point at the centre", from_afar(5, 3.4), [tilted(1, 1)])
    case("horn_tip", "the tip of a horn from close by, where rho turns sharply", from_afar(0.5, 0.2, direction=unit([0.3, -0.5, 0.9])),
         [torus(1, 1, "clay")])
    case("spindle_slight", "r = 1.01 R: the inner sheet is small and must not show", from_afar(5, 3.4), [tilted(1, 1.01)])
    case("spindle", "r = 1.5 R: the outer sheet alone, with its dimples", from_afar(6, 4.2), [tilted(1, 1.5)])
    case("spindle_dimple", "a spindle's dimple and its cusp from above", from_afar(1.6, 1.2, [0, 0, 1.1], unit([0.2, -0.4, 0.9])),
         [torus(1, 1.5, "clay")])
    case("spindle_fat", "r = 30 R: nearly a sphere, dimples far smaller than the rest", from_afar(90, 64), [tilted(1, 30)])
    case("sphere", "R = 0: a sphere, whose uv has poles", from_afar(4, 2.6), [tilted(0, 1)])


def distances():
    for distance in (10, 100, 1e3, 1e4, 1e5):
        name = f"far_{distance:g}".replace("100000", "1e5")
        case(name, f"seen from {distance:g} R: the compensated shift of the origin",
             from_afar(distance, 3), [tilted(1, 0.3, "clay" if distance > 5000 else "tiles")])
    case("far_thin", "a tube of 0.01 R from 1000 R: shift and verdict together", from_afar(1000, 0.08, [1, 0, 0]),
         [torus(1, 0.01, "gold")])
    case("near_surface", "the camera a hundredth of r above the surface", camera([1.2, -0.52, 0.02], [0, 0.6, -0.1], 80),
         [torus(1, 0.3, "tiles")])
    case("near_thin", "the camera 3 r away from a tube of 0.001 R", camera([1.0002, -0.0025, 0.0015], [1, 0, 0], 60),
         [torus(1, 0.001, "gold")])


def insides():
    case("inside_tube", "starts inside the solid, looks along the tube; normals outward, light within",
         camera([1.02, 0, 0.02], [0.74, 0.63, -0.05], 80), [torus(1, 0.4, "tiles")],
         [point([0.93, 0.37, 0.2], [0.14, 0.105, 0.06]), point([0.5, 1.0, 0.1], [0.04, 0.07, 0.1])])
    case("inside_across", "starts inside the solid, looks across the hole: out, in and out again",
         camera([1.02, 0.1, 0.05], [-1, 0.2, 0.03], 50), [torus(1, 0.4, "tiles")],
         [point([0, 0, 0.3], [0.6, 0.5, 0.4]), point([-0.9, 0.1, 0.1], [0.05, 0.05, 0.1])])
    case("inside_away", "starts inside the solid and looks away from the hole: what it has left lies behind",
         camera([0.95, 0.05, 0.03], [2, 0.3, 0.1], 60), [torus(1, 0.4, "tiles")], [point([1.0, 0.1, 0.2], [0.06, 0.05, 0.04])])
    case("inside_light_across", "starts inside the solid: a light in the tube across the hole lights nothing here",
         camera([1.02, 0, 0.02], [0.74, 0.63, -0.05], 80), [torus(1, 0.4, "tiles")],
         [point([0.93, 0.37, 0.2], [0.14, 0.105, 0.06]), point([-1, -0.1, 0], [3, 1, 4])])
    case("outside_away", "starts beside the outer equator, within the bounding sphere, and looks away: nothing ahead",
         camera([1.28, 0, 0.36], [2.6, 0.1, 0.5], 60), [torus(1, 0.4, "tiles")])
    case("inside_hole", "starts in the hole", camera([0.05, 0.1, 0.02], [1, 0.3, 0.1], 90), [torus(1, 0.35, "tiles")],
         [point([0, 0, 0.2], [0.4, 0.35, 0.3])])
    case("inside_spindle", "starts inside a spindle: no hit on the inner sheet", camera([0.2, 0.1, 0.05], [1, 0.4, 0.3], 90),
         [torus(1, 1.4, "tiles")], [point([0.5, -0.2, 0.3], [1.5, 1.2, 1])])
    case("inside_lens", "starts between a spindle's dimples, within the inner sheet", camera([0, 0.05, 0], [0.3, 0.2, 1], 100),
         [torus(0.5, 1, "tiles")], [point([0.3, 0.1, 0], [0.7, 0.6, 0.5])])
    case("inside_sphere", "starts inside a sphere", camera([0.1, 0.2, -0.1], [1, 0.3, 0.4], 90), [torus(0, 1, "tiles")],
         [point([0, 0, 0.3], [0.6, 0.5, 0.4])])


def special_lines():
    case("axis_above", "down the axis: rays that are nearly parallel to it", camera([0.001, 0.002, 5], [0, 0, 0], 36, (0.3, 1, 0)),
         [torus(1, 0.4, "tiles")])
    case("axis_below", "up the axis, which is turned by half a turn", camera([0, 0, -5], [0, 0, 0], 36, (0.3, 1, 0)),
         [torus(1, 0.4, "tiles", None, [0.2, 1, 0], 180)])
    case("parallel", "from 10000 R above: every ray parallel to the axis but for 1e-4", camera([0.3, 0.2, 1e4], [0.3, 0.2, 0], 0.016, (0.3, 1, 0)),
         [torus(1, 0.4, "clay")])
    case("equator", "from the plane of the ring: cz is small for every ray", camera([3.5, 0.7, 0.003], [0, 0, 0.001], 30),
         [torus(1, 0.4, "tiles")])
    case("equator_edge", "the ring edge on, over its top: four hits lie close together", camera([4, 0.3, 0.42], [0, 0, 0.37], 4),
         [torus(1, 0.4, "clay")])
    case("through_axis", "rays that meet the axis: the planes of symmetry", camera([0, -4, 2], [0, 0, 0], 33), [torus(1, 0.3, "tiles")])
    case("villarceau", "along the plane that touches the tube twice: both circles at once",
         camera(mul([math.cos(math.asin(0.4)), 0, math.sin(math.asin(0.4))], 4), [0, 0, 0], 6), [torus(1, 0.4, "clay")])
    case("horizon_outer", "along the surface at the outer equator: silhouettes a pixel thick", camera([1.405, -2, 0.05], [1.39, 0, 0.01], 12),
         [torus(1, 0.4, "tiles")])
    case("horizon_inner", "along the surface at the inner equator, where it is a saddle", camera([0.6, -1.2, 0.12], [0.6, 0.3, -0.05], 25),
         [torus(1, 0.4, "tiles")])
    case("horizon_top", "along the circle at the top, where contact is fourfold", camera([0.9, -2.5, 0.46], [0.95, 0, 0.395], 8),
         [torus(1, 0.4, "tiles")])
    case("horizon_thin", "the horizon of a thin tube, along its way", camera([1.0, -0.3, 0.012], [1.0, 0.05, 0.004], 8),
         [torus(1, 0.01, "gold")])
    case("gap", "a slit between two tubes, a twentieth of a pixel wide and more", from_afar(5, 0.5, [1.05, 0, 0]),
         [torus(1, 0.3, "clay"), torus(1, 0.3, "gold", [0.004, 0.0, 0.601])])


def placements():
    case("turned", "a rotation about no axis of the frame", from_afar(4, 3), [torus(1, 0.35, "tiles", None, [0.3, -0.8, 0.5], 117)])
    case("quaternion", "a rotation given as a quaternion", from_afar(4, 3),
         [{**torus(1, 0.35, "tiles"), "rotation": {"quaternion": [0.2, -0.5, 0.3, 0.7]}}])
    case("scaled", "a uniform scale, rotation and translation together", from_afar(4, 3, [0.3, -0.2, 0.1]),
         [{**torus(100, 35, "tiles", [0.3, -0.2, 0.1], [1, 0.3, 0], 40), "scale": 0.01}])
    case("moved", "a torus 1000 R from the origin of the world, the camera with it", from_afar(4, 3, [700, -600, 400]),
         [torus(1, 0.35, "clay", [700, -600, 400], [1, 0.3, 0], 20)])
    case("tall", "more rows than the compute route draws at a time: each band at its place", from_afar(6, 9),
         [tilted(1, 0.35), tilted(0.6, 0.25, "gold", [0.2, 0, 2.6]), tilted(0.6, 0.25, "clay", [0, 0, -2.6])], size=(16, 96))
    case("tiny", "sizes of 1e-6: nothing may be absolute", from_afar(4e-6, 3e-6), [torus(1e-6, 0.35e-6, "tiles", None, [1, 0.3, 0], 20)])
    case("huge", "sizes of 1e6: nothing may be absolute", from_afar(4e6, 3e6), [torus(1e6, 0.35e6, "tiles", None, [1, 0.3, 0], 20)])
    case("rolled", "a camera that is rolled", camera([2, -2.6, 2], [0, 0, 0], 40, (0.7, 0.4, 0.6)), [tilted(1, 0.35)])
    case("wide", "a field of view of 130 degrees", camera([0.4, -1.7, 0.6], [0, 0, 0], 130), [tilted(1, 0.35)])


def many():
    links = [torus(1, 0.22, "gold", [1.15 * i, 0, 0], [1, 0, 0], 90 * (i % 2) + 20) for i in range(-2, 3)]
    case("links", "five linked rings: nearest of many, ids, shadows between them", from_afar(9, 4.6), links)
    rings = [facing(1 - 0.16 * i, 0.05, "steel" if i % 2 else "tiles", None, unit([math.sin(i), math.cos(2 * i), 1])) for i in range(6)]
    case("nested", "rings within rings, turned against each other", from_afar(4, 2.4), rings)
    grid = [torus(0.3, 0.1, ("clay", "gold", "steel")[(i + j) % 3], [0.9 * i, 0.9 * j, 0.2 * ((i * j) % 3)], [1, j * 0.3, 0.2], 25 * i)
            for i in range(-4, 5) for j in range(-4, 5)]
    case("grid", "81 rings: the hierarchy neither drops nor doubles one", from_afar(12, 7), grid)
    crowd = [torus(0.02, 0.008, ("clay", "gold", "steel")[i % 3], [0.1 * (i % 24) - 1.15, 0.1 * (i // 24) - 1.15, 0.01 * (i % 7)], [1, 0.2, 0], 10 * (i % 9))
             for i in range(576)]
    case("crowd", "576 rings, more than a uniform block holds: the storage buffers", from_afar(1.6, 0.7, [0.2, 0.1, 0]), crowd)
    case("overlap", "tori that run through each other: nearest by t alone", from_afar(4, 3),
         [torus(1, 0.3, "tiles"), torus(0.9, 0.35, "gold", [0.3, 0, 0.1], [1, 0, 0], 60), torus(0.3, 0.6, "clay", [-0.5, -0.3, 0.1])])
    case("behind", "a torus behind another: counts go on where hits end", camera([0.2, -6, 0.5], [0, 0, 0], 24),
         [torus(1, 0.3, "tiles", None, [1, 0, 0], 80), torus(1, 0.3, "gold", [0.1, 3, 0.1], [1, 0, 0], 70)])
    case("behind_camera", "a torus behind the camera must not show", camera([0, -1.6, 0.3], [0, 0, 0], 50),
         [torus(0.5, 0.2, "tiles"), torus(1, 0.3, "gold", [0, -4, 0.5], [1, 0, 0], 90)])


def shading():
    view = from_afar(4, 2.8)
    case("checker_fine", "a fine checker: uv to a hundredth of a field", from_afar(2.2, 0.5, [0.9, -0.8, 0.2]), [tilted(1, 0.4)],
         materials={"tiles": {**TILES, "checker": {"counts": [160, 80], "diffuse": [0.05, 0.05, 0.1]}}})
    case("checker_odd", "odd numbers of fields: the seams of u and v show where they are", view, [tilted(1, 0.4)],
         materials={"tiles": {**TILES, "checker": {"counts": [7, 5], "diffuse": [0.4, 0.02, 0.05]}}})
    case("checker_u", "stripes round the axis alone: u and v are not swapped", view, [tilted(1, 0.4)],
         materials={"tiles": {**TILES, "checker": {"counts": [12, 1], "diffuse": [0.02, 0.3, 0.05]}}})
    case("mirror_like", "roughness 0.08: highlights are sharp", view, [tilted(1, 0.4, "steel")],
         materials={"steel": {**METALS["steel"], "roughness": 0.08}})
    case("matt", "roughness 1 and no specular: Lambert alone", view, [tilted(1, 0.4, "clay")],
         materials={"clay": {"diffuse": [0.8, 0.7, 0.6], "specular": [0, 0, 0], "roughness": 1}})
    case("grazing_light", "light along the surface: Fresnel and masking at their ends", view, [tilted(1, 0.4, "gold")],
         [directional([0.55, 0.8, 0.02], [1.2, 1.1, 1.0])])
    case("backlit", "light from behind: facing and shadow decide", view, [tilted(1, 0.4, "clay")], [directional([-0.3, 0.9, 0.2], [1.5, 1.4, 1.2])])
    case("dark", "no light at all: the hemisphere alone", view, [tilted(1, 0.4, "clay")], [])
    case("no_ambient", "one light and nothing else: shadows are black", view, [tilted(1, 0.4, "clay")], [SUN],
         ambient={"sky": [0, 0, 0], "ground": [0, 0, 0]})
    case("point_light", "a point light close by: falloff, and shadow rays that end at it", view, [tilted(1, 0.4, "clay")],
         [point([0.5, -0.9, 0.9], [0.7, 0.6, 0.5])])
    case("point_light_in_hole", "a point light in the hole: what lies beyond it casts no shadow", view, [tilted(1, 0.3, "clay")],
         [point([0.1, 0, 0.05], [0.6, 0.5, 0.4])])
    case("point_light_below", "a point light just below a ring, which casts no shadow on what lies below both",
         from_afar(4, 2.6, [0.6, 0, 0.5], unit([0.9, -1.2, 0.35])),
         [torus(1, 0.4, "tiles"), torus(1, 0.3, "clay", [0, 0, 1.6], [1, 0, 0], 35)], [point([1, 0, 0.85], [0.5, 0.45, 0.4])])
    sixteen = [directional(unit([math.cos(0.4 * i), math.sin(0.4 * i), 0.2 + 0.1 * i]), [0.02 + 0.01 * i, 0.1, 0.17 - 0.01 * i])
               for i in range(16)]
    case("sixteen_lights", "as many lights as there may be, each of another colour", view, [tilted(1, 0.4, "clay")], sixteen)
    case("shadow_ring", "a ring's shadow on another, with its hole", from_afar(5, 3, [0, 0, -0.2]),
         [torus(1, 0.3, "clay", [0, 0, -0.5]), torus(0.45, 0.1, "gold", [-0.3, -0.4, 0.6], [1, 0, 0], 15)], [SUN])
    case("shadow_thin", "the shadow of a tube of 0.01 R", from_afar(2, 0.9, [0.8, -0.5, 0.2]),
         [torus(1, 0.4, "clay"), torus(0.5, 0.005, "gold", [0.6, -0.7, 0.75])], [directional([0.1, -0.2, 1], [1, 0.95, 0.9])])
    case("shadow_touching", "a ring that lies on another: shadow rays start beside what casts", from_afar(3, 1.4, [0.7, -0.7, 0.4]),
         [torus(1, 0.4, "clay"), torus(0.3, 0.1, "gold", [0.7, -0.7, 0.5])], [SUN])
    case("shadow_inside_spindle", "a shadow in a spindle's dimple", from_afar(4, 1.6, [0, 0, 0.9], unit([0.3, -0.5, 0.8])),
         [torus(1, 1.3, "clay")], [directional([0.5, 0.2, 0.6], [1.2, 1.1, 1])])
    case("background", "the gradient alone in most pixels, from straight down to straight up", camera([0, -3, 0], [0, 0, 0], 150),
         [torus(0.4, 0.15, "gold")], background={"top": [0.1, 0.4, 1], "bottom": [0.9, 0.2, 0.05]})
    case("samples", "3 x 3 samples a pixel: colour is their mean, the geometry that of the middle", view, [tilted(1, 0.4)], samples=9)
    case("samples_thin", "4 x 4 samples of tubes thinner than a pixel", view, [tilted(1, 0.01, "gold"), torus(0.7, 0.006, "steel", None, [0, 1, 0], 50)],
         samples=16)


def main():
    default = pathlib.Path(__file__).resolve().parent.parent / "golden"
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default
    (folder / "scenes").mkdir(parents=True, exist_ok=True)
    for family in (thicknesses, distances, insides, special_lines, placements, many, shading):
        family()
    rows = []
    for name, catches, scene, samples, methods in CASES:
        (folder / "scenes" / f"{name}.json").write_text(text(scene) + "\n", encoding="utf-8")
        row = {"name": name, "catches": catches}
        if samples != 1:
            row["samplesPerPixel"] = samples
        if methods:
            row["methods"] = methods
        rows.append(row)
    lines = ",\n".join("    " + text(row) for row in rows)
    (folder / "cases.json").write_text(f'{{\n  "cases": [\n{lines}\n  ]\n}}\n', encoding="utf-8")
    print(f"{len(rows)} cases")


if __name__ == "__main__":
    main()
