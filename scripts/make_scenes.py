#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the scenes in scenes/. The build does not need it: the written files are committed.

Usage: scripts/make_scenes.py [folder]      (default: scenes/ beside this script's folder)
"""
import math
import pathlib
import sys

# --- small vectors ---------------------------------------------------------------------------------------------


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def mul(a, s):
    return [x * s for x in a]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return mul(a, 1 / math.sqrt(dot(a, a)))


def turn(v, axis, angle):
    """v turned about a unit axis, after Rodrigues."""
    along = mul(axis, dot(axis, v))
    return add(add(along, mul(sub(v, along), math.cos(angle))), mul(cross(axis, v), math.sin(angle)))


# --- what scenes are made of -----------------------------------------------------------------------------------

METALS = {
    "gold": {"diffuse": [0.34, 0.18, 0.02], "specular": [1.0, 0.71, 0.29], "roughness": 0.36},
    "silver": {"diffuse": [0.17, 0.175, 0.19], "specular": [0.95, 0.93, 0.88], "roughness": 0.34},
    "copper": {"diffuse": [0.27, 0.085, 0.035], "specular": [0.955, 0.54, 0.4], "roughness": 0.36},
    "brass": {"diffuse": [0.26, 0.16, 0.04], "specular": [0.91, 0.72, 0.33], "roughness": 0.33},
    "steel": {"diffuse": [0.07, 0.08, 0.095], "specular": [0.5, 0.53, 0.57], "roughness": 0.38},
}

PAPER = {"top": [1, 1, 1], "bottom": [0.66, 0.68, 0.7]}
NIGHT = {"top": [0.04, 0.055, 0.09], "bottom": [0.004, 0.005, 0.009]}
DAYLIGHT = {"sky": [0.3, 0.33, 0.38], "ground": [0.15, 0.13, 0.11]}
DUSK = {"sky": [0.2, 0.23, 0.29], "ground": [0.08, 0.065, 0.055]}


def directional(direction, radiance):
    return {"type": "directional", "direction": direction, "radiance": radiance}


def point(position, intensity):
    return {"type": "point", "position": position, "intensity": intensity}


KEY = directional([-0.5, -0.55, 0.9], [0.9, 0.86, 0.79])
FILL = directional([0.9, -0.35, 0.2], [0.16, 0.2, 0.27])
SPOT = directional([-0.5, -0.55, 0.9], [1.25, 1.18, 1.05])
RIM = directional([0.35, 0.9, 0.35], [0.35, 0.42, 0.55])


def camera(position, target, angle, up=(0, 0, 1)):
    return {"position": position, "target": target, "up": list(up), "verticalFieldOfView": angle}


def torus(major, minor, material, translation=None, axis=None, degrees=0):
    result = {"majorRadius": major, "minorRadius": minor}
    if translation:
        result["translation"] = translation
    if axis and degrees:
        result["rotation"] = {"axis": axis, "degrees": degrees}
    result["material"] = material
    return result


def facing(major, minor, material, translation, normal):
    """A torus whose axis is `normal`: turned out of +z the short way."""
    axis = cross([0, 0, 1], normal)
    length = math.sqrt(dot(axis, axis))
    degrees = math.degrees(math.atan2(length, normal[2]))
    return torus(major, minor, material, translation, mul(axis, 1 / length) if length > 1e-9 else None, degrees)


def scene(description, view, background, ambient, lights, materials, tori, image=(960, 640)):
    return {
        "$schema": "../docs/scene.schema.json",
        "description": description,
        "image": {"width": image[0], "height": image[1]},
        "camera": view,
        "background": background,
        "ambient": ambient,
        "lights": lights,
        "materials": materials,
        "tori": tori,
    }


# --- the scenes ------------------------------------------------------------------------------------------------


def ring():
    enamel = {
        "diffuse": [0.72, 0.65, 0.52], "specular": [0.05, 0.05, 0.05], "roughness": 0.28,
        "checker": {"counts": [40, 16], "diffuse": [0.012, 0.105, 0.14]},
    }
    return scene(
        "One ring close by, with a chessboard over its uv",
        camera([1.2, -3.3, 2.4], [0, 0, -0.06], 36), PAPER, DAYLIGHT, [KEY, FILL], {"enamel": enamel},
        [torus(1, 0.42, "enamel", axis=[1, 0.3, 0], degrees=8)])


def trefoil(t):
    return [math.sin(t) + 2 * math.sin(2 * t), 2 * math.cos(2 * t) - math.cos(t), -0.8 * math.sin(3 * t)]


def even_steps(curve, count, samples=20000):
    """`count` parameters of a closed curve, the same arc length apart; and that length."""
    points = [curve(2 * math.pi * i / samples) for i in range(samples + 1)]
    lengths = [0.0]
    for a, b in zip(points, points[1:]):
        lengths.append(lengths[-1] + math.sqrt(dot(sub(b, a), sub(b, a))))
    step = lengths[-1] / count
    parameters, i = [], 0
    for k in range(count):
        while lengths[i + 1] < k * step:
            i += 1
        part = (k * step - lengths[i]) / (lengths[i + 1] - lengths[i])
        parameters.append(2 * math.pi * (i + part) / samples)
    return parameters, step


def carried_normals(tangents):
    """Normals that turn with the curve and not about it, but for an even twist that lets the last meet the first."""
    normals = [unit(cross(tangents[0], [0, 0, 1]))]
    for a, b in zip(tangents, tangents[1:] + tangents[:1]):
        axis = cross(a, b)
        angle = math.atan2(math.sqrt(dot(axis, axis)), dot(a, b))
        normals.append(turn(normals[-1], unit(axis), angle))
    last, first = normals.pop(), normals[0]
    # The torus looks the same from both sides of its plane, so half a turn of twist is as good as none.
    missing = math.atan2(dot(cross(last, first), tangents[0]), dot(last, first))
    missing = math.remainder(missing, math.pi)
    count = len(tangents)
    return [turn(n, t, missing * i / count) for i, (n, t) in enumerate(zip(normals, tangents))]


def chain(links=72):
    parameters, step = even_steps(trefoil, links)
    small = 1e-5
    tangents = [unit(sub(trefoil(t + small), trefoil(t - small))) for t in parameters]
    # Neighbours at right angles to each other leave 2R - 2r - step between their tubes.
    thickness, play = 0.24, 0.05
    major = step / (2 - 2 * thickness - play)
    tori = []
    for i, normal in enumerate(carried_normals(tangents)):
        turned = turn(normal, tangents[i], math.pi / 4 + (math.pi / 2 if i % 2 else 0))
        material = "copper" if i % 6 == 3 else "silver" if i % 2 else "gold"
        tori.append(facing(major, major * thickness, material, trefoil(parameters[i]), turned))
    metals = {name: METALS[name] for name in ("gold", "silver", "copper")}
    return scene(
        f"A chain of {links} links along a trefoil knot",
        camera([0, -4.6, 11.5], [0, 0.33, 0], 28.5), NIGHT, DUSK, [SPOT, FILL, RIM], metals, tori)


def thin():
    pole = unit([0.32, -0.1, 1])

    def circle(latitude, ratio, material, radius=1.0):
        """A circle of latitude about the pole, on the sphere of this radius."""
        angle = math.radians(latitude)
        major = radius * math.cos(angle)
        return facing(major, major * ratio, material, mul(pole, radius * math.sin(angle)), pole)

    side = unit(cross(pole, [0, 1, 0]))
    other = cross(pole, side)
    ecliptic = turn(pole, side, math.radians(23.44))
    tori = [
        torus(1.33, 0.0665, "steel"),                                    # the horizon
        facing(1.2, 0.036, "brass", None, side),                     # the meridian
        circle(0, 0.025, "brass"), circle(23.44, 0.02, "brass"), circle(-23.44, 0.02, "brass"),
        circle(66.56, 0.03, "brass"), circle(-66.56, 0.03, "brass"),
        facing(1.0, 0.01, "brass", None, side), facing(1.0, 0.01, "brass", None, other),
        facing(1.085, 0.05, "enamel", None, ecliptic),                 # the sun's way
        facing(0.62, 0.0062, "silver", None, turn(ecliptic, other, 0.12)),
        facing(0.42, 0.0042, "silver", None, turn(ecliptic, side, -0.2)),
        facing(0.24, 0.024, "brass", None, ecliptic),
        torus(0, 0.12, "enamel"),                                      # no ring at all: a sphere
    ]
    materials = {"brass": METALS["brass"], "steel": METALS["steel"], "silver": METALS["silver"],
                 "enamel": {"diffuse": [0.62, 0.06, 0.035], "specular": [0.05, 0.05, 0.05], "roughness": 0.3}}
    return scene(
        "An armillary sphere: thin rings, their tubes a tenth to a hundredth of the ring's radius",
        camera([0.9, -3.6, 1.35], [0, 0, 0], 41), NIGHT, DUSK, [SPOT, FILL, RIM], materials, tori)


def far():
    view = mul(unit([0.42, -0.78, 0.62]), 1000)
    return scene(
        "One ring, seen from a thousand radii away through a long lens",
        camera(view, [0, 0, 0], 0.13), PAPER, DAYLIGHT, [KEY, FILL], {"copper": METALS["copper"]},
        [torus(1, 0.3, "copper", axis=[1, 0.3, 0], degrees=10)])


def inside():
    tiles = {
        "diffuse": [0.75, 0.7, 0.6], "specular": [0.04, 0.04, 0.04], "roughness": 0.35,
        "checker": {"counts": [60, 16], "diffuse": [0.08, 0.2, 0.24]},
    }

    def at(degrees, radius, height):
        angle = math.radians(degrees)
        return [radius * math.cos(angle), radius * math.sin(angle), height]

    return scene(
        "Inside the tube of a ring, along its way round",
        camera(at(0, 1.02, 0.02), at(38, 0.96, -0.05), 72), {"top": [0, 0, 0], "bottom": [0, 0, 0]},
        {"sky": [0.03, 0.035, 0.045], "ground": [0.03, 0.025, 0.02]},
        [point(at(22, 1.0, 0.2), [0.14, 0.105, 0.06]), point(at(62, 1.15, 0.1), [0.04, 0.07, 0.1])],
        {"tiles": tiles}, [torus(1, 0.4, "tiles")])


def nested():
    names = ["steel", "brass", "copper", "silver", "gold", "enamel"]
    tori, major, frame = [], 1.0, [[1, 0, 0], [0, 0, 1]]  # pivot and axis of the ring
    for i, name in enumerate(names):
        tori.append(facing(major, 0.075 * major, name, None, frame[1]))
        pivot = unit(cross(frame[1], frame[0])) if i else frame[0]
        axis = turn(frame[1], pivot, math.radians(28 + 4 * i))
        frame = [pivot, axis]
        major *= (1 - 0.075) / (1 + 0.075) - 0.02
    materials = {name: METALS[name] for name in names[:-1]}
    materials["enamel"] = {"diffuse": [0.02, 0.13, 0.3], "specular": [0.05, 0.05, 0.05], "roughness": 0.25}
    tori.append(torus(0.1, 0.16, "enamel"))
    return scene(
        "Rings within rings, each turned against the one around it",
        camera([1.2, -2.7, 1.7], [0, 0, -0.03], 33), NIGHT, DUSK, [SPOT, FILL, RIM], materials, tori)


def spindle():
    clay = {"specular": [0.045, 0.045, 0.045], "roughness": 0.36}
    materials = {
        "ring": {"diffuse": [0.6, 0.19, 0.08], **clay},
        "horn": {"diffuse": [0.66, 0.43, 0.11], **clay},
        "spindle": {"diffuse": [0.07, 0.27, 0.29], **clay},
    }
    tori = [
        torus(0.66, 0.34, "ring", [-2.35, 0, 0]),
        torus(0.5, 0.5, "horn"),
        torus(0.4, 0.6, "spindle", [2.35, 0, 0]),
    ]
    return scene(
        "A ring, a horn (r = R) and a spindle (r = 1.5 R)",
        camera([0, -9.2, 7.6], [0, 0, -0.05], 15), PAPER, DAYLIGHT, [KEY, FILL], materials, tori, (1200, 500))


def turntable(links=24):
    """A bracelet about an axis that leans, of upright and flat links in turn."""
    pole = unit([0.22, -0.16, 1])
    side = unit(cross([0, 1, 0], pole))
    radius, thickness, play = 1.32, 0.25, 0.07
    step = 2 * radius * math.sin(math.pi / links)
    major = step / (2 - 2 * thickness - play)
    tori = []
    for i in range(links):
        outwards = turn(side, pole, 2 * math.pi * i / links)
        normal = pole if i % 2 else outwards
        material = "gold" if i % 2 else "copper" if i % 8 == 0 else "silver"
        tori.append(facing(major, major * thickness, material, mul(outwards, radius), normal))
    tori.append(facing(0.56, 0.28, "enamel", None, turn(pole, side, math.radians(24))))
    tori.append(facing(0.07, 0.17, "gold", None, pole))
    materials = {name: METALS[name] for name in ("gold", "silver", "copper")}
    materials["enamel"] = {
        "diffuse": [0.6, 0.05, 0.03], "specular": [0.05, 0.05, 0.05], "roughness": 0.25,
        "checker": {"counts": [24, 10], "diffuse": [0.75, 0.68, 0.55]},
    }
    result = scene(
        f"A bracelet of {links} links round a ring that leans, on a turntable",
        camera([0.5, -4.4, 2.2], [0, 0, -0.1], 32), NIGHT, DUSK, [SPOT, FILL, RIM], materials, tori)
    result["animation"] = {"turntable": {"secondsPerTurn": 12, "axis": pole}}
    return result


# --- writing ---------------------------------------------------------------------------------------------------


def number(value):
    """Six significant digits, as short as they go."""
    rounded = float(f"{value:.6g}")
    return repr(int(rounded)) if rounded == int(rounded) else repr(rounded)


def text(value, indent=0, width=240):
    """JSON: a line for each torus, light or material; what holds several of them is broken."""
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, (int, float)):
        return number(value)
    pairs = isinstance(value, dict)
    parts = [(f'"{key}": ', item) for key, item in value.items()] if pairs else [("", item) for item in value]
    opening, closing = "{}" if pairs else "[]"
    line = opening + ", ".join(label + text(item) for label, item in parts) + closing
    holds_things = any(isinstance(item, dict) for _, item in parts) and not (pairs and "diffuse" in value)
    if len(line) + indent <= width and not (holds_things and indent < 4):
        return line
    margin = " " * (indent + 2)
    lines = ",\n".join(margin + label + text(item, indent + 2) for label, item in parts)
    return f"{opening}\n{lines}\n{' ' * indent}{closing}"


def main():
    default = pathlib.Path(__file__).resolve().parent.parent / "scenes"
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default
    folder.mkdir(parents=True, exist_ok=True)
    for make in (ring, chain, thin, far, inside, nested, spindle, turntable):
        (folder / f"{make.__name__}.json").write_text(text(make()) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
