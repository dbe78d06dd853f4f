// SPDX-License-Identifier: MIT
// The style sheet of a report, for light and dark.
#include "image/report_style.hpp"

namespace raytorus::image {

std::string_view reportStyle() {
    return R"css(
:root {
  color-scheme: light dark;
  --page: #f5f6f8; --card: #fff; --line: #d9dde3; --text: #1b2430; --soft: #5b6675; --code: #eef0f4;
  --bad: #b3261e; --badBack: #fbe9e7; --good: #1e6b34; --goodBack: #e4f3e8; --focus: #2563eb;
  --flip: #1d7a3a; --within: #3f74d6; --beyond: #e8700a; --gain: 8;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #14181e; --card: #1d232b; --line: #343c47; --text: #e6eaf0; --soft: #9aa6b5; --code: #14181e;
    --bad: #ff9d94; --badBack: #45211e; --good: #86d99c; --goodBack: #1d3a26; --focus: #7aa7ff;
    --flip: #6fd08a; --within: #6d9cf0; --beyond: #ff9440;
  }
}
* { box-sizing: border-box; }
[hidden] { display: none !important; }
body { margin: 0 auto; padding: 2rem 1.25rem 4rem; max-width: 76rem; background: var(--page); color: var(--text);
  font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.5rem; margin: 0; }
h3 { font-size: .9rem; margin: 0 0 .4rem; }
.total { margin: .25rem 0 1rem; font-size: 1.05rem; }
.bar { display: flex; height: 6px; border-radius: 3px; overflow: hidden; background: var(--good); }
.bar i { background: var(--bad); }
.facts { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1rem; margin: 1rem 0 0; font-size: .87rem; }
.facts dt { color: var(--soft); }
.facts dd { margin: 0; overflow-wrap: anywhere; }
.tools { display: flex; flex-wrap: wrap; align-items: center; gap: .5rem .9rem; margin: 1rem 0 .9rem; }
.tools input[type=search] { flex: 1 1 16rem; padding: .35rem .6rem; }
button:not(.picture), input[type=search], select { font: inherit; color: inherit; background: var(--card);
  border: 1px solid var(--line); border-radius: 5px; }
button:not(.picture) { padding: .2rem .7rem; cursor: pointer; }
output { color: var(--soft); font-variant-numeric: tabular-nums; }
.help { display: flex; flex-wrap: wrap; gap: .35rem 1.1rem; margin: .5rem 0; color: var(--soft); font-size: .87rem; }
p.help { display: block; margin-bottom: 1.2rem; }
.help b { display: inline-block; width: 1.6em; height: .85em; margin-right: .4em; border: 1px solid var(--line);
  border-radius: 2px; vertical-align: -.08em; }
kbd { padding: 0 .35em; border: 1px solid var(--line); border-radius: 3px; background: var(--card); font: .9em ui-monospace, monospace; }
.case { background: var(--card); border: 1px solid var(--line); border-left: 4px solid var(--good); border-radius: 6px;
  margin-bottom: .6rem; }
.case.failed { border-left-color: var(--bad); }
summary { display: grid; grid-template-columns: auto minmax(0, max-content) max-content max-content 1fr; align-items: center;
  gap: .1rem .75rem; padding: .45rem .9rem .45rem .5rem; cursor: pointer; }
summary h2 { font: 600 1rem ui-monospace, monospace; margin: 0; overflow-wrap: anywhere; }
.thumbs { grid-row: 1 / 3; display: flex; gap: 3px; }
.thumbs i { width: 66px; height: 44px; background-position: center; background-size: contain; background-repeat: no-repeat;
  image-rendering: pixelated; }
.thumbs .none { border: 1px dashed var(--line); }
.sentence { grid-column: 2 / -1; grid-row: 2; color: var(--soft); font-size: .9rem; overflow-wrap: anywhere; }
.failed .sentence { color: var(--text); }
.verdict { padding: 0 .55em; border-radius: 1em; font-size: .82rem; font-weight: 600; white-space: nowrap;
  color: var(--good); background: var(--goodBack); }
.failed .verdict { color: var(--bad); background: var(--badBack); }
.badness, .flips { font-size: .85rem; color: var(--soft); font-variant-numeric: tabular-nums; white-space: nowrap; }
.flips { color: var(--flip); }
.body { padding: .5rem .9rem .9rem; border-top: 1px solid var(--line); }
.catches { margin: .2rem 0 .7rem; }
.catches b { color: var(--soft); font-weight: 400; margin-right: .5em; }
.pictures { display: grid; grid-template-columns: repeat(3, 1fr); gap: .9rem; }
figure { margin: 0; min-width: 0; }
figcaption { font-size: .85rem; line-height: 1.6rem; color: var(--soft); }
figcaption select { font-size: .8rem; }
.picture { position: relative; display: block; width: 100%; aspect-ratio: var(--w) / var(--h); padding: 0; border: 0;
  box-shadow: 0 0 0 1px var(--line); background: #000 center no-repeat; background-size: var(--fit, contain); image-rendering: pixelated; cursor: crosshair; }
.expected, .actual.swaps:hover, .actual.swaps:focus-visible { background-image: var(--expected); }
.actual, .expected.swaps:hover, .expected.swaps:focus-visible { background-image: var(--actual); }
.heat { background-image: var(--heat); }
.margin { background-image: var(--margin); }
.amplified::before { content: ""; position: absolute; inset: 0; background-image: var(--expected), var(--actual);
  background-size: 100% 100%; background-blend-mode: difference; filter: brightness(var(--gain)); }
.split { cursor: ew-resize; overflow: hidden; }
.split .actual { position: absolute; inset: 0; background-size: 100% 100%; image-rendering: pixelated;
  clip-path: inset(0 0 0 var(--split, 50%)); }
.split::after { content: ""; position: absolute; inset: 0 auto; left: calc(var(--split, 50%) - 1px); width: 2px;
  background: #fff; box-shadow: 0 0 0 1px #0008; pointer-events: none; }
.split input { position: absolute; inset: 0; z-index: 1; width: 100%; height: 100%; margin: 0; opacity: 0; cursor: ew-resize; }
.split:focus-within { outline: 2px solid var(--focus); outline-offset: 2px; }
.mark { display: none; position: absolute; left: calc(var(--x) * 100% / var(--w)); top: calc(var(--y) * 100% / var(--h));
  width: calc(100% / var(--w)); height: calc(100% / var(--h)); pointer-events: none; outline: 1px solid #fff;
  box-shadow: 0 0 0 2px #000a; min-width: 5px; min-height: 5px; }
.marked .mark { display: block; }
:focus-visible { outline: 2px solid var(--focus); outline-offset: 2px; }
.sections { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 29rem), 1fr)); gap: 1.2rem; margin-top: 1.1rem; }
.zooms { display: flex; gap: .5rem; }
.zoom { position: relative; flex: none; width: 8.25rem; height: 8.25rem; box-shadow: 0 0 0 1px var(--line);
  background-color: var(--code); background-repeat: no-repeat; image-rendering: pixelated;
  background-size: calc(var(--w) * .75rem) calc(var(--h) * .75rem);
  background-position: calc((5 - var(--x)) * .75rem) calc((5 - var(--y)) * .75rem); }
.zoom::after { content: ""; position: absolute; inset: 3.75rem; outline: 1px solid #fff; box-shadow: 0 0 0 2px #000a; }
.histogram { display: flex; gap: 3px; height: 10.5rem; }
.bin { flex: 1; display: flex; flex-direction: column; justify-content: flex-end; text-align: center; font-size: .72rem; min-width: 0; }
.bin i { background: var(--soft); border-radius: 2px 2px 0 0; }
.bin.within i { background: var(--within); }
.bin.beyond i { background: var(--beyond); }
.bin b { border-top: 1px solid var(--line); padding-top: .15rem; font-weight: 400; color: var(--soft); white-space: nowrap; }
.numbers { overflow-x: auto; margin-top: .9rem; }
table { border-collapse: collapse; font: .82rem/1.5 ui-monospace, monospace; white-space: nowrap; }
th, td { padding: .1rem .8rem .1rem 0; text-align: right; font-variant-numeric: tabular-nums; }
th { font-weight: 400; color: var(--soft); border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; }
tr.over td { color: var(--bad); }
.counts { margin: .5rem 0 0; font-size: .85rem; color: var(--soft); }
.commands { margin-top: 1.2rem; display: grid; gap: .6rem; }
.command { display: grid; grid-template-columns: 1fr auto; gap: .1rem .6rem; align-items: center; font-size: .85rem; }
.command span { grid-column: 1 / -1; color: var(--soft); }
code { padding: .3rem .55rem; border-radius: 4px; background: var(--code); font: .82rem/1.5 ui-monospace, monospace; overflow-wrap: anywhere; }
dialog { border: 1px solid var(--line); border-radius: 6px; padding: .75rem; background: var(--card); color: var(--text);
  max-width: 96vw; max-height: 96vh; }
dialog::backdrop { background: #000a; }
dialog p { margin: 0 0 .5rem; }
dialog .picture { width: min(90vw, 84vh * var(--w) / var(--h)); cursor: zoom-out; }
@media (max-width: 45rem) {
  .pictures { grid-template-columns: 1fr; }
  .thumbs i { width: 36px; height: 24px; }
}
@media print { .tools, p.help, .copy { display: none; } }
)css";
}

}  // namespace raytorus::image
