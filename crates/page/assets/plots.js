// What moves in the pictures: the instant, the window of time, marks, and the ends of segments that are pulled.
const $ = (selector) => document.querySelector(selector);
const all = (selector) => [...document.querySelectorAll(selector)];
const SVG = 'http://www.w3.org/2000/svg';
const OVER_TIME = ['#plot-cycle', '#plot-heat', '#plot-energy', '#plot-bearing-load', '#plot-simulation'];
const panels = (figure) => [...figure.querySelectorAll('g.plane[data-x-min]')];
const overTime = () => OVER_TIME.map($).filter((figure) => figure && panels(figure).length > 0);
const numbers = (panel) => Object.fromEntries(['left', 'right', 'top', 'bottom', 'xMin', 'xMax', 'yMin', 'yMax'].map((key) => [key, Number(panel.dataset[key])]));
const xOf = (p, value) => p.left + (value - p.xMin) / (p.xMax - p.xMin) * (p.right - p.left);
const yOf = (p, value) => p.bottom - (value - p.yMin) / (p.yMax - p.yMin) * (p.bottom - p.top);
const atX = (p, x) => p.xMin + (x - p.left) / (p.right - p.left) * (p.xMax - p.xMin);
const atY = (p, y) => p.yMin + (p.bottom - y) / (p.bottom - p.top) * (p.yMax - p.yMin);
const first = () => { const figure = overTime()[0]; return figure && numbers(panels(figure)[0]); };

// One range moves the instant of every picture over time, and the point in the plane.
let instant = 0;
export function cursor() {
  const range = $('#instant');
  const p = first();
  if (!range || !p) return;
  const time = p.xMin + (p.xMax - p.xMin) * Number(range.value) / 1000;
  instant = time;
  for (const figure of overTime()) for (const panel of panels(figure)) line(panel, time);
  const values = read(overTime()[0], time);
  soonExact();
  const shown = (value, digits, drawn) => (drawn ? '≈\u202f' : '') + format(digits).format(value).replace('-', '\u2212');
  const all = [{ symbol: 't', value: time, unit: 's', digits: 4 }, ...values];
  const place = $('#instant-values');
  while (place.childElementCount < all.length) place.append(cell());
  while (place.childElementCount > all.length) place.lastChild.remove();
  all.forEach(({ symbol, label, value, unit, digits, drawn }, number) => {
    const [name, amount, of] = place.children[number].children;
    named(name, symbol, label);
    amount.textContent = shown(value, digits, drawn);
    of.textContent = unit;
  });
  range.setAttribute('aria-valuetext', [...place.children].map((cell) => [...cell.children].map((part) => part.textContent).join(' ')).join(', '));
  point(values);
  // The drawing of the mechanism goes along: by the angle of the output, or by the way along the line in millimetres.
  const [angle, way] = ['φ', 'x'].map((symbol) => values.find((each) => each.symbol === symbol)?.exact);
  const position_rad = angle !== undefined ? angle * Math.PI / 180 : way / 1000 / Number($('svg.drawn')?.dataset.perOutput);
  dispatchEvent(new CustomEvent('antrieb:instant', { detail: { time, position_rad } }));
}
// How numbers are written, made once for each language and number of digits.
const formats = new Map();
function format(digits) {
  const name = document.documentElement.lang + digits;
  if (!formats.has(name)) formats.set(name, new Intl.NumberFormat(document.documentElement.lang, { maximumSignificantDigits: 4, maximumFractionDigits: digits, roundingPriority: 'lessPrecision', signDisplay: 'negative' }));
  return formats.get(name);
}
// A symbol with what stands below its line, and the name of the curve where its picture has several.
function named(place, symbol, label = '') {
  if (place.dataset.of === symbol + label) return;
  place.dataset.of = symbol + label;
  const [stem, below] = symbol.split('_');
  place.replaceChildren(stem);
  if (below) place.append(Object.assign(document.createElement('sub'), { textContent: below }));
  if (label) place.append(` ${label}`);
}
function cell() {
  const span = document.createElement('span');
  span.append(document.createElement('i'), document.createElement('b'), document.createElement('i'));
  return span;
}
// What is drawn over a panel, once of each kind.
function marked(panel, kind, name) {
  let mark = panel.querySelector(`.${name}`);
  if (!mark) {
    mark = document.createElementNS(SVG, kind);
    mark.setAttribute('class', name);
    panel.append(mark);
  }
  return mark;
}
function line(panel, time) {
  const p = numbers(panel);
  const mark = marked(panel, 'line', 'cursor-line');
  const x = xOf(p, time);
  for (const [key, value] of [['x1', x], ['x2', x], ['y1', p.top], ['y2', p.bottom]]) mark.setAttribute(key, value);
}
// The value of each curve at an instant, read from its line: the numbers of a path stand in the order of time, read once.
const lines = new WeakMap();
function points(path) {
  const written = path.getAttribute('d');
  let known = lines.get(path);
  if (known?.written !== written) {
    const found = (written.match(/-?\d+(\.\d+)?/g) ?? []).map(Number);
    known = { written, x: found.filter((_, place) => place % 2 === 0), y: found.filter((_, place) => place % 2 === 1) };
    lines.set(path, known);
  }
  return known;
}
// The curves as they were computed are fetched for each picture that stays, at once if the cursor is used: a line tells only what
// a pixel can tell. Until then what is read from the line has a sign for it.
let exact = null;
let soon = null;
// An answer may change the lines of a picture and keep its element. While one is on its way, nothing else is asked.
let answers = 0;
let asking = null;
document.addEventListener('htmx:before:request', () => { clearTimeout(soon); asking?.abort(); });
document.addEventListener('htmx:after:swap', () => { answers += 1; });
const isExact = () => exact?.answers === answers;
function soonExact() {
  clearTimeout(soon);
  const figure = overTime()[0];
  if (figure && !isExact()) soon = setTimeout(fetchCurves, 400);
}
async function fetchCurves() {
  if (isExact()) return;
  const fields = new URLSearchParams(new FormData($('#state')));
  fields.set('lang', 'en');
  const body = fields.toString();
  // What is asked for the same state has the same curves.
  if (exact?.body === body) { exact.answers = answers; if (exact.columns) cursor(); return; }
  const own = exact = { answers, body, columns: null };
  asking?.abort();
  asking = new AbortController();
  const reply = await fetch('/curves', { method: 'POST', body: fields, signal: asking.signal }).catch(() => null);
  if (exact !== own) return;
  const text = reply?.ok ? await reply.text().catch(() => null) : null;
  if (text === null) { if (exact === own) exact = null; return; }
  const columns = [];
  for (const block of text.split('\n\n').filter((each) => each.trim())) {
    const rows = block.trim().split('\n').slice(1).map((row) => row.split('\t').map(Number));
    const x = rows.map((row) => row[0]);
    for (let column = 1; column < (rows[0]?.length ?? 0); column++) columns.push({ x, y: rows.map((row) => row[column]) });
  }
  own.columns = columns;
  cursor();
}
for (const kind of ['input', 'focusin', 'pointerdown']) document.addEventListener(kind, (event) => {
  const figure = overTime()[0];
  if (figure && (event.target.id === 'instant' || event.target.closest?.('figure.plot, [data-play], [data-instant]'))) fetchCurves();
});
function at(x, y, place) {
  let low = 0, high = x.length - 1;
  while (high - low > 1) { const middle = (low + high) >> 1; if (x[middle] <= place) low = middle; else high = middle; }
  const share = x[high] > x[low] ? Math.min(1, Math.max(0, (place - x[low]) / (x[high] - x[low]))) : 0;
  return y[low] + share * (y[high] - y[low]);
}
function read(figure, time) {
  const found = [];
  let number = 0;
  const columns = isExact() ? exact.columns : null;
  for (const panel of panels(figure)) {
    const p = numbers(panel);
    const { symbol, unit } = panel.dataset;
    const curves = panel.querySelectorAll('g.line');
    for (const curve of curves) {
      const path = curve.querySelector('path');
      if (!path) continue;
      const column = columns?.[number++];
      const { x, y } = column ?? points(path);
      const value = column ? at(x, y, time) : atY(p, at(x, y, xOf(p, time)));
      // A line is drawn to a hundredth of a pixel, a curve thinned to a fine part of its range: no more digits than that.
      const step = (p.yMax - p.yMin) / (column ? 2e4 : (p.bottom - p.top) * 20);
      found.push({ drawn: !column, symbol, label: curves.length > 1 ? curve.dataset.label ?? '' : '', unit, exact: value, value: Math.round(value / step) * step + 0, digits: Math.max(0, Math.min(6, 1 - Math.ceil(Math.log10(step)))) });
    }
  }
  return found;
}
function point(values) {
  const figure = $('#plot-torque-speed');
  const panel = figure && panels(figure)[0];
  const speed = values.find((each) => each.symbol === 'n');
  const torque = values.find((each) => each.symbol === 'T');
  if (!panel || !speed || !torque) return;
  const p = numbers(panel);
  const mark = marked(panel, 'circle', 'cursor-point');
  for (const [key, value] of [['r', 5], ['cx', xOf(p, speed.value)], ['cy', yOf(p, torque.value)]]) mark.setAttribute(key, value);
}
document.addEventListener('input', (event) => { if (event.target.id === 'instant') cursor(); });

// To an instant; where it lies outside of what is shown, the whole cycle is shown again.
let wanted = null;
export function jump(time) {
  const range = $('#instant');
  const p = first();
  if (!range || !p) return;
  if (time < p.xMin || time > p.xMax) { wanted = time; show(null); return; }
  range.value = 1000 * (time - p.xMin) / (p.xMax - p.xMin);
  cursor();
  range.focus();
}

// How wide a picture is: read once and then kept up to date by the browser, since reading it forces a layout.
const widths = new WeakMap();
const watcher = new ResizeObserver((entries) => {
  let changed = false;
  for (const { target } of entries) { changed ||= widths.get(target) !== target.clientWidth; widths.set(target, target.clientWidth); }
  if (changed) overlay();
});
function width(figure) {
  if (!widths.has(figure)) { widths.set(figure, figure.clientWidth); watcher.observe(figure); }
  return widths.get(figure);
}

// Marks and grips stand where their numbers belong in the picture that was drawn last.
export function overlay() {
  for (const figure of overTime()) {
    const box = figure.querySelector('.frame > svg').viewBox.baseVal;
    const p = numbers(panels(figure)[0]);
    let until = -Infinity;
    for (const mark of figure.querySelectorAll('.marks-row .mark-number')) {
      const time = Number(mark.dataset.instant);
      mark.hidden = time < p.xMin || time > p.xMax;
      if (mark.hidden) continue;
      // What would cover the one before stands beside it.
      const x = Math.max(xOf(p, time) / box.width, until + 25 / width(figure));
      until = x;
      mark.style.left = `${100 * x}%`;
    }
  }
  for (const grip of all('.grip')) if (held()?.grip !== grip) put(grip, Number(grip.dataset.time), Number(grip.dataset.way));
  if (wanted !== null) { const time = wanted; wanted = null; const p = first(); if (p && time >= p.xMin && time <= p.xMax) jump(time); }
  else keep();
}
// The instant stays the same when another window is shown.
function keep() {
  const range = $('#instant');
  const p = first();
  if (range && p && instant > p.xMin && instant <= p.xMax) range.value = 1000 * (instant - p.xMin) / (p.xMax - p.xMin);
}
function put(grip, time, way) {
  const p = first();
  const frame = grip.closest('.frame');
  if (!p || !frame) return;
  const box = frame.querySelector('svg').viewBox.baseVal;
  const out = time < p.xMin || time > p.xMax || way < p.yMin - 1e-9 * Math.abs(p.yMin) || way > p.yMax + 1e-9 * Math.abs(p.yMax);
  grip.hidden = out && held()?.grip !== grip;
  grip.style.left = `${100 * xOf(p, time) / box.width}%`;
  grip.style.top = `${100 * Math.min(p.bottom, Math.max(p.top, yOf(p, way))) / box.height}%`;
}

// A window of time is a part of the state; the picture of it is drawn anew.
const state = (name) => $(`#state [name=${name}]`);
function show(window) {
  const held = window && window[1] > window[0] ? window : ['', ''];
  state('from').value = held[0];
  state('until').value = held[1];
  htmx.ajax('POST', '/work', { source: $('#instant') });
}
function zoom(what, at = instant) {
  const p = first();
  if (!p) return;
  const [length, end] = [p.xMax - p.xMin, Number($('#instant').dataset.until)];
  const within = (from, long) => {
    const start = Math.min(Math.max(0, from), Math.max(0, end - long));
    return long >= end * 0.999 ? null : [start, start + long];
  };
  const share = length > 0 ? Math.min(1, Math.max(0, (at - p.xMin) / length)) : 0.5;
  if (what === 'in' && length > end / 2000) show(within(at - share * length / 2, length / 2));
  else if (what === 'out') show(within(at - share * length * 2, length * 2));
  else if (what === 'back') show(within(p.xMin - length / 2, length));
  else if (what === 'on') show(within(p.xMin + length / 2, length));
  else if (what === 'whole') show(null);
}
document.addEventListener('click', (event) => { const button = event.target.closest?.('[data-zoom]'); if (button) zoom(button.dataset.zoom); });
document.addEventListener('keydown', (event) => {
  if (event.target.id !== 'instant' || event.ctrlKey || event.metaKey || event.altKey) return;
  const what = { '+': 'in', '-': 'out', 0: 'whole' }[event.key];
  if (what) { event.preventDefault(); zoom(what); }
});
function inside(event) {
  const svg = event.target.closest?.('figure.plot .frame')?.querySelector('svg');
  const figure = svg?.closest('figure');
  if (!svg || !panels(figure).length) return null;
  const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  const panel = panels(figure).find((each) => { const p = numbers(each); return place.x >= p.left && place.x <= p.right && place.y >= p.top && place.y <= p.bottom; });
  return panel ? { figure, panel, p: numbers(panel), x: place.x, y: place.y } : null;
}
const isOverTime = (found) => found && OVER_TIME.includes('#' + found.figure.id);
document.addEventListener('wheel', (event) => {
  if (!event.ctrlKey) return;
  const found = inside(event);
  if (!isOverTime(found)) return;
  event.preventDefault();
  zoom(event.deltaY < 0 ? 'in' : 'out', atX(found.p, found.x));
}, { passive: false });
document.addEventListener('dblclick', (event) => { if (isOverTime(inside(event))) zoom('whole'); });

// A drag over a picture chooses a window; a click sets the instant, or in the map of candidates looks at one.
let band = null;
document.addEventListener('pointerdown', (event) => {
  if (event.button !== 0 || event.target.closest?.('.grip')) return;
  const found = inside(event);
  if (!found) return;
  if (isOverTime(found) && event.pointerType !== 'touch') { band = { ...found, from: found.x }; event.preventDefault(); }
  else band = { ...found, from: null };
});
document.addEventListener('pointermove', (event) => {
  if (!band || band.from === null) return;
  const svg = band.figure.querySelector('svg');
  const x = Math.min(band.p.right, Math.max(band.p.left, new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse()).x));
  band.x = x;
  for (const panel of panels(band.figure)) {
    const p = numbers(panel);
    const mark = marked(panel, 'rect', 'chosen');
    for (const [key, value] of [['x', Math.min(x, band.from)], ['width', Math.abs(x - band.from)], ['y', p.top], ['height', p.bottom - p.top]]) mark.setAttribute(key, value);
  }
});
document.addEventListener('pointerup', (event) => {
  if (!band) return;
  const { figure, p, from, x } = band;
  band = null;
  for (const mark of figure.querySelectorAll('.chosen')) mark.remove();
  if (from !== null && Math.abs(x - from) > 6) show([atX(p, Math.min(x, from)), atX(p, Math.max(x, from))]);
  else if (OVER_TIME.includes('#' + figure.id)) { if (event.detail < 2) jump(atX(p, x)); }
  else if (figure.id === 'plot-map') {
    const found = inside(event);
    if (found) htmx.ajax('POST', '/work', { source: $('#state'), values: { code: '', near: [atX(p, found.x), atY(p, found.y), p.xMax - p.xMin, p.yMax - p.yMin].join(' ') } });
  }
});
document.addEventListener('pointercancel', () => { band = null; });

// The end of a segment is pulled: by pointer, or by the arrow keys. It moves in steps of 1, 2, 5 that a pixel can resolve.
function step(perPixel) {
  const power = 10 ** Math.floor(Math.log10(perPixel));
  return power * [1, 2, 5, 10].find((each) => each * power >= perPixel * 0.999);
}
const snapped = (value, by) => Number((Math.round(value / by) * by).toPrecision(9));
let pull = null, keyed = null, ending = null;
const held = () => pull ?? keyed ?? ending;
// The text at which the pull that is under way began; of an element, where it is the one that is pulled.
export const base = (element) => (element && held()?.grip.id !== element.id ? undefined : held()?.base);
function begin(grip) {
  const p = first();
  const svg = grip.closest('.frame').querySelector('svg');
  const perPixel = 1 / (svg.getScreenCTM().a || 1);
  const of = Object.fromEntries(['fromTime', 'fromWay', 'time', 'way'].map((key) => [key, Number(grip.dataset[key])]));
  return { grip, base: $('#text').value, svg, p, of, path: grip.dataset.path, goes: grip.dataset.goes === 'true', steps: [step((p.xMax - p.xMin) / (p.right - p.left) * perPixel), step((p.yMax - p.yMin) / (p.bottom - p.top) * perPixel)], busy: false, next: null };
}
// As they are to be, and as they were, both from the beginning of the segment.
function aim(of, time, way) {
  const [byTime, byWay] = of.steps;
  const { fromTime, fromWay } = of.of;
  const long = Math.max(byTime, snapped(time - fromTime, byTime));
  const stated = of.of.way - fromWay;
  let far = of.goes ? snapped(way - fromWay, byWay) : stated;
  if (of.goes && far === 0) far = Math.sign(stated) * byWay;
  return { long, far, pulled: [long, far, of.of.time - fromTime, stated].join(' '), time: fromTime + long, way: fromWay + far };
}
async function send(of, found) {
  of.next = found;
  if (of.busy) return;
  of.busy = true;
  while (of.next) {
    const { pulled } = of.next;
    of.next = null;
    await htmx.ajax('POST', '/work', { source: of.grip, values: { path: of.path, pulled } });
  }
  of.busy = false;
}
async function end(of) {
  ending = of;
  while (of.busy) await new Promise((resolve) => setTimeout(resolve, 20));
  ending = null;
  dispatchEvent(new Event('antrieb:pulled'));
  overlay();
}
document.addEventListener('pointerdown', (event) => {
  const grip = event.target.closest?.('.grip');
  if (!grip || event.button !== 0 || held()) return;
  event.preventDefault();
  grip.focus();
  grip.setPointerCapture(event.pointerId);
  pull = begin(grip);
});
document.addEventListener('pointermove', (event) => {
  if (!pull) return;
  const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(pull.svg.getScreenCTM().inverse());
  const found = aim(pull, atX(pull.p, place.x), atY(pull.p, place.y));
  if (found.pulled === pull.last) return;
  pull.last = found.pulled;
  put(pull.grip, found.time, found.way);
  send(pull, found);
});
for (const kind of ['pointerup', 'pointercancel']) document.addEventListener(kind, () => { if (pull) { const done = pull; pull = null; end(done); } });
document.addEventListener('keydown', (event) => {
  const grip = event.target.closest?.('.grip');
  const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
  if (!grip || !way || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  if (held() && keyed?.grip !== grip) return;
  if (!keyed) { keyed = begin(grip); keyed.at = [keyed.of.time, keyed.of.way]; }
  clearTimeout(keyed.letGo);
  const many = event.shiftKey ? 10 : 1;
  const found = aim(keyed, keyed.at[0] + way[0] * many * keyed.steps[0], keyed.at[1] + way[1] * many * keyed.steps[1]);
  keyed.at = [found.time, found.way];
  put(grip, found.time, found.way);
  send(keyed, found);
});
// Keys that follow each other are one step of undo.
function idle() { if (keyed?.busy) keyed.letGo = setTimeout(idle, 500); else letGo(); }
function letGo() { if (keyed) { const done = keyed; keyed = null; clearTimeout(done.letGo); end(done); } }
document.addEventListener('keyup', (event) => { if (keyed && event.target === keyed.grip) { clearTimeout(keyed.letGo); keyed.letGo = setTimeout(idle, 500); } });
document.addEventListener('focusout', (event) => { if (keyed && event.target === keyed.grip) letGo(); });
