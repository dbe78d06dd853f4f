#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws what raytorus-verify --json found, as SVG.

Usage: scripts/plot_accuracy.py <folder> <results.json>...

Writes accuracy-distance.svg and accuracy-radius.svg (one line a method and quantile) and accuracy-histogram.svg (of the
first file) into the folder. Several files of one method are added up. Clear rays alone: grazing groups are left out.
"""
import json
import math
import pathlib
import sys

WIDTH, HEIGHT = 860, 480
LEFT, RIGHT, TOP, BOTTOM = 80, 210, 46, 60
COLOURS = {
    "raytorus": "#0b6e4f",
    "closed-form-naive": "#c1440e",
    "sphere-tracing": "#7a3b9a",
    "closed-form": "#1f5fa8",
    "closed-form-polished": "#1f5fa8",
    "bracketed-newton": "#1f5fa8",
}
HALF_ULP = 2.0**-24


def merged(groups, key):
    """{key(group): {upper end: count}} of the position errors."""
    tables = {}
    for group in groups:
        table = tables.setdefault(key(group), {})
        for upper, count in group["position"]["histogram"]:
            table[upper] = table.get(upper, 0) + count
        largest = group["position"]["max"]  # null where it is infinite
        table["max"] = max(table.get("max", 0.0), math.inf if largest is None else largest)
    return tables


def quantile(table, part):
    bins = sorted((upper, count) for upper, count in table.items() if upper != "max")
    wanted = part * sum(count for _, count in bins)
    below = 0
    for upper, count in bins:
        below += count
        if below >= wanted:
            return min(upper, table["max"])
    return 0.0


class Plot:
    """A picture with logarithmic axes."""

    def __init__(self, title, x_label, y_label, x_range, y_range, x_ticks, y_ticks):
        self.x_range, self.y_range = x_range, y_range
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
            'font-family="Helvetica, Arial, sans-serif" font-size="13" fill="#222">',
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
            f'<text x="{LEFT}" y="26" font-size="16">{title}</text>',
            f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 14}" text-anchor="middle">{x_label}</text>',
            f'<text transform="translate(18 {(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)" text-anchor="middle">{y_label}</text>',
        ]
        for value, text in x_ticks:
            x = self.x(value)
            self.line([(x, TOP), (x, HEIGHT - BOTTOM)], "#e4e4e4", 1)
            self.text(x, HEIGHT - BOTTOM + 20, text, "middle")
        for value, text in y_ticks:
            y = self.y(value)
            self.line([(LEFT, y), (WIDTH - RIGHT, y)], "#e4e4e4", 1)
            self.text(LEFT - 8, y + 4, text, "end")

    def place(self, value, limits, first, last):
        low, high = limits
        part = (math.log(max(value, low)) - math.log(low)) / (math.log(high) - math.log(low))
        return first + min(part, 1.0) * (last - first)

    def x(self, value):
        return self.place(value, self.x_range, LEFT, WIDTH - RIGHT)

    def y(self, value):
        return self.place(value, self.y_range, HEIGHT - BOTTOM, TOP)

    def line(self, points, colour, width, dash=""):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        style = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}"{style}/>')

    def text(self, x, y, text, anchor="start", colour="#222"):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}">{text}</text>')

    def bar(self, x0, x1, y, colour):
        bottom = HEIGHT - BOTTOM
        self.parts.append(
            f'<rect x="{x0:.1f}" y="{y:.1f}" width="{max(x1 - x0 - 0.6, 0.6):.1f}" height="{bottom - y:.1f}" fill="{colour}"/>')

    def write(self, path):
        path.write_text("\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")


def power(exponent, base="10"):
    if base == "10" and 0 <= exponent <= 1:
        return str(10**exponent)
    sign = "−" if exponent < 0 else ""
    return f'{base}<tspan dy="-5" font-size="10">{sign}{abs(exponent)}</tspan>'


def draw_lines(path, results, title, x_label, key, x_ticks):
    xs = [value for value, _ in x_ticks]
    plot = Plot(title, x_label, "position error in R + r", (min(xs) / 1.2, max(xs) * 1.2), (1e-9, 10.0), x_ticks,
                [(10.0**e, power(e)) for e in range(-9, 2)])
    y = plot.y(HALF_ULP)
    plot.line([(LEFT, y), (WIDTH - RIGHT, y)], "#999999", 1, "2 4")
    labels = []
    for method, groups in results.items():
        tables = merged(groups, key)
        colour = COLOURS.get(method, "#444444")
        ends = ((1.0, "max", ""), (0.5, "median", "6 4")) if method == "raytorus" else ((0.99, "p99", ""), (0.5, "median", "6 4"))
        for part, name, dash in ends:
            points = [(plot.x(x), plot.y(tables[x]["max"] if part == 1.0 else quantile(tables[x], part)))
                      for x in xs if x in tables]
            plot.line(points, colour, 2.2, dash)
            labels.append([points[-1][1] + 4, f"{method}, {name}", colour])
    labels.append([y + 4, "rounding of the result", "#777777"])
    labels.sort()
    for above, label in zip(labels, labels[1:]):
        label[0] = max(label[0], above[0] + 16)
    for at, text, colour in labels:
        plot.text(WIDTH - RIGHT + 8, at, text, colour=colour)
    plot.write(path)


def draw_histogram(path, method, groups):
    table = next(iter(merged(groups, lambda group: 0).values()))
    bins = sorted((upper, count) for upper, count in table.items() if upper != "max" and upper > 1e-10)
    most = max(count for _, count in bins)
    total = sum(count for upper, count in table.items() if upper != "max")
    top = 10.0 ** math.ceil(math.log10(most))
    plot = Plot(f"Position errors of {total:,} hits of clear rays ({method})".replace(",", " "), "position error in R + r",
                "hits in a bin (a sixteenth of a power of two)", (2e-10, 2e-7), (0.7, top),
                [(10.0**e, power(e)) for e in (-9, -8, -7)] + [(HALF_ULP, power(-24, "2"))],
                [(10.0**e, power(e)) for e in range(0, int(math.log10(top)) + 1)])
    for upper, count in bins:
        lower = upper - 2.0 ** math.floor(math.log2(upper * (1 - 1e-9))) / 16
        if upper > 2e-10:
            plot.bar(plot.x(lower), plot.x(upper), plot.y(count), COLOURS["raytorus"])
    x = plot.x(HALF_ULP)
    plot.line([(x, TOP), (x, HEIGHT - BOTTOM)], "#c1440e", 1.5, "4 3")
    plot.text(x + 8, TOP + 16, "2⁻²⁴ (R + r): what rounding", colour="#c1440e")
    plot.text(x + 8, TOP + 33, "the exact point costs", colour="#c1440e")
    plot.text(WIDTH - RIGHT + 8, HEIGHT - BOTTOM - 6, f"largest: {table['max']:.3g}")
    plot.write(path)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    results = {}
    for name in sys.argv[2:]:
        found = json.loads(pathlib.Path(name).read_text(encoding="utf-8"))
        groups = [group for group in found["groups"] if group["class"] != "grazing"]
        results.setdefault(found["method"], []).extend(groups)
    far = {method: [group for group in groups if group["distance"] and group["class"] == "camera"]
           for method, groups in results.items()}
    draw_lines(folder / "accuracy-distance.svg", far, "Position error against the distance of the camera",
               "distance of the origin in R", lambda group: group["distance"],
               [(1.5, "1.5"), (3.0, "3"), (10.0, "10"), (100.0, "100"), (1e3, power(3)), (1e4, power(4)), (1e6, power(6))])
    near = {method: [group for group in groups if group["distance"] == 10.0] for method, groups in far.items()}
    radii = sorted({group["minorRadius"] for groups in near.values() for group in groups})
    draw_lines(folder / "accuracy-radius.svg", near, "Position error against the thickness of the torus, 10 R away",
               "r / R", lambda group: group["minorRadius"], [(radius, "" if radius == 1.0 else f"{radius:.3g}") for radius in radii])
    method, groups = next(iter(results.items()))
    draw_histogram(folder / "accuracy-histogram.svg", method, groups)


if __name__ == "__main__":
    main()
