// SPDX-License-Identifier: MIT
// The style sheet and script of a report. Pictures are CSS variables of their case, so each is in the page
// once, however many places show it.
#include "image/report_style.hpp"

namespace raytorus::image {

std::string_view reportStyle() {
    return R"css(
:root {
  color-scheme: light dark;
  --page: #f5f6f8; --card: #fff; --line: #d9dde3; --text: #1b2430; --soft: #5b6675;
  --bad: #b3261e; --badBack: #fbe9e7; --good: #1e6b34; --goodBack: #e4f3e8; --focus: #2563eb;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #14181e; --card: #1d232b; --line: #343c47; --text: #e6eaf0; --soft: #9aa6b5;
    --bad: #ff9d94; --badBack: #45211e; --good: #86d99c; --goodBack: #1d3a26; --focus: #7aa7ff;
  }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.25rem 4rem; max-width: 72rem; background: var(--page); color: var(--text);
  font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.5rem; margin: 0; }
.total { margin: .25rem 0 1rem; font-size: 1.05rem; }
.bar { display: flex; height: 6px; border-radius: 3px; overflow: hidden; background: var(--good); }
.bar i { background: var(--bad); }
.help { display: flex; flex-wrap: wrap; gap: .35rem 1.1rem; margin: 1rem 0 1.5rem; color: var(--soft); font-size: .87rem; }
.help b { display: inline-block; width: 1.6em; height: .85em; margin-right: .4em; border: 1px solid var(--line);
  border-radius: 2px; vertical-align: -.08em; }
.case { background: var(--card); border: 1px solid var(--line); border-left: 4px solid var(--good); border-radius: 6px;
  margin-bottom: .75rem; }
.case.failed { border-left-color: var(--bad); }
summary { display: flex; flex-wrap: wrap; align-items: baseline; gap: .2rem .75rem; padding: .6rem .9rem; cursor: pointer; }
summary::before { content: "\25b8"; width: .6rem; color: var(--soft); }
details[open] > summary::before { content: "\25be"; }
summary h2 { font: 600 1rem ui-monospace, monospace; margin: 0; overflow-wrap: anywhere; }
.sentence { flex: 1 0 100%; padding-left: 1.1rem; color: var(--soft); overflow-wrap: anywhere; }
.failed .sentence { color: var(--text); }
.verdict { padding: 0 .55em; border-radius: 1em; font-size: .82rem; font-weight: 600; white-space: nowrap;
  color: var(--good); background: var(--goodBack); }
.failed .verdict { color: var(--bad); background: var(--badBack); }
.body { padding: .25rem .9rem .9rem 2rem; }
.pictures { display: grid; grid-template-columns: repeat(3, 1fr); gap: .9rem; }
figure { margin: 0; }
figcaption { font-size: .85rem; color: var(--soft); margin-bottom: .25rem; }
.picture { display: block; width: 100%; min-height: 3rem; padding: 0; border: 0; box-shadow: 0 0 0 1px var(--line);
  background: center / contain no-repeat #000; image-rendering: pixelated; cursor: zoom-in; }
.expected, .actual.swaps:hover, .actual.swaps:focus-visible { background-image: var(--expected); }
.actual, .expected.swaps:hover, .expected.swaps:focus-visible { background-image: var(--actual); }
.difference { background-image: var(--difference); }
:focus-visible { outline: 2px solid var(--focus); outline-offset: 2px; }
.numbers { overflow-x: auto; margin-top: .9rem; }
table { border-collapse: collapse; font: .82rem/1.5 ui-monospace, monospace; white-space: nowrap; }
th, td { padding: .1rem .8rem .1rem 0; text-align: right; font-variant-numeric: tabular-nums; }
th { font-weight: 400; color: var(--soft); border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; }
tr.over td { color: var(--bad); font-weight: 600; }
.counts { margin: .5rem 0 0; font-size: .85rem; color: var(--soft); }
dialog { border: 1px solid var(--line); border-radius: 6px; padding: .75rem; background: var(--card); color: var(--text);
  max-width: 96vw; max-height: 96vh; }
dialog::backdrop { background: #000a; }
dialog p { margin: 0 0 .5rem; }
dialog .picture { width: min(90vw, 84vh * var(--ratio)); cursor: zoom-out; }
@media (max-width: 40rem) { .pictures { grid-template-columns: 1fr; } }
)css";
}

std::string_view reportScript() {
    return R"js(
const dialog = document.querySelector('dialog');
const large = dialog.querySelector('.picture');
const words = { expected: 'Expected', actual: 'Actual', difference: 'Difference' };
let shownCase, shownKind;

function show(kind) {
  shownKind = kind;
  const style = getComputedStyle(shownCase.querySelector('.pictures'));
  large.style.backgroundImage = style.getPropertyValue('--' + kind);
  large.style.aspectRatio = style.getPropertyValue('--ratio');
  large.style.setProperty('--ratio', style.getPropertyValue('--ratio'));
  dialog.querySelector('p').textContent = words[kind] + ': ' + shownCase.querySelector('h2').textContent +
    '  (left and right arrow: the other pictures, Esc: close)';
}

document.addEventListener('click', event => {
  const picture = event.target.closest('.picture');
  if (dialog.open) {
    if (event.target === dialog || picture === large) dialog.close();
  } else if (picture) {
    shownCase = picture.closest('.case');
    show(picture.dataset.kind);
    dialog.showModal();
  }
});
dialog.addEventListener('keydown', event => {
  const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (!step) return;
  const kinds = [...shownCase.querySelectorAll('.picture')].map(picture => picture.dataset.kind);
  show(kinds[(kinds.indexOf(shownKind) + step + kinds.length) % kinds.length]);
  event.preventDefault();
});
)js";
}

}  // namespace raytorus::image
