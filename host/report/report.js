// SPDX-License-Identifier: MIT
// The script of a report. The page can be read without it.
const root = document.documentElement;
// Whoever opens the page without eyes sees here what went wrong, and below that it is ready.
addEventListener('error', event => { root.dataset.errors = (root.dataset.errors ?? '') + event.message + '\n'; });

const cases = [...document.querySelectorAll('.case')];
const filter = document.querySelector('#filter');
const failedOnly = document.querySelector('#failed');
const dialog = document.querySelector('dialog');
const large = dialog.querySelector('.picture');
const visible = () => cases.filter(shown => !shown.hidden);
const numberOf = (shown, name) => Number(shown.style.getPropertyValue(name));

function applyFilter() {
  const words = filter.value.toLowerCase().split(/\s+/).filter(word => word);
  for (const shown of cases) {
    const text = (shown.querySelector('summary').textContent + ' ' +
      (shown.querySelector('.catches')?.textContent ?? '')).toLowerCase();
    shown.hidden = !words.every(word => text.includes(word)) ||
      failedOnly.checked && !shown.classList.contains('failed');
  }
  const count = visible().length;
  document.querySelector('#shown').textContent = count + ' of ' + cases.length;
  document.querySelector('#none').hidden = count > 0 || cases.length === 0;
}

// The mark is a place in every picture of its case, the middle of the enlarged ones, and in the command to explain.
function mark(shown, x, y) {
  x = Math.max(0, Math.min(numberOf(shown, '--w') - 1, x));
  y = Math.max(0, Math.min(numberOf(shown, '--h') - 1, y));
  shown.style.setProperty('--x', x);
  shown.style.setProperty('--y', y);
  shown.classList.add('marked');
  for (const place of shown.querySelectorAll('.place')) place.textContent = `(${x}, ${y})`;
  for (const code of shown.querySelectorAll('code[data-command]')) {
    const [command, at] = [code.dataset.command, code.dataset.command.lastIndexOf('{x},{y}')];
    if (at >= 0) code.textContent = `${command.slice(0, at)}${x},${y}${command.slice(at + '{x},{y}'.length)}`;
  }
}

let enlarged, kind;
function enlarge(shown, newKind) {
  enlarged = shown;
  kind = newKind;
  large.style.cssText = shown.style.cssText;
  large.className = 'picture ' + kind;
  const picture = shown.querySelector(`.picture[data-kind=${kind}]`);
  dialog.querySelector('p').textContent = `${shown.querySelector('h2').textContent}: ` +
    `${picture.getAttribute('aria-label')}  (left and right arrow: the other pictures, Esc: close)`;
  if (!dialog.open) dialog.showModal();
}

document.addEventListener('click', event => {
  const copy = event.target.closest('.copy');
  if (copy) {
    const code = copy.parentElement.querySelector('code');
    getSelection().selectAllChildren(code);  // what a browser that refuses the clipboard leaves to Ctrl+C
    navigator.clipboard?.writeText(code.textContent).then(() => { copy.textContent = 'Copied'; }, () => {});
  }
  if (dialog.open) {
    if (event.target === dialog || event.target.closest('.picture') === large) dialog.close();
    return;
  }
  const picture = event.target.closest('button.picture');
  if (!picture) return;
  const shown = picture.closest('.case');
  if (event.detail === 0) return enlarge(shown, picture.dataset.kind);  // by the keyboard
  const box = picture.getBoundingClientRect();
  mark(shown, Math.floor((event.clientX - box.left) / box.width * numberOf(shown, '--w')),
    Math.floor((event.clientY - box.top) / box.height * numberOf(shown, '--h')));
});
document.addEventListener('dblclick', event => {
  const picture = event.target.closest('.case button.picture');
  if (picture && !dialog.open) enlarge(picture.closest('.case'), picture.dataset.kind);
});
document.addEventListener('input', event => {
  if (event.target.matches('.split input')) {
    event.target.parentElement.style.setProperty('--split', event.target.value + '%');
  } else if (event.target.matches('.gain')) {
    root.style.setProperty('--gain', event.target.value);
    for (const gain of document.querySelectorAll('.gain')) gain.value = event.target.value;
  }
});
filter.addEventListener('input', applyFilter);
failedOnly.addEventListener('input', applyFilter);
document.querySelector('#open').addEventListener('click', () => visible().forEach(shown => { shown.open = true; }));
document.querySelector('#close').addEventListener('click', () => visible().forEach(shown => { shown.open = false; }));

const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
function pressed(event) {
  const step = steps[event.key];
  const picture = event.target.closest?.('.case button.picture');
  if (dialog.open) {
    if (!step || !step[0]) return false;
    const kinds = [...enlarged.querySelectorAll('button.picture')].map(other => other.dataset.kind);
    enlarge(enlarged, kinds[(kinds.indexOf(kind) + step[0] + kinds.length) % kinds.length]);
  } else if (step && picture) {
    const shown = picture.closest('.case');
    mark(shown, numberOf(shown, '--x') + step[0], numberOf(shown, '--y') + step[1]);
  } else if (event.key === 'Escape' && event.target === filter) {
    filter.value = '';
    applyFilter();
    filter.blur();
  } else if (event.target.matches?.('input, select') || event.ctrlKey || event.metaKey || event.altKey) {
    return false;
  } else if (event.key === '/') {
    filter.focus();
  } else if (event.key === 'f') {
    failedOnly.click();
  } else if (event.key === 'j' || event.key === 'k') {
    const list = visible();
    const here = list.indexOf(document.activeElement?.closest('.case'));
    const next = list[Math.max(0, Math.min(list.length - 1, here + (event.key === 'j' ? 1 : -1)))];
    next?.querySelector('summary').focus();
    next?.scrollIntoView({ block: 'nearest' });
  } else {
    return false;
  }
  return true;
}
document.addEventListener('keydown', event => { if (pressed(event)) event.preventDefault(); });

// index.html#name is that case, and no other is open.
function followHash() {
  const name = decodeURIComponent(location.hash.slice(1));
  const named = name && cases.find(shown => shown.querySelector('h2').textContent === name);
  if (named) {
    for (const shown of cases) shown.open = shown === named;
    const top = named.getBoundingClientRect().top;
    if (top < 0 || top > innerHeight / 2) named.scrollIntoView();
  }
}
addEventListener('hashchange', followHash);
applyFilter();
followHash();
root.dataset.ready = cases.length;
