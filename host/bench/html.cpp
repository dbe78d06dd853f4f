// SPDX-License-Identifier: MIT
#include "bench/html.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/machine.hpp"
#include "bench/plot.hpp"
#include "bench/summary.hpp"
#include "bench/table.hpp"
#include "core/markup.hpp"

namespace raytorus::bench {
namespace {

constexpr const char* style = R"css(
:root { color-scheme: light dark; --ink: #1c2430; --paper: #ffffff; --faint: #d8dde4; --soft: #5c6775;
        --tiles: #0b62b8; --scattered: #b4530a; --ours: #15803d; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e9ee; --paper: #14181e; --faint: #323a45; --soft: #9aa5b3;
        --tiles: #6cb2ff; --scattered: #ffa657; --ours: #5fd38a; } }
body { background: var(--paper); color: var(--ink); font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto;
       max-width: 1060px; padding: 0 1rem; }
h1, h2 { line-height: 1.2; }
pre { font: 12px/1.4 ui-monospace, monospace; overflow-x: auto; border: 1px solid var(--faint); padding: .7rem; }
svg { width: 100%; height: auto; font: 13px system-ui, sans-serif; }
svg text { fill: var(--ink); }
.grid { stroke: var(--faint); } .ours { stroke: var(--ours); stroke-width: 2; }
.mean { stroke: var(--ink); stroke-width: 2.5; }
text.tick { text-anchor: middle; fill: var(--soft); font-size: 12px; } text.end { fill: var(--soft); font-size: 12px; }
text.left { text-anchor: start; } text.right, text.lane, text.number { text-anchor: end; }
text.name { font-weight: 600; } text.lane { font-size: 12px; }
text.tiles, i.tiles { fill: var(--tiles); color: var(--tiles); font-style: normal; }
text.scattered, i.scattered { fill: var(--scattered); color: var(--scattered); font-style: normal; }
circle.tiles { fill: var(--tiles); fill-opacity: .55; } circle.scattered { fill: var(--scattered); fill-opacity: .55; }
path.tiles { stroke: var(--tiles); } path.scattered { stroke: var(--scattered); }
path.bad { fill: none; stroke-width: 1.6; }
)css";

}  // namespace

std::string runHtml(const BenchRun& run) {
    std::string page = fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta "
        "charset=\"utf-8\">\n<title>raytorus-bench</title>\n"
        "<style>{}</style>\n</head>\n<body>\n<h1>raytorus-bench</h1>\n<p>{}. Seed {}, {} rounds.</p>\n",
        style, escapeHtml(machineText(run.machine)), run.seed, run.rounds);
    page +=
        "<p>Each mark is a workload: its time a ray over the library's on the same rays, without what making "
        "the "
        "rays costs. The upper line of a method are <i class=\"tiles\">camera tiles</i>, the lower one <i "
        "class=\"scattered\">scattered rays</i>; the bar is their geometric mean. A cross instead of a dot: "
        "more "
        "than one answer in a thousand was wrong.</p>\n";
    for (const trace::Query query : allQueries) {
        const bool present =
            std::ranges::any_of(run.cells, [query](const CellResult& cell) { return cell.query == query; });
        if (present) {
            page += fmt::format("<h2>{}</h2>\n{}",
                                query == trace::Query::Nearest ? "Nearest hit"
                                : query == trace::Query::Any   ? "Any hit"
                                                               : "All hits",
                                ratioPlot(run, query));
        }
    }
    page += fmt::format("<h2>All workloads together</h2>\n<pre>{}\n{}\n{}</pre>\n<h2>Each workload</h2>\n",
                        escapeHtml(steadinessText(run)), escapeHtml(summaryText(run)),
                        escapeHtml(aimsText(measureAims(run))));
    for (const CellResult& cell : run.cells) {
        page += fmt::format("<pre>{}</pre>\n", escapeHtml(tableText(cell)));
    }
    return page + "</body>\n</html>\n";
}

}  // namespace raytorus::bench
