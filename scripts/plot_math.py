#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws two figures of docs/math.md from what `raytorus trace` answers: where in the plane of alpha and beta the reduced
quartic has 0, 2 and 4 real roots, and what float32 makes of the closed form near a tangent and near a plane of symmetry.

Usage: scripts/plot_math.py <raytorus> <folder>      (for example build/release/bin/raytorus docs/images)

Writes math-regions.svg and math-float32.svg.
"""
import csv
import math
import pathlib
import random
import subprocess
import sys
import tempfile

LIBRARY, FORMULA, GREY, INK = "#0b6e4f", "#c1440e", "#999999", "#222222"
COUNT_COLOURS = {0: "#9aa5b1", 2: "#1f5fa8", 4: "#0b6e4f"}


def trace(program, torus, rays, method):
    """All hits of each ray: lists of t."""
    with tempfile.TemporaryDirectory() as folder:
        given, found = pathlib.Path(folder) / "rays.csv", pathlib.Path(folder) / "hits.csv"
        given.write_text("".join(",".join(repr(x) for x in ray) + "\n" for ray in rays), encoding="utf-8")
        subprocess.run([program, "trace", given, "-o", found, "--torus", f"{torus[0]!r},{torus[1]!r}", "--all",
                        "--method", method], check=True)
        with found.open(encoding="utf-8") as file:
            rows = [[float(x) for x in row] for row in list(csv.reader(file))[1:]]
    return [row[1:1 + int(row[0])] for row in rows]


# --- drawing ---------------------------------------------------------------------------------------------------


class Panel:
    """A rectangle of the picture with its own axes, linear or logarithmic."""

    def __init__(self, picture, box, x_range, y_range, logarithmic):
        self.picture, self.box, self.ranges, self.logarithmic = picture, box, (x_range, y_range), logarithmic

    def place(self, value, axis):
        low, high = self.ranges[axis]
        if self.logarithmic:
            value, low, high = math.log(value), math.log(low), math.log(high)
        left, top, right, bottom = self.box
        part = (value - low) / (high - low)
        return left + part * (right - left) if axis == 0 else bottom - part * (bottom - top)

    def at(self, x, y):
        return self.place(x, 0), self.place(y, 1)

    def grid(self, x_ticks, y_ticks, x_label, y_label, title):
        left, top, right, bottom = self.box
        for value, name in x_ticks:
            x = self.place(value, 0)
            self.picture.line([(x, top), (x, bottom)], "#e4e4e4", 1)
            self.picture.text(x, bottom + 19, name, "middle")
        for value, name in y_ticks:
            y = self.place(value, 1)
            self.picture.line([(left, y), (right, y)], "#e4e4e4", 1)
            self.picture.text(left - 7, y + 4, name, "end")
        self.picture.text((left + right) / 2, bottom + 42, x_label, "middle")
        self.picture.parts.append(f'<text transform="translate({left - 46} {(top + bottom) / 2}) rotate(-90)" '
                                  f'text-anchor="middle">{y_label}</text>')
        self.picture.text(left, top - 14, title)

    def dots(self, points, colour, radius, opacity):
        low_x, high_x = self.ranges[0]
        low_y, high_y = self.ranges[1]
        self.picture.parts.append(f'<g fill="{colour}" fill-opacity="{opacity}">')
        for x, y in points:
            if low_x <= x <= high_x and low_y <= y <= high_y:
                px, py = self.at(x, y)
                self.picture.parts.append(f'<circle cx="{px:.1f}" cy="{py:.1f}" r="{radius}"/>')
        self.picture.parts.append("</g>")

    def curve(self, points, colour, width, dash=""):
        """Broken where it leaves the panel."""
        piece = []
        for x, y in list(points) + [(math.inf, math.inf)]:
            inside = self.ranges[0][0] <= x <= self.ranges[0][1] and self.ranges[1][0] <= y <= self.ranges[1][1]
            if inside:
                piece.append(self.at(x, y))
            elif piece:
                self.picture.line(piece, colour, width, dash)
                piece = []


class Picture:
    def __init__(self, width, height):
        self.parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
                      'font-family="DejaVu Sans, Verdana, sans-serif" font-size="13" fill="#222222">',
                      f'<rect width="{width}" height="{height}" fill="#ffffff"/>']

    def line(self, points, colour, width, dash=""):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        style = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}"{style}/>')

    def text(self, x, y, text, anchor="start", colour=INK):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}">{text}</text>')

    def write(self, path):
        path.write_text("\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")


def power(exponent):
    sign = "−" if exponent < 0 else ""
    return f'10<tspan dy="-5" font-size="10">{sign}{abs(exponent)}</tspan>'


# --- the plane of alpha and beta ----------------------------------------------------------------------------------


def line_with(cz, random_numbers):
    """A reduced line (origin, direction) with this product of c and z."""
    while True:
        z = random_numbers.uniform(-1, 1)
        across = math.sqrt(1 - z * z)
        # The closest point is p along the direction's own slope and q across it; its height is c = p * across.
        if abs(cz) > 0:
            p = cz / (z * across) if z * across else math.inf
        else:
            p = 0.0 if random_numbers.random() < 0.6 else random_numbers.uniform(-1.6, 1.6)
            z, across = (z, across) if p == 0.0 else (0.0, 1.0)
        if abs(p) < 2:
            q = random_numbers.uniform(0, 1.9)
            return (-p * z, q, p * across), (across, 0.0, z)


def regions(program, folder):
    random_numbers = random.Random(4)
    picture = Picture(980, 470)
    for index, cz in enumerate((0.0, 0.1)):
        left = 80 + 470 * index
        panel = Panel(picture, (left, 50, left + 390, 400), (-2.2, 2.2), (-1.2, 2.2), False)
        ticks = [(value, f"{value:g}".replace("-", "−")) for value in (-2, -1, 0, 1, 2)]
        panel.grid(ticks, ticks[1:], "α", "β", f"c z = {cz:g}")
        dots = {0: [], 2: [], 4: []}
        for w in (0.05, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 0.97):
            rays, places = [], []
            for _ in range(500):
                o, d = line_with(cz, random_numbers)
                o2, rho = sum(x * x for x in o), math.hypot(o[0], o[1])
                alpha = o2 - w * w + 2 * d[2] * d[2] - 1
                beta = ((rho - 1)**2 + o[2]**2 - w * w) * ((rho + 1)**2 + o[2]**2 - w * w)
                rays.append([o[i] - 4 * d[i] for i in range(3)] + [0.0] + list(d) + [math.inf])
                places.append((alpha, beta))
            for place, hits in zip(places, trace(program, (1.0, w), rays, "raytorus")):
                dots[len(hits)].append(place)
        for count, points in dots.items():
            panel.dots(points, COUNT_COLOURS[count], 1.7, 0.75)
        if cz == 0.0:
            panel.curve([(a / 100, a * a / 1e4) for a in range(-220, 1)], INK, 1.6)
            panel.curve([(a / 100, 0.0) for a in range(-220, 221)], INK, 1.6)
        else:
            # A double root at s: alpha and beta from f(s) = f'(s) = 0.
            for sign in (-1, 1):
                double = [sign * 10**(k / 400 - 2) for k in range(1200)]
                panel.curve([(-s * s - 2 * cz / s, s**4 - 4 * cz * s) for s in double], INK, 1.6)
        names = ((0, 1.2, 1.5), (4, -1.75, 0.9), (2, 0.6, -0.7))
        for count, x, y in names:
            px, py = panel.at(x, y)
            picture.parts.append(f'<rect x="{px - 36:.1f}" y="{py - 15:.1f}" width="72" height="21" fill="#ffffff" fill-opacity="0.85"/>')
            picture.text(px, py, f"{count} roots", "middle", COUNT_COLOURS[count])
    picture.write(folder / "math-regions.svg")


# --- float32 ------------------------------------------------------------------------------------------------------


def tangent_rays(torus, random_numbers, count):
    """(gap in r, ray): rays that pass within `gap` of a tangent, inside the tube."""
    major, minor = torus
    for k in range(count):
        gap = 10**(-6 + 6 * k / count)
        u, v, turn = (random_numbers.uniform(0, 2 * math.pi) for _ in range(3))
        around, up = (-math.sin(u), math.cos(u), 0.0), (-math.sin(v) * math.cos(u), -math.sin(v) * math.sin(u), math.cos(v))
        normal = (math.cos(v) * math.cos(u), math.cos(v) * math.sin(u), math.sin(v))
        # Across the tube, more or less: along it there are other tangents close by.
        angle = math.pi / 2 + 0.6 * math.sin(turn)
        d = [math.cos(angle) * around[i] + math.sin(angle) * up[i] for i in range(3)]
        ring = (major * math.cos(u), major * math.sin(u), 0.0)
        p = [ring[i] + (minor * (1 - gap)) * normal[i] for i in range(3)]
        yield gap, [p[i] - 3 * d[i] for i in range(3)] + [0.0] + d + [math.inf]


def symmetric_rays(random_numbers, count):
    """(c z, ray): rays beside a plane in which c z vanishes."""
    for k in range(count):
        offset = 10**(-8 + 8 * k / count)
        z = random_numbers.uniform(0.2, 0.6)
        across = math.sqrt(1 - z * z)
        p, q = offset / (z * across), random_numbers.uniform(0.8, 1.1)
        o, d = (-p * z, q, p * across), (across, 0.0, z)
        yield offset, [o[i] - 3 * d[i] for i in range(3)] + [0.0] + list(d) + [math.inf]


def errors(program, torus, family):
    """{method: [(x, error of the first hit, or None where the count is wrong)]}; t is about 3 R."""
    xs, rays = zip(*family)
    exact = trace(program, torus, rays, "reference")
    result = {}
    for method in ("closed-form", "raytorus"):
        found = trace(program, torus, rays, method)
        result[method] = [(x, abs(hits[0] - true[0]) if len(hits) == len(true) else None)
                          for x, hits, true in zip(xs, found, exact) if true]
    return result


def float32(program, folder):
    random_numbers = random.Random(7)
    picture = Picture(1010, 500)
    low, high, wrong_at = 1e-8, 3e-2, 1.6e-2
    ticks = [(10.0**e, power(e)) for e in range(-8, -1)]
    panels = (("near a tangent, r/R = 0.1", "gap between ray and tangent, in r", (1e-6, 1.0), range(-6, 1), (1.0, 0.1),
               tangent_rays((1.0, 0.1), random_numbers, 900)),
              ("near a plane of symmetry, r/R = 0.5", "c z", (1e-8, 1.0), range(-8, 1, 2), (1.0, 0.5),
               symmetric_rays(random_numbers, 900)))
    for index, (title, label, x_range, exponents, torus, family) in enumerate(panels):
        left = 80 + 480 * index
        panel = Panel(picture, (left, 66, left + 400, 430), x_range, (low, high), True)
        panel.grid([(10.0**e, power(e)) for e in exponents], ticks, label, "error of t, in R", title)
        y = panel.place(2.0**-23, 1)
        picture.line([(left, y), (left + 400, y)], GREY, 1, "2 4")
        picture.text(left + 396, y + 16, "half an ulp of t", "end", "#777777")
        for method, colour in (("closed-form", FORMULA), ("raytorus", LIBRARY)):
            found = errors(program, torus, family := list(family))[method]
            panel.dots([(x, max(e, 1.3e-8)) for x, e in found if e is not None], colour, 1.8, 0.6)
            missed = [x for x, e in found if e is None]
            for x in missed:
                px, py = panel.at(x, wrong_at)
                picture.line([(px, py - 6), (px, py + 6)], colour, 1.2)
            if missed:
                picture.text(left + 396, panel.place(wrong_at, 1) + 4, f"another number of hits: {len(missed)}", "end", colour)
    picture.text(80, 28, "closed form", colour=FORMULA)
    picture.text(190, 28, "torusIntersectAll", colour=LIBRARY)
    picture.text(340, 28, "a dot a ray; an error of 0 is drawn at the bottom", colour="#777777")
    picture.write(folder / "math-float32.svg")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2])
    regions(sys.argv[1], folder)
    float32(sys.argv[1], folder)


if __name__ == "__main__":
    main()
