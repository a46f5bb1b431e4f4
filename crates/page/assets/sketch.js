// What moves in the drawing of the mechanism: it stands where the instant of the pictures over time puts it.
import { $, all, now, span, stand } from './cursor.js';

const SPEEDS = [1, 0.5, 0.25, 0.1];
const numbers = (text) => text.trim().split(/\s+/).map(Number);

// The tables of the groups, read once: the point that a group turns about, how it goes on, its rows.
const tables = new WeakMap();
function table(group) {
  const written = group.dataset.rows;
  let known = tables.get(group);
  if (known?.written !== written) {
    const [head, ...rows] = written.split(';');
    const [x, y, beyond] = head.split(' ');
    known = { written, about: [Number(x), Number(y)], beyond, rows: rows.map(numbers) };
    tables.set(group, known);
  }
  return known;
}
// Turn to the right in degrees, shift and stretch at an angle of the output in degrees.
function placement({ rows, beyond }, angle) {
  const first = rows[0], last = rows[rows.length - 1];
  const span = last[0] - first[0];
  const rounds = beyond === 'stay' || !(span > 0) ? 0 : Math.floor((angle - first[0]) / span);
  const at = Math.min(last[0], Math.max(first[0], angle - rounds * span));
  let low = 0, high = rows.length - 1;
  while (high - low > 1) { const middle = (low + high) >> 1; if (rows[middle][0] <= at) low = middle; else high = middle; }
  const a = rows[low], b = rows[high];
  const share = b[0] > a[0] ? (at - a[0]) / (b[0] - a[0]) : 0;
  const advance = beyond === 'on' ? rounds : 0;
  return a.map((value, place) => value + share * (b[place] - value) + advance * (last[place] - first[place])).slice(1);
}
const shown = (value) => Math.round(value * 100) / 100;
let position = null;
function draw() {
  if (position === null) return;
  for (const svg of all('svg.drawn')) {
    const found = {};
    for (const group of svg.querySelectorAll('g[data-rows]')) {
      const known = table(group);
      const [x, y] = known.about;
      const [turn, dx, dy, sx = 1, sy = 1] = placement(known, position * 180 / Math.PI);
      const stretch = sx === 1 && sy === 1 ? '' : ` scale(${sx.toFixed(4)} ${sy.toFixed(4)})`;
      group.setAttribute('transform', `translate(${shown(x + dx)} ${shown(y + dy)}) rotate(${shown(turn % 360)})${stretch} translate(${-x} ${-y})`);
      found[group.dataset.group] = { x, y, turn: turn * Math.PI / 180, dx, dy, sx, sy };
    }
    // A symbol goes with what it points at, upright and on the sheet; its line leads there.
    const sheet = svg.viewBox.baseVal;
    for (const link of svg.querySelectorAll('a[data-with]')) {
      const p = found[link.dataset.with];
      if (!p) continue;
      const [ax, ay] = numbers(link.dataset.at);
      const [u, v] = [p.sx * (ax - p.x), p.sy * (ay - p.y)];
      const to = [p.x + p.dx + Math.cos(p.turn) * u - Math.sin(p.turn) * v, p.y + p.dy + Math.sin(p.turn) * u + Math.cos(p.turn) * v];
      const text = link.querySelector('text');
      const label = [Number(text.getAttribute('x')), Number(text.getAttribute('y')) - 4.5];
      const from = [Math.min(sheet.width - 11, Math.max(11, label[0] + to[0] - ax)), Math.min(sheet.height - 8, Math.max(8, label[1] + to[1] - ay))];
      text.setAttribute('transform', `translate(${shown(from[0] - label[0])} ${shown(from[1] - label[1])})`);
      const far = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
      const [x, y] = [from[0] + 9 * (to[0] - from[0]) / far, from[1] + 9 * (to[1] - from[1]) / far];
      link.querySelector('.l-leader').setAttribute('d', far > 9 ? `M${shown(x)} ${shown(y)}L${shown(to[0])} ${shown(to[1])}` : '');
      const end = link.querySelector('.l-mark');
      end.setAttribute('cx', shown(to[0]));
      end.setAttribute('cy', shown(to[1]));
    }
  }
}

// Where the output is, as the pictures over time report it.
addEventListener('antrieb:instant', ({ detail }) => {
  if (!Number.isFinite(detail?.position_rad)) return;
  position = detail.position_rad;
  draw();
});
// Played in the time of the machine, or slower; never by itself. The pictures go along, as if the instant were pulled.
let playing = null;
let speed = 0;
function step(at) {
  const shown = span();
  if (!playing || !shown || !$('#instant')) { stop(); return; }
  const [from, until] = shown;
  const long = until - from;
  playing.time += Math.min(0.1, (at - playing.now) / 1000) * SPEEDS[speed];
  playing.now = at;
  if (playing.time > until || playing.time < from) playing.time = from + ((playing.time - from) % long + long) % long;
  stand(playing.time);
  playing.frame = requestAnimationFrame(step);
}
function play() {
  if (!span() || !$('#instant')) return;
  playing = { time: now(), now: performance.now(), frame: requestAnimationFrame(step) };
  label();
}
function stop() {
  if (playing) cancelAnimationFrame(playing.frame);
  playing = null;
  label();
}
function label() {
  for (const button of all('[data-play]')) {
    button.dataset.first ??= button.getAttribute('aria-label');
    const text = playing ? button.dataset.other : button.dataset.first;
    button.setAttribute('aria-label', text);
    button.title = text;
    button.textContent = playing ? '⏸' : '▶';
    button.disabled = !span();
  }
  for (const place of all('[data-speed]')) {
    const number = new Intl.NumberFormat(document.documentElement.lang).format(SPEEDS[speed]);
    place.textContent = speed > 0 ? `${number}×` : '';
  }
}
document.addEventListener('click', ({ target }) => {
  if (target.closest?.('[data-play]')) { if (playing) stop(); else play(); }
  if (target.closest?.('[data-slower]')) { speed = (speed + 1) % SPEEDS.length; label(); }
});
// Another axis or text has another motion: the pictures report anew where the output is.
document.addEventListener('htmx:after:swap', () => { draw(); label(); });
label();

// Symbols keep their size on the screen, whatever the size of the drawing.
const CALL_OUT = 12;
function legible() {
  for (const svg of all('svg.drawn')) {
    const sheet = svg.viewBox.baseVal;
    const scale = Math.min(svg.clientWidth / sheet.width, svg.clientHeight / sheet.height);
    if (scale > 0) svg.style.setProperty('--call-out', `${(CALL_OUT / scale).toFixed(2)}px`);
  }
}
const sizes = new ResizeObserver(legible);
function watch() { sizes.disconnect(); for (const svg of all('svg.drawn')) sizes.observe(svg); legible(); }
document.addEventListener('htmx:after:swap', watch);
watch();
