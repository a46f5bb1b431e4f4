// The instant of the pictures over time: one range, a line in every panel, a point in the plane, and the values as they were computed.
export const $ = (selector) => document.querySelector(selector);
export const all = (selector) => [...document.querySelectorAll(selector)];
const SVG = 'http://www.w3.org/2000/svg';
const OVER_TIME = ['#plot-cycle', '#plot-heat', '#plot-energy', '#plot-bearing-load', '#plot-simulation'];
export const panels = (figure) => [...figure.querySelectorAll('g.plane[data-x-min]')];
export const overTime = () => OVER_TIME.map($).filter((figure) => figure && panels(figure).length > 0);
export const isOverTime = (figure) => OVER_TIME.includes('#' + figure.id);
export const numbers = (panel) => Object.fromEntries(['left', 'right', 'top', 'bottom', 'xMin', 'xMax', 'yMin', 'yMax'].map((key) => [key, Number(panel.dataset[key])]));
export const xOf = (p, value) => p.left + (value - p.xMin) / (p.xMax - p.xMin) * (p.right - p.left);
export const yOf = (p, value) => p.bottom - (value - p.yMin) / (p.yMax - p.yMin) * (p.bottom - p.top);
export const atX = (p, x) => p.xMin + (x - p.left) / (p.right - p.left) * (p.xMax - p.xMin);
export const atY = (p, y) => p.yMin + (p.bottom - y) / (p.bottom - p.top) * (p.yMax - p.yMin);
// Where a pointer is in a picture: its plane and the place in it.
export function inside(event) {
  const svg = event.target.closest?.('figure.plot .frame')?.querySelector('svg');
  const figure = svg?.closest('figure');
  if (!svg || !panels(figure).length) return null;
  const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  const panel = panels(figure).find((each) => { const p = numbers(each); return place.x >= p.left && place.x <= p.right && place.y >= p.top && place.y <= p.bottom; });
  return panel ? { figure, panel, p: numbers(panel), x: place.x, y: place.y } : null;
}
// What is drawn over a panel, once of each kind.
export function marked(panel, kind, name) {
  let mark = panel.querySelector(`.${name}`);
  if (!mark) {
    mark = document.createElementNS(SVG, kind);
    mark.setAttribute('class', name);
    panel.append(mark);
  }
  return mark;
}
export function line(panel, at) {
  const p = numbers(panel);
  const mark = marked(panel, 'line', 'cursor-line');
  const x = xOf(p, at);
  for (const [key, value] of [['x1', x], ['x2', x], ['y1', p.top], ['y2', p.bottom]]) mark.setAttribute(key, value);
  mark.style.display = at < p.xMin || at > p.xMax ? 'none' : '';
}

// The window of time that is shown.
export function span() {
  const figure = overTime()[0];
  if (figure) { const p = numbers(panels(figure)[0]); return [p.xMin, p.xMax]; }
  const until = Number($('#instant')?.dataset.until);
  return until > 0 ? [0, until] : null;
}
let instant = 0;
export const now = () => instant;
export function stand(time) {
  instant = time;
  keep();
  cursor();
}
// The range stands where the instant is, or at the end next to it.
export function keep() {
  const range = $('#instant');
  const shown = span();
  if (range && shown) range.value = 1000 * (Math.min(Math.max(instant, shown[0]), shown[1]) - shown[0]) / (shown[1] - shown[0]);
}
document.addEventListener('input', ({ target }) => {
  const shown = span();
  if (target.id !== 'instant' || !shown) return;
  instant = shown[0] + (shown[1] - shown[0]) * Number(target.value) / 1000;
  cursor();
});
export function cursor() {
  const range = $('#instant');
  const shown = span();
  if (!range || !shown) return;
  instant = Math.min(Math.max(0, instant), Number(range.dataset.until) || shown[1]);
  soon();
  const groups = isCurrent() ? held(instant) : null;
  const time = groups ? snapped(groups, instant, shown[1] - shown[0]) : instant;
  for (const figure of overTime()) for (const panel of panels(figure)) line(panel, time);
  const place = $('#instant-values');
  place.toggleAttribute('data-old', !groups);
  if (!groups && place.childElementCount > 0) return;
  const values = groups ? groups.flatMap((group) => read(group, time)) : [];
  const digits = digitsOf(shown[1] - shown[0]);
  const of = (symbol) => values.find((each) => each.name[0] === symbol)?.value;
  // The plane has a point for its two.
  const row = overTime().length > 0 ? values : values.filter(({ name }) => name[0] === 'n' || name[0] === 'T');
  written(place, [{ name: ['t', 's', ''], value: time, digits, width: formatted(shown[1], digits).length }, ...row]);
  range.setAttribute('aria-valuetext', [...place.children].map((cell) => [...cell.children].map((part) => part.textContent).join(' ')).join(', '));
  point(of('n'), of('T'));
  // The drawing of the mechanism goes along: by the angle of the output, or by the way along the line in millimetres.
  const angle = of('φ');
  const position_rad = angle !== undefined ? angle * Math.PI / 180 : of('x') / 1000 / Number($('svg.drawn')?.dataset.perOutput);
  dispatchEvent(new CustomEvent('antrieb:instant', { detail: { time, position_rad } }));
}
function point(speed, torque) {
  const panel = $('#plot-torque-speed g.plane[data-x-min]');
  if (!panel || speed === undefined || torque === undefined) return;
  const p = numbers(panel);
  const mark = marked(panel, 'circle', 'cursor-point');
  for (const [key, value] of [['r', 5], ['cx', xOf(p, speed)], ['cy', yOf(p, torque)]]) mark.setAttribute(key, value);
}

// A row of values: as many cells as there are values, each as wide as its widest value.
export function written(place, values) {
  while (place.childElementCount < values.length) place.append(cell());
  while (place.childElementCount > values.length) place.lastChild.remove();
  values.forEach(({ name: [symbol, unit, label], value, digits, width }, number) => {
    const [sign, amount, of] = place.children[number].children;
    named(sign, symbol, label);
    const text = value === null ? '' : formatted(value, digits);
    if (amount.textContent !== text) amount.textContent = text;
    if (amount.dataset.wide !== String(width)) { amount.dataset.wide = width; amount.style.minWidth = `${width}ch`; }
    if (of.textContent !== unit) of.textContent = unit;
  });
  place.classList.toggle('many', values.length > 7);
}
function cell() {
  const span = document.createElement('span');
  span.append(document.createElement('i'), document.createElement('b'), document.createElement('i'));
  return span;
}
// A symbol with what stands below its line, and the name of the curve where its picture has several.
function named(place, symbol, label) {
  if (place.dataset.of === symbol + label) return;
  place.dataset.of = symbol + label;
  place.title = label;
  const [stem, below] = symbol.split('_');
  place.replaceChildren(stem);
  if (below) place.append(Object.assign(document.createElement('sub'), { textContent: below }));
  if (label) place.append(symbol ? ` ${label}` : label);
}
// How numbers are written, made once for each language and number of digits: a curve has the decimals of its largest value.
const formats = new Map();
function formatted(value, digits) {
  if (!Number.isFinite(value)) return '–';
  // As everywhere on the page: nothing between the digits of a number, and a power of ten from a million on.
  const [mantissa, power] = Math.abs(value) >= 1e6 ? value.toExponential(3).split('e+') : [value, ''];
  const decimals = power ? 3 : digits;
  const name = document.documentElement.lang + decimals;
  if (!formats.has(name)) formats.set(name, new Intl.NumberFormat(document.documentElement.lang, { minimumFractionDigits: decimals, maximumFractionDigits: decimals, signDisplay: 'negative', useGrouping: false }));
  const text = formats.get(name).format(mantissa).replace('-', '\u2212');
  return power ? `${text}·10${[...power].map((digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit]).join('')}` : text;
}
const digitsOf = (most) => (most > 0 ? Math.min(6, Math.max(0, 3 - Math.floor(Math.log10(most)))) : 0);

// The values as they were computed are fetched for each picture that stays, at once if the cursor is used. A line shows only what a
// pixel can show, so that nothing is read from it: until the values are there, those of before are shown as old.
let whole = null, fine = null, seen = -1, waits = null, running = null;
let answers = 0;
// A request that is not sent after all has no answer: what it put off is resumed.
document.addEventListener('htmx:before:request', () => { clearTimeout(waits); running?.abort(); soon(); });
document.addEventListener('htmx:after:swap', () => { answers += 1; });
const isCurrent = () => seen === answers && whole !== null;
function soon() {
  clearTimeout(waits);
  if (seen !== answers) waits = setTimeout(() => { if ($('.htmx-request')) soon(); else fetched(); }, 300);
}
// Of the pictures of the pane, those over time; in another language or size they are the same.
export function asked(view) {
  const fields = new URLSearchParams(new FormData($('#state')));
  for (const name of ['width', 'height', 'theme', 'from', 'until', 'list', 'sort', 'unfolded', 'mark']) fields.delete(name);
  if (view) fields.set('view', view);
  const code = $('#view')?.dataset.code;
  if (code) fields.set('code', code);
  return fields;
}
export async function computed(fields, signal) {
  const reply = await fetch('/values', { method: 'POST', body: fields, signal }).catch(() => null);
  const found = reply?.ok ? await reply.json().catch(() => null) : null;
  found?.groups.forEach((group) => {
    const size = (y) => y.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    group.digits = group.y.map((y) => digitsOf(size(y)));
    group.width = group.y.map((y, curve) => [Math.min, Math.max].reduce((most, of) => Math.max(most, formatted(y.reduce((a, b) => of(a, b), 0), group.digits[curve]).length), 1));
  });
  return found;
}
async function fetched() {
  if (seen === answers || !$('#instant') || !$('#state')) return;
  const [of, run] = [answers, new AbortController()];
  running?.abort();
  running = run;
  const fields = asked(overTime().length > 0 ? '' : 'cycle');
  const body = fields.toString();
  if (whole?.body !== body) {
    const found = await computed(fields, run.signal);
    if (run.signal.aborted || of !== answers || !found) return;
    [whole, fine] = [{ body, groups: found.groups }, null];
  }
  // A long recording is reduced: a window of it is fetched by itself.
  const window = ['from', 'until'].map((name) => $(`#state [name=${name}]`)?.value ?? '');
  const of_window = window.join(' ');
  if (window[0] === '' || !whole.groups.some((group) => group.reduced)) fine = null;
  else if (fine?.window !== of_window) {
    ['from', 'until'].forEach((name, place) => fields.set(name, window[place]));
    const found = await computed(fields, run.signal);
    if (run.signal.aborted || of !== answers || !found) return;
    fine = { window: of_window, groups: found.groups };
  }
  seen = of;
  cursor();
}
const held = (time) => (fine?.groups.every(({ x }) => x.length > 0 && x[0] <= time && time <= x[x.length - 1]) ? fine.groups : whole.groups);
for (const kind of ['input', 'focusin', 'pointerdown']) document.addEventListener(kind, (event) => {
  if (event.target.id === 'instant' || event.target.closest?.('figure.plot, [data-play], [data-instant]')) fetched();
});
// The last place that is not behind another.
function before(x, at) {
  let low = 0, high = x.length;
  while (high - low > 1) { const middle = (low + high) >> 1; if (x[middle] <= at) low = middle; else high = middle; }
  return low;
}
// Where rows are closer than the range resolves, the instant is that of a row.
function snapped(groups, time, long) {
  const x = groups[0]?.x ?? [];
  const low = before(x, time);
  const high = Math.min(low + 1, x.length - 1);
  if (x.length < 2 || x[high] - x[low] > long / 500) return time;
  return time - x[low] < x[high] - time ? x[low] : x[high];
}
function read({ names, x, y, digits, width }, time) {
  if (x.length === 0) return [];
  const tiny = 1e-12 * (Math.abs(x[0]) + Math.abs(x[x.length - 1]));
  const low = before(x, time + tiny);
  let rows = [];
  for (let row = low; row >= 0 && Math.abs(x[row] - time) <= 2 * tiny; row--) rows.push(row);
  // At a jump the row shows the side with the larger torque, as the checks do.
  const torque = names.findIndex(([symbol]) => symbol === 'T');
  if (rows.length > 1 && torque >= 0) rows.sort((a, b) => Math.abs(y[torque][b]) - Math.abs(y[torque][a]));
  const value = (of) => (rows.length > 0 ? of[rows[0]] : between(x, of, low, time, tiny));
  return names.map((name, curve) => ({ name, value: value(y[curve]), digits: digits[curve], width: width[curve] }));
}
// Between rows: through four of them that no jump parts, which is exact to the digits shown for every law; else in a straight line.
function between(x, y, low, at, tiny) {
  let [a, b] = [low, Math.min(low + 1, x.length - 1)];
  const left = () => a > 0 && x[a] - x[a - 1] > 2 * tiny;
  const right = () => b < x.length - 1 && x[b + 1] - x[b] > 2 * tiny;
  if (left()) a -= 1;
  if (right()) b += 1;
  while (b - a < 3 && left()) a -= 1;
  while (b - a < 3 && right()) b += 1;
  let sum = 0;
  for (let i = a; i <= b; i++) {
    let share = 1;
    for (let j = a; j <= b; j++) if (j !== i) share *= (at - x[j]) / (x[i] - x[j]);
    sum += share * y[i];
  }
  return a === b ? y[a] : sum;
}
