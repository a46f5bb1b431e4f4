// The cursor of the pictures over another quantity than time: a line at a place, and what each curve has there; in the map the nearest
// point. By pointer, or by the range above the picture.
import { $, all, asked, atX, atY, computed, inside, line, marked, numbers, panels, written, xOf, yOf } from './cursor.js';

const known = new Map();
let answers = 0;
// Ranges that were moved, with the side of the pointer: they stand again in the next picture.
const moved = new Map();
document.addEventListener('htmx:after:swap', () => { answers += 1; for (const range of all('input[data-across]')) stand(range); });
const of = (range) => $(`#${range.dataset.across}`);
const ready = (range) => { const found = known.get(range.id); return found?.answers === answers ? found : null; };

// The curves as they were computed, once for each picture that stays.
async function fetched(range) {
  const body = asked(range.dataset.view).toString();
  const old = known.get(range.id);
  if (old?.body === body) { old.answers = answers; return; }
  const stamp = answers;
  const found = await computed(new URLSearchParams(body));
  if (!found || stamp !== answers) return;
  known.set(range.id, { body, answers, ...found });
}
// Where a curve that may run to and fro is at a place: the outermost value on the side of the pointer.
function outermost(x, y, at, above) {
  let found;
  for (let row = 1; row < x.length; row++) {
    const [a, b] = [x[row - 1], x[row]];
    if (Math.min(a, b) > at || Math.max(a, b) < at) continue;
    const values = a === b ? [y[row - 1], y[row]] : [y[row - 1] + (at - a) / (b - a) * (y[row] - y[row - 1])];
    for (const value of values) if (found === undefined || (above ? value > found : value < found)) found = value;
  }
  return found;
}
function digitsOf(p) { return Math.max(0, 3 - Math.floor(Math.log10(Math.max(Math.abs(p.xMin), Math.abs(p.xMax))))); }
function curves(range, panel, at, above) {
  const p = numbers(panel);
  const found = ready(range);
  const place = document.getElementById(`${range.id}-values`);
  line(panel, at);
  place.toggleAttribute('data-old', !found);
  if (!found) return;
  const digits = digitsOf(p);
  const values = [{ name: [...found.place.slice(0, 2), ''], value: at, digits, width: 3 + digits + 2 }];
  for (const group of found.groups) group.names.forEach((name, curve) => {
    if (group.x.length === 0) return;
    const value = outermost(group.x, group.y[curve], at, above);
    const other = values.find((each, place) => place > 0 && each.name[2] === name[2] && name[2] !== '');
    // Parts of one curve have one name.
    if (other) { if (value !== undefined && !(above ? other.value >= value : other.value <= value)) other.value = value; return; }
    values.push({ name: [name[2] ? '' : name[0], name[1], name[2]], value: value ?? NaN, digits: group.digits[curve], width: group.width[curve] });
  });
  written(place, values);
  range.setAttribute('aria-valuetext', place.textContent);
}
// The points of a map by their place on the horizontal axis.
function points(panel) {
  return [...panel.querySelectorAll('[data-of]')].map(({ dataset }) => ({ of: dataset.of, x: Number(dataset.x), y: Number(dataset.y) })).sort((a, b) => a.x - b.x || b.y - a.y);
}
function pointAt(range, panel, point) {
  const p = numbers(panel);
  const place = document.getElementById(`${range.id}-values`);
  const mark = marked(panel, 'circle', 'cursor-point');
  for (const [key, value] of [['r', 7], ['cx', xOf(p, point.x)], ['cy', yOf(p, point.y)]]) mark.setAttribute(key, value);
  const [symbol, unit] = range.dataset.place.split(' ');
  written(place, [
    { name: ['', '', point.of], value: null, width: 0 },
    { name: [symbol, unit, ''], value: point.x, digits: 2, width: 5 },
    { name: ['', panel.dataset.unit, range.dataset.other], value: point.y, digits: 1, width: 5 }]);
  range.setAttribute('aria-valuetext', place.textContent);
}
function stand(range) {
  const figure = of(range);
  const panel = figure && panels(figure)[0];
  if (!panel) return;
  const p = numbers(panel);
  if (range.dataset.place !== undefined) {
    const every = points(panel);
    range.max = Math.max(0, every.length - 1);
    if (moved.has(range.id) && every.length > 0) pointAt(range, panel, every[Math.min(Number(range.value), every.length - 1)]);
    return;
  }
  if (!moved.has(range.id)) return;
  const { at, above } = moved.get(range.id);
  range.value = 1000 * (at - p.xMin) / (p.xMax - p.xMin);
  curves(range, panel, at, above);
  if (!ready(range)) fetched(range).then(() => { if (ready(range)) stand(range); });
}
const planeOf = (range) => { const figure = of(range); const panel = figure && panels(figure)[0]; return panel && numbers(panel); };
document.addEventListener('input', ({ target }) => {
  const p = target.dataset?.across !== undefined && planeOf(target);
  if (!p) return;
  moved.set(target.id, { at: p.xMin + (p.xMax - p.xMin) * Number(target.value) / 1000, above: true });
  stand(target);
});
document.addEventListener('pointermove', (event) => {
  const found = inside(event);
  const range = found && $(`input[data-across="${found.figure.id}"]`);
  if (!range) return;
  const { panel, p, x, y } = found;
  if (range.dataset.place !== undefined) {
    const far = (point) => Math.hypot(xOf(p, point.x) - x, yOf(p, point.y) - y);
    const every = points(panel);
    const nearest = every.reduce((best, point) => (best === null || far(point) < far(best) ? point : best), null);
    if (!nearest || far(nearest) >= 30) return;
    range.value = every.indexOf(nearest);
    moved.set(range.id, {});
  } else moved.set(range.id, { at: atX(p, x), above: atY(p, y) >= 0 });
  stand(range);
});
