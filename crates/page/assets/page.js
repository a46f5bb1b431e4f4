// What must move in the page: the cursor of the pictures, undo and redo, files, and that no change is lost on its way.
const $ = (selector) => document.querySelector(selector);
const all = (selector) => [...document.querySelectorAll(selector)];
const text = () => $('#text');
const tell = (words) => { const told = $('#told'); if (told) told.textContent = words; };

// Requests wait for each other; each takes the text as the one before it left it.
document.addEventListener('htmx:before:request', (event) => {
  const body = event.detail.ctx.request.body;
  if (!(body instanceof URLSearchParams) || !text()) return;
  const source = event.detail.ctx.sourceElement;
  if (source !== text()) body.set('text', text().value);
  const good = $('#state [name=good]');
  if (good) body.set('good', good.value);
});

// The numbers of each curve, read once.
const lines = new WeakMap();

// Undo and redo are former texts.
const past = [];
const future = [];
let last = null;
let saved = null;
function note() {
  const field = text();
  if (!field) return;
  const now = field.defaultValue;
  if (last !== null && now !== last) { past.push(last); future.length = 0; if (past.length > 500) past.shift(); }
  last = now;
  if (saved === null) saved = now;
  buttons();
}
function buttons() {
  const set = (id, is) => { const button = $(id); if (button) button.disabled = is; };
  set('#undo', past.length === 0);
  set('#redo', future.length === 0);
  document.title = document.title.replace(/^• /, '');
  if (last !== null && last !== saved) document.title = '• ' + document.title;
}
function put(value) {
  const field = text();
  if (!field) return;
  field.value = value;
  field.dispatchEvent(new Event('input', { bubbles: true }));
  field.dispatchEvent(new Event('change', { bubbles: true }));
}
function step(from, to) {
  if (from.length === 0) return;
  to.push(last);
  last = from.pop();
  put(last);
  buttons();
}

// What a browser keeps of a field is not what the page says: it is put right behind every answer.
function right() {
  for (const select of all('select[data-chosen]')) if (document.activeElement !== select) select.value = select.dataset.chosen;
  for (const box of all('input[data-checked]')) box.checked = box.dataset.checked === 'true';
  const held = (name) => $(`#state [name=${name}]`)?.value;
  if (held('lang')) document.documentElement.lang = held('lang');
  if (held('theme') === 'dark') document.documentElement.dataset.theme = 'dark'; else delete document.documentElement.dataset.theme;
  note();
  cursor();
}
document.addEventListener('htmx:after:swap', () => {
  right();
  const head = $('#detail-title');
  if (head && head.dataset.seen === undefined) { head.dataset.seen = ''; head.focus(); head.scrollIntoView({ block: 'nearest' }); }
});
addEventListener('DOMContentLoaded', right);
if (document.readyState !== 'loading') right();

// One range moves the instant of every picture over time, and the point in the plane.
function panels(figure) { return [...figure.querySelectorAll('g.plane[data-x-min]')]; }
function cursor() {
  const range = $('#instant');
  const cycle = $('#plot-cycle');
  if (!range || !cycle) return;
  const first = panels(cycle)[0];
  if (!first) return;
  const until = Number(first.dataset.xMax);
  const time = until * Number(range.value) / 1000;
  for (const name of ['#plot-cycle', '#plot-bearing-load']) {
    const figure = $(name);
    if (!figure) continue;
    for (const panel of panels(figure)) line(panel, time);
  }
  const values = read(cycle, time);
  const format = new Intl.NumberFormat(document.documentElement.lang, { maximumSignificantDigits: 4, signDisplay: 'negative' });
  const shown = { format: (value) => format.format(value).replace('-', '\u2212') };
  const told = [`t ${shown.format(time)} s`, ...values.map((each) => `${each.symbol} ${each.label ? each.label + ' ' : ''}${shown.format(each.value)} ${each.unit}`)].join(' · ');
  $('#instant-values').textContent = told;
  range.setAttribute('aria-valuetext', told);
  point(values);
}
function line(panel, time) {
  const { left, right, top, bottom, xMin, xMax } = panel.dataset;
  let mark = panel.querySelector('.cursor-line');
  if (!mark) {
    mark = document.createElementNS('http://www.w3.org/2000/svg', 'line');
    mark.setAttribute('class', 'cursor-line');
    panel.append(mark);
  }
  const x = Number(left) + (time - xMin) / (xMax - xMin) * (right - left);
  mark.setAttribute('x1', x); mark.setAttribute('x2', x); mark.setAttribute('y1', top); mark.setAttribute('y2', bottom);
}
// The value of each curve at an instant, read from its line: the numbers of a path stand in the order of time.
function points(path) {
  const written = path.getAttribute('d');
  let known = lines.get(path);
  if (known?.written !== written) {
    const numbers = (written.match(/-?\d+(\.\d+)?/g) ?? []).map(Number);
    known = { written, x: numbers.filter((_, place) => place % 2 === 0), y: numbers.filter((_, place) => place % 2 === 1) };
    lines.set(path, known);
  }
  return known;
}
function read(figure, time) {
  const found = [];
  for (const panel of panels(figure)) {
    const { left, right, top, bottom, xMin, xMax, yMin, yMax, symbol, unit } = panel.dataset;
    const at = Number(left) + (time - xMin) / (xMax - xMin) * (right - left);
    for (const curve of panel.querySelectorAll('g.line')) {
      const path = curve.querySelector('path');
      if (!path) continue;
      const { x, y } = points(path);
      let low = 0, high = x.length - 1;
      while (high - low > 1) { const middle = (low + high) >> 1; if (x[middle] <= at) low = middle; else high = middle; }
      const share = x[high] > x[low] ? Math.min(1, Math.max(0, (at - x[low]) / (x[high] - x[low]))) : 0;
      const height = y[low] + share * (y[high] - y[low]);
      const value = Number(yMin) + (bottom - height) / (bottom - top) * (yMax - yMin);
      // A line is drawn to a hundredth of a pixel: no more digits are told.
      const step = (yMax - yMin) / (bottom - top) / 20;
      found.push({ symbol, label: curve.dataset.label ?? '', unit, value: Math.round(value / step) * step + 0 });
    }
  }
  return found;
}
function point(values) {
  const figure = $('#plot-torque-speed');
  const panel = figure && panels(figure)[0];
  if (!panel) return;
  const speed = values.find((each) => each.symbol === 'n');
  const torque = values.find((each) => each.symbol === 'T');
  if (!speed || !torque) return;
  const { left, right, top, bottom, xMin, xMax, yMin, yMax } = panel.dataset;
  let mark = panel.querySelector('.cursor-point');
  if (!mark) {
    mark = document.createElementNS('http://www.w3.org/2000/svg', 'circle');
    mark.setAttribute('class', 'cursor-point'); mark.setAttribute('r', 5);
    panel.append(mark);
  }
  mark.setAttribute('cx', Number(left) + (speed.value - xMin) / (xMax - xMin) * (right - left));
  mark.setAttribute('cy', Number(bottom) - (torque.value - yMin) / (yMax - yMin) * (bottom - top));
}
document.addEventListener('input', (event) => { if (event.target.id === 'instant') cursor(); });

// A sign in a drawing and its row point at each other.
function light(id, on) {
  for (const sign of all(`[data-for="${CSS.escape(id)}"]`)) sign.classList.toggle('lit', on);
  document.getElementById(id)?.closest('.row')?.classList.toggle('lit', on);
}
for (const [kind, on] of [['mouseover', true], ['mouseout', false], ['focusin', true], ['focusout', false]]) {
  document.addEventListener(kind, (event) => {
    const sign = event.target.closest?.('[data-for]');
    if (sign) light(sign.dataset.for, on);
    const field = event.target.closest?.('.row')?.querySelector('[id^="f-"]');
    if (field) light(field.id, on);
  });
}

const fields = () => new URLSearchParams(new FormData($('#state')));
async function send(path) { return fetch(path, { method: 'POST', body: fields() }); }
function keep(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
// What a client of the interface would ask for, about the axis and the actuator that are shown.
async function download(what, usual) {
  const held = (name) => $(`#state [name=${name}]`)?.value ?? '';
  const query = new URLSearchParams({ lang: held('lang') });
  const tab = $('.tabs [aria-current]');
  if (tab && what !== 'report') query.set('axis', tab.textContent);
  if (held('code') && what !== 'size' && (what !== 'report' || !tab)) query.set('code', held('code'));
  if (what === 'report') query.set('date', new Date().toISOString().slice(0, 10));
  tell('…');
  const reply = await fetch(`/api/v1/${what}?${query}`, { method: 'POST', headers: { 'content-type': 'application/toml' }, body: text().value });
  if (!reply.ok) {
    const told = await reply.json().catch(() => ({ errors: [{ message: reply.statusText }] }));
    tell(told.errors.map((each) => each.message).join('; '));
    return;
  }
  const name = /filename="([^"]+)"/.exec(reply.headers.get('content-disposition') ?? '');
  keep(await reply.blob(), name ? name[1] : usual);
  tell('');
}
function project() { keep(new Blob([text().value], { type: 'application/toml' }), $('#file')?.value || 'axis.toml'); }
// A recording is kept beside the projects, and a segment says so.
async function record(blob, name) {
  const reply = await fetch(`/recording?name=${encodeURIComponent(name)}&lang=${document.documentElement.lang}`, { method: 'POST', headers: { 'content-type': 'application/octet-stream' }, body: blob });
  const words = await reply.text();
  if (!reply.ok) { tell(words); return; }
  const button = $('[data-recording]');
  const path = button.dataset.recording;
  htmx.ajax('POST', '/work', { source: button, values: { do: `table ${path}\nvalue ${path}.law=recorded\nvalue ${path}.file=${words}` } });
}
function choose(accept, then) {
  const chooser = document.createElement('input');
  chooser.type = 'file';
  chooser.accept = accept;
  chooser.addEventListener('change', () => { if (chooser.files[0]) then(chooser.files[0]); });
  chooser.click();
}
addEventListener('paste', (event) => {
  if (event.target.closest?.('input, textarea') || !$('[data-recording]')) return;
  const pasted = event.clipboardData?.getData('text') ?? '';
  // Several lines, each with several columns, and numbers in most of them.
  const rows = pasted.split(/\r?\n/).filter((row) => row.trim());
  const numbers = rows.filter((row) => row.split(/[;\t]|,(?=\s|-?\d*\.)/).filter((cell) => /^\s*-?[\d.,]+(e[-+]?\d+)?\s*$/i.test(cell)).length > 1);
  if (rows.length < 3 || numbers.length < rows.length / 2) return;
  event.preventDefault();
  record(new Blob([pasted], { type: 'text/csv' }), 'pasted.csv');
});
async function save() {
  const reply = await send('/save');
  const words = await reply.text();
  if (reply.ok) {
    $('#state [name=known]').value = `${reply.headers.get('x-version') ?? ''} ${$('#file').value}`;
    saved = last;
    buttons();
    tell(words);
  } else if (reply.status === 404) {
    project();
    saved = last;
    buttons();
  } else tell(words);
}
function open() { choose('.toml', async (file) => begin(await file.text(), file.name)); }
// The whole page about a text.
function begin(value, name) {
  const form = document.createElement('form');
  form.method = 'post';
  form.action = '/';
  const lang = document.documentElement.lang;
  for (const [key, held] of [['text', value], ['file', name], ['lang', lang]]) {
    const field = document.createElement('textarea');
    field.name = key;
    field.value = held;
    form.append(field);
  }
  saved = last;
  document.body.append(form);
  form.submit();
}
// A link holds the text behind its mark, which no browser sends.
async function link() {
  const packed = await new Response(new Blob([text().value]).stream().pipeThrough(new CompressionStream('deflate-raw'))).arrayBuffer();
  const code = btoa(String.fromCharCode(...new Uint8Array(packed))).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
  history.replaceState(null, '', '#p=' + code);
  await navigator.clipboard?.writeText(location.href).catch(() => {});
  tell(location.href.length > 200 ? location.href.slice(0, 200) + '…' : location.href);
}
async function linked() {
  if (!location.hash.startsWith('#p=')) return;
  const bytes = Uint8Array.from(atob(location.hash.slice(3).replaceAll('-', '+').replaceAll('_', '/')), (sign) => sign.charCodeAt(0));
  const value = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).text();
  if (text()) { if (text().value !== value) put(value); } else begin(value, 'axis.toml');
}
addEventListener('DOMContentLoaded', () => linked().catch(() => {}));

document.addEventListener('click', (event) => {
  const of = (name) => event.target.closest?.(`[data-${name}]`);
  if (of('undo')) step(past, future);
  else if (of('redo')) step(future, past);
  else if (of('save')) save();
  else if (of('open')) open();
  else if (of('link')) link();
  else if (of('api')) download(of('api').dataset.api, of('api').dataset.name);
  else if (of('project')) project();
  else if (of('recording')) choose('.csv,.txt,.parquet', (file) => record(file, file.name));
  else if (of('close')) { const id = of('close').dataset.close; document.getElementById(id).replaceChildren(); $('#checks-title')?.scrollIntoView({ block: 'nearest' }); }
  else if (of('instant')) jump(Number(of('instant').dataset.instant));
  else if (of('into')) { const field = document.getElementById(of('into').dataset.into); field.value = event.target.closest('button').value; field.dispatchEvent(new Event('change', { bubbles: true })); }
});
function jump(time) {
  const range = $('#instant');
  const first = $('#plot-cycle') && panels($('#plot-cycle'))[0];
  if (!range || !first) return;
  range.value = 1000 * time / Number(first.dataset.xMax);
  cursor();
  range.focus();
}
addEventListener('keydown', (event) => {
  if (!(event.ctrlKey || event.metaKey)) return;
  const typing = event.target.closest?.('input, textarea');
  if (event.key === 's') { event.preventDefault(); save(); }
  else if (event.key === 'z' && !typing) { event.preventDefault(); step(event.shiftKey ? future : past, event.shiftKey ? past : future); }
  else if (event.key === 'y' && !typing) { event.preventDefault(); step(future, past); }
});
addEventListener('beforeunload', (event) => { if (last !== null && last !== saved) event.preventDefault(); });
