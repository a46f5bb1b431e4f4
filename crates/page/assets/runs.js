// The simulation: gains by sliders, and a run that is kept beside the next ones.
import { $, all, asked, computed, numbers, panels, xOf, yOf } from './cursor.js';

// A slider goes by powers of ten, that of a share in a straight line.
const comma = () => document.documentElement.lang === 'de';
const written = (value) => { const text = String(Number(value.toPrecision(4))); return comma() ? text.replace('.', ',') : text; };
const parsed = (text) => Number(text.trim().replace(',', '.'));
document.addEventListener('input', ({ target }) => {
  if (target.dataset?.gain !== undefined) {
    const field = document.getElementById(target.dataset.gain);
    field.value = written(target.dataset.linear === undefined ? 10 ** Number(target.value) : Number(target.value));
    field.dispatchEvent(new Event('input', { bubbles: true }));
  } else if (target.dataset?.gainField !== undefined) stand(target);
});
function stand(field) {
  const range = document.getElementById(`${field.id}-r`);
  const value = parsed(field.value);
  if (!range || range === document.activeElement || !Number.isFinite(value)) return;
  const at = range.dataset.linear === undefined ? Math.log10(value) : value;
  if (!Number.isFinite(at)) return;
  if (at < Number(range.min)) range.min = at;
  if (at > Number(range.max)) range.max = at;
  range.value = at;
}

// The kept run: its curves as they were computed, and its figures.
const SVG = 'http://www.w3.org/2000/svg';
let kept = null;
function figures() { return new Map(all('#run-figures tr[data-figure]').map((row) => [row.dataset.figure, row.children[1].textContent])); }
async function keep() {
  const found = await computed(asked(''));
  if (!found) return;
  const columns = found.groups.flatMap(({ y }) => y);
  let number = 0;
  // The range of each panel, which the picture of the next run contains.
  const ranges = panels($('#plot-simulation')).map((panel) => {
    const of = columns.slice(number, number += panel.querySelectorAll('g.line').length).flat();
    return [Math.min, Math.max].map((most) => Number(of.reduce((a, b) => most(a, b)).toPrecision(6))).join(' ');
  }).join(',');
  kept = { groups: found.groups, figures: figures(), scenario: $('#scenario')?.value, ranges };
  shown();
}
function shown() {
  const button = $('[data-keep-run]');
  if (!button) return;
  const is = kept !== null && kept.scenario === $('#scenario')?.value;
  button.textContent = is ? button.dataset.other : button.dataset.first;
  button.setAttribute('aria-pressed', String(is));
  for (const row of all('#run-figures tr[data-figure]')) row.children[2].textContent = is ? kept.figures.get(row.dataset.figure) ?? '–' : '';
  const head = $('#run-figures thead th:nth-child(3)');
  if (head) head.textContent = is ? head.dataset.kept : '';
  $('#kept-ranges').value = is ? kept.ranges : '';
  $('#kept-legend').hidden = !is;
  for (const path of all('.kept-run')) path.remove();
  if (is) draw();
}
function draw() {
  const figure = $('#plot-simulation');
  if (!figure) return;
  const columns = kept.groups.flatMap(({ x, y }) => y.map((each) => ({ x, y: each })));
  let number = 0;
  for (const panel of panels(figure)) {
    const p = numbers(panel);
    for (const curve of [...panel.querySelectorAll('g.line')]) {
      const column = columns[number++];
      // What is wanted is the same in both runs.
      if (!column || curve.querySelector('path')?.getAttribute('stroke-dasharray') === '1.5 2.5') continue;
      const path = document.createElementNS(SVG, 'path');
      let d = '';
      for (let row = 0; row < column.x.length; row++) {
        if (column.x[row] < p.xMin || column.x[row] > p.xMax) continue;
        const y = yOf(p, column.y[row]);
        d += `${d ? 'L' : 'M'}${xOf(p, column.x[row]).toFixed(1)} ${y.toFixed(1)}`;
      }
      path.setAttribute('d', d);
      path.setAttribute('class', 'kept-run');
      curve.before(path);
    }
  }
}
// Another scenario has a scale of its own.
document.addEventListener('change', ({ target }) => { if (target.id === 'scenario') $('#kept-ranges').value = ''; }, true);
document.addEventListener('click', ({ target }) => {
  if (!target.closest?.('[data-keep-run]')) return;
  if (target.closest('[data-keep-run]').getAttribute('aria-pressed') === 'true') { kept = null; shown(); } else keep();
});
document.addEventListener('htmx:after:swap', () => { for (const field of all('[data-gain-field]')) stand(field); shown(); });
