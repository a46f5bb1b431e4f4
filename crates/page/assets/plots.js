// What is moved in the pictures over time: the window of time, marks, and the ends of segments that are pulled.
import { $, all, atX, atY, cursor, inside, isOverTime, keep, marked, now, numbers, overTime, panels, stand, xOf, yOf } from './cursor.js';
export { cursor } from './cursor.js';
// The panel that a grip belongs to: that of its quantity, else the first.
function panelOf(grip) {
  const figure = overTime()[0];
  const panel = figure && panels(figure).find((each) => !grip.dataset.panel || each.dataset.symbol === grip.dataset.panel);
  return panel && numbers(panel);
}
const first = () => { const figure = overTime()[0]; return figure && numbers(panels(figure)[0]); };

// To an instant; where it lies outside of what is shown, the whole cycle is shown again.
let wanted = null;
export function jump(time) {
  const range = $('#instant');
  const p = first();
  if (!range || !p) return;
  stand(time);
  if (time < p.xMin || time > p.xMax) { wanted = time; show(null); return; }
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
function put(grip, time, way) {
  const p = panelOf(grip);
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
function zoom(what, at = now()) {
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
document.addEventListener('wheel', (event) => {
  const found = inside(event);
  // Where the pane itself scrolls, the wheel alone is for that.
  const pane = $('#view');
  if (!found || !isOverTime(found.figure) || !event.ctrlKey && pane.scrollHeight > pane.clientHeight + 1) return;
  event.preventDefault();
  zoom(event.deltaY < 0 ? 'in' : 'out', atX(found.p, found.x));
}, { passive: false });
document.addEventListener('dblclick', (event) => { const found = inside(event); if (found && isOverTime(found.figure)) zoom('whole'); });

// A drag over a picture chooses a window; a click sets the instant, or in the map of candidates looks at one.
let band = null;
document.addEventListener('pointerdown', (event) => {
  if (event.button !== 0 || event.target.closest?.('.grip')) return;
  const found = inside(event);
  if (!found) return;
  if (isOverTime(found.figure) && event.pointerType !== 'touch') { band = { ...found, from: found.x }; event.preventDefault(); }
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
  else if (isOverTime(figure)) { if (event.detail < 2) jump(atX(p, x)); }
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
  const p = panelOf(grip);
  const svg = grip.closest('.frame').querySelector('svg');
  const perPixel = 1 / (svg.getScreenCTM().a || 1);
  const of = Object.fromEntries(['fromTime', 'fromWay', 'time', 'way', 'until'].map((key) => [key, Number(grip.dataset[key])]));
  return { grip, base: $('#text').value, svg, p, of, path: grip.dataset.path, goes: grip.dataset.goes === 'true', steps: [step((p.xMax - p.xMin) / (p.right - p.left) * perPixel), step((p.yMax - p.yMin) / (p.bottom - p.top) * perPixel)], busy: false, next: null };
}
// As they are to be, and as they were, both from the beginning of the segment.
function aim(of, time, way) {
  const [byTime, byWay] = of.steps;
  const { fromTime, fromWay } = of.of;
  if (of.grip.dataset.panel) {
    // The time goes as the peak goes, against it.
    const peak = way === of.of.way ? way : Math.sign(of.of.way) * Math.max(byWay, Math.abs(way * of.of.way > 0 ? snapped(way, byWay) : 0));
    const [long, share] = [of.of.until - fromTime, of.of.way / peak];
    return { pulled: [long * share, 1, long, 1].join(' '), time: fromTime + (of.of.time - fromTime) * share, way: peak };
  }
  // What is not moved keeps its value, also where it is none of the steps.
  const long = time === of.of.time ? time - fromTime : Math.max(byTime, snapped(time - fromTime, byTime));
  const stated = of.of.way - fromWay;
  let far = of.goes && way !== of.of.way ? snapped(way - fromWay, byWay) : stated;
  if (of.goes && far === 0) far = Math.sign(stated) * byWay;
  return { long, far, pulled: [long, far, of.of.time - fromTime, stated].join(' '), time: fromTime + long, way: fromWay + far };
}
let arrived = null;
document.addEventListener('htmx:finally:request', ({ detail }) => {
  const body = detail.ctx.request?.body;
  if (body instanceof URLSearchParams && body.has('pulled')) arrived = body.get('pulled');
});
async function send(of, found) {
  of.next = found;
  if (of.busy) return;
  of.busy = true;
  while (of.next) {
    const { pulled } = of.next;
    of.next = null;
    arrived = null;
    await htmx.ajax('POST', '/work', { source: of.grip, values: { path: of.path, pulled } });
    // A request that waits for another one is not answered yet.
    for (let waits = 0; arrived !== pulled && waits < 150; waits++) await new Promise((resolve) => setTimeout(resolve, 20));
  }
  of.busy = false;
}
async function end(of) {
  ending = of;
  while (of.busy) await new Promise((resolve) => setTimeout(resolve, 20));
  ending = null;
  dispatchEvent(new Event('antrieb:pulled'));
  overlay();
  // An end outside of the picture is hidden, and cannot have the focus.
  if (document.activeElement === document.body) $('#standing')?.focus({ preventScroll: true });
}
document.addEventListener('pointerdown', (event) => {
  const grip = event.target.closest?.('.grip');
  if (!grip || event.button !== 0 || held()) return;
  event.preventDefault();
  grip.focus();
  grip.setPointerCapture(event.pointerId);
  pull = begin(grip);
  pull.from = [event.clientX, event.clientY];
});
// A hand that pulls along one axis does not hold the other one to the pixel.
const SLACK = 3;
document.addEventListener('pointermove', (event) => {
  if (!pull) return;
  const inverse = pull.svg.getScreenCTM().inverse();
  const [from, to] = [pull.from, [event.clientX, event.clientY]].map(([x, y]) => new DOMPoint(x, y).matrixTransform(inverse));
  const [sideways, upright] = [event.clientX - pull.from[0], event.clientY - pull.from[1]].map((far) => Math.abs(far) > SLACK);
  const { time, way } = pull.of;
  const found = aim(pull, sideways ? time + atX(pull.p, to.x) - atX(pull.p, from.x) : time, upright ? way + atY(pull.p, to.y) - atY(pull.p, from.y) : way);
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
