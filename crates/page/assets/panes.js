// The frame: borders that move, the room of the pictures, menus, the drawer, the palette and the keys.
import { away, back, isAway, keep, opened, said, shut, tell } from './page.js';

const $ = (selector) => document.querySelector(selector);
const all = (selector) => [...document.querySelectorAll(selector)];
const root = document.documentElement;
const kept = (name, value) => { try { if (value === undefined) return localStorage.getItem(name); localStorage.setItem(name, value); } catch { /* keeps nothing */ } return null; };

// Borders: shares of the three panes, kept between visits.
const USUAL = [25, 40, 35];
const LEAST = 14;
let shares = (kept('antrieb-panes') ?? '').split(' ').map(Number);
if (shares.length !== 3 || !shares.every((share) => share >= LEAST)) shares = [...USUAL];
function borders() {
  const panes = $('#panes');
  if (!panes) return;
  ['--left', '--middle', '--right'].forEach((name, place) => {
    if (panes.style.getPropertyValue(name) !== `${shares[place]}fr`) panes.style.setProperty(name, `${shares[place]}fr`);
  });
  $('#border-1')?.setAttribute('aria-valuenow', Math.round(shares[0]));
  $('#border-2')?.setAttribute('aria-valuenow', Math.round(shares[0] + shares[1]));
}
function move(border, by) {
  const [a, b] = border.id === 'border-1' ? [0, 1] : [1, 2];
  const most = shares[a] + shares[b] - LEAST;
  const left = Math.min(most, Math.max(LEAST, shares[a] + by));
  shares[b] += shares[a] - left;
  shares[a] = left;
  borders();
}
let held = null;
document.addEventListener('pointerdown', (event) => {
  const border = event.target.closest?.('.border');
  if (!border || event.button !== 0) return;
  event.preventDefault();
  border.setPointerCapture(event.pointerId);
  held = { border, x: event.clientX };
});
document.addEventListener('pointermove', (event) => {
  if (!held) return;
  move(held.border, 100 * (event.clientX - held.x) / $('#panes').clientWidth);
  held.x = event.clientX;
});
for (const kind of ['pointerup', 'pointercancel']) document.addEventListener(kind, () => { if (held) { held = null; settled(); } });
document.addEventListener('dblclick', (event) => { if (event.target.closest?.('.border')) { shares = [...USUAL]; borders(); settled(); } });
function settled() { kept('antrieb-panes', shares.map((share) => share.toFixed(2)).join(' ')); fit(); }

// The pictures are as large as their pane leaves room.
function room() {
  const figure = $('#demands figure.plot:has(.frame)');
  const pane = $('#view');
  if (!figure || !pane || pane.clientWidth === 0) return null;
  const frame = figure.querySelector('.frame');
  const below = figure.querySelector('figcaption')?.offsetHeight ?? 30;
  const top = frame.getBoundingClientRect().top - pane.getBoundingClientRect().top + pane.scrollTop;
  return { figure, width: Math.round(frame.clientWidth), height: Math.max(260, Math.round(pane.clientHeight - top - below - 14)) };
}
let fitting = 0;
let requested = null;
function fit() {
  clearTimeout(fitting);
  fitting = setTimeout(() => {
    const found = room();
    if (!found || !$('#state')) return;
    const { figure, width, height } = found;
    const [wide, high] = [$('#state [name=width]'), $('#state [name=height]')];
    // While an answer or a picture is under way, the picture in the pane is an old one: its size is no reason to request again
    // what was requested, which would end the drawing of the new one, without end.
    const [ofWidth, ofHeight] = requested && $('.htmx-request') ? requested : [figure.dataset.width, figure.dataset.height];
    const off = Math.abs(width - Number(ofWidth)) > 6 || Math.abs(height - Number(ofHeight)) > 12;
    [wide.value, high.value] = [width, height];
    kept('antrieb-room', `${width} ${height}`);
    if (!off || isAway()) return;
    requested = [width, height];
    htmx.ajax('POST', '/work', { source: $('#state') });
  }, 60);
}
addEventListener('resize', fit);
document.addEventListener('htmx:after:swap', () => { borders(); goOn(); changeOn(); fit(); left(); });

// The three panes of a narrow window, and the two faces of the left one.
function show(pane) {
  root.dataset.pane = pane;
  const section = { 1: '#moves', 2: '#demands', 3: '#fits' }[pane];
  $(section)?.setAttribute('tabindex', '-1');
  $(section)?.focus({ preventScroll: true });
  fit();
}
function left(name) {
  if (name) root.dataset.left = name;
  for (const tab of all('button[data-left]')) tab.setAttribute('aria-selected', String(tab.dataset.left === (root.dataset.left ?? 'form')));
}

// A count or a check in the bar leads to its row, which may have to be fetched first.
let going = null;
function goOn() {
  if (!going) return;
  const row = $(going);
  if (!row) return;
  going = null;
  if (matchMedia('(max-width: 860px)').matches) root.dataset.pane = '3';
  row.scrollIntoView({ block: 'center' });
  row.classList.add('flash');
  row.querySelector('button')?.focus({ preventScroll: true });
  setTimeout(() => row.classList.remove('flash'), 1600);
}
document.addEventListener('htmx:before:request', (event) => {
  const { goto: to, change } = event.detail.ctx.sourceElement.dataset ?? {};
  if (to) going = to;
  if (change) changing = change;
});
// An assumption that is to be changed is stated first, and its field is led to with the value selected.
let changing = null;
function changeOn() {
  if (!changing) return;
  const name = changing;
  changing = null;
  lead(name);
  document.activeElement?.select?.();
}

// A field that a link leads to may be behind a fold, or in another pane.
document.addEventListener('click', (event) => {
  const link = event.target.closest?.('a[href^="#"]');
  const name = link?.getAttribute('href').slice(1);
  if (!name || !(document.getElementById(name) || name.startsWith('f-'))) return;
  event.preventDefault();
  lead(name);
});
// To a field by its id; where its fold was not fetched yet, after that.
function lead(name) {
  const field = document.getElementById(name) ?? $(`#fields [id^="f-"][id$="${CSS.escape(name.slice(1))}"]`);
  if (field) { reveal(field); return; }
  const table = name.replace(/-[^-]*$/, '');
  if (sought === name || !$('#state')) { sought = null; left('text'); $('#text')?.focus(); return; }
  sought = name;
  opened([`${table}-t`, `${table}-m`]);
  htmx.ajax('POST', '/work', { source: $('#state') }).then(() => { lead(name); sought = null; });
}
let sought = null;
function reveal(field) {
  if (field.id === 'text') left('text'); else if (field.closest('#left-pane-form')) left('form');
  if (field.closest('#moves') && matchMedia('(max-width: 860px)').matches) root.dataset.pane = '1';
  for (let fold = field.closest('details'); fold; fold = fold.parentElement.closest('details')) fold.open = true;
  const row = field.closest('.row') ?? field;
  row.scrollIntoView({ block: 'center' });
  row.classList.add('flash');
  setTimeout(() => row.classList.remove('flash'), 1600);
  field.focus({ preventScroll: true });
}

// The units of a field stand once in the page; they are put into it when it is looked at.
for (const kind of ['focusin', 'pointerdown']) document.addEventListener(kind, (event) => {
  const select = event.target.closest?.('select[data-units]');
  const list = select && $('#units').content.getElementById(select.dataset.units);
  if (!list || select.options.length >= list.options.length) return;
  for (const option of list.options) if (option.value !== select.dataset.chosen) select.add(new Option(option.textContent, option.value));
});

// Menus close when something of them was chosen, or elsewhere was clicked.
document.addEventListener('click', (event) => {
  const inside = event.target.closest?.('.menu');
  const chosen = event.target.closest?.('.menu .items button, .menu .items a');
  for (const menu of all('.menu[open]')) {
    if (menu === inside && !chosen) continue;
    // What was chosen is no longer in sight: the focus goes to what opened it.
    if (menu.contains(document.activeElement)) menu.querySelector('summary').focus();
    menu.open = false;
  }
  const tab = event.target.closest?.('[data-pane]');
  if (tab?.dataset.pane && tab !== root) show(tab.dataset.pane);
  const face = event.target.closest?.('button[data-left]');
  if (face) left(face.dataset.left);
  if (event.target.closest?.('[data-find]')) palette();
  if (event.target.closest?.('[data-keys]')) keys();
  const full = event.target.closest?.('[data-full]');
  if (full && full !== root) { if (root.dataset.full === undefined) root.dataset.full = ''; else delete root.dataset.full; full.setAttribute('aria-pressed', String(root.dataset.full !== undefined)); fit(); }
  const copy = event.target.closest?.('[data-copy]');
  if (copy) copied(copy);
  if (event.target.closest?.('[data-picture]')) picture();
  const tile = event.target.closest?.('.tile');
  if (tile) for (const each of all('.tile')) each.setAttribute('aria-pressed', String(each === tile));
});

// A picture as a file or in the clipboard, and its curves as a table.
function source(figure) {
  const svg = figure.querySelector('.frame > svg').cloneNode(true);
  for (const mark of svg.querySelectorAll('.cursor-line, .cursor-point, .chosen')) mark.remove();
  svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return new XMLSerializer().serializeToString(svg);
}
async function copied(button) {
  const figure = button.closest('figure');
  let text;
  if (button.dataset.copy === 'svg') text = source(figure);
  else {
    const body = new URLSearchParams(new FormData($('#state')));
    const reply = await fetch('/curves', { method: 'POST', body }).catch(() => null);
    text = reply?.ok ? await reply.text() : null;
    if (text === null) { tell(said('noAnswer')); return; }
  }
  try { await navigator.clipboard.writeText(text); tell(button.textContent + ' ✓'); } catch { keep(new Blob([text]), button.dataset.copy === 'svg' ? 'picture.svg' : 'curves.csv'); }
}
function picture() { const figure = $('#demands figure.plot'); if (figure) keep(new Blob([source(figure)]), `${figure.id.replace('plot-', '')}.svg`); }

// The palette: keys, checks, codes, terms.
let typed = 0;
function palette() {
  const dialog = $('#palette');
  if (!dialog || dialog.open) return;
  dialog.replaceChildren();
  const field = Object.assign(document.createElement('input'), { type: 'search', id: 'sought', autocomplete: 'off', spellcheck: false });
  field.setAttribute('aria-label', dialog.getAttribute('aria-label'));
  field.placeholder = dialog.getAttribute('aria-label');
  const list = Object.assign(document.createElement('div'), { id: 'found' });
  list.setAttribute('aria-live', 'polite');
  dialog.append(field, list);
  field.addEventListener('input', () => {
    clearTimeout(typed);
    typed = setTimeout(async () => {
      const query = new URLSearchParams({ q: field.value, lang: root.lang });
      const reply = await fetch(`/find?${query}`).catch(() => null);
      if (reply?.ok) list.innerHTML = await reply.text();
    }, 80);
  });
  dialog.showModal();
}
async function keys() {
  const dialog = $('#palette');
  if (!dialog || dialog.open) return;
  const reply = await fetch(`/keys?lang=${root.lang}`).catch(() => null);
  if (!reply?.ok) return;
  dialog.innerHTML = await reply.text();
  dialog.showModal();
}
document.addEventListener('keydown', (event) => {
  const dialog = event.target.closest?.('#palette');
  if (!dialog || !['ArrowDown', 'ArrowUp', 'Enter'].includes(event.key)) return;
  const buttons = [...dialog.querySelectorAll('li > button')];
  const at = buttons.indexOf(document.activeElement);
  if (event.key === 'Enter' && at < 0) { buttons[0]?.click(); event.preventDefault(); return; }
  if (event.key === 'Enter') return;
  event.preventDefault();
  (buttons[event.key === 'ArrowDown' ? Math.min(at + 1, buttons.length - 1) : Math.max(at - 1, 0)] ?? dialog.querySelector('input'))?.focus();
});
document.addEventListener('click', (event) => {
  const found = event.target.closest?.('#palette [data-found]');
  if (!found) return;
  $('#palette').close();
  // Until what was found has the focus.
  $('#find')?.focus();
  const [kind, name] = [found.dataset.found, found.value];
  if (kind === 'key') lead(name);
  else if (kind === 'check') { going = `#check-${name}`; if ($(going)) goOn(); else htmx.ajax('POST', '/work', { source: $('#state'), values: JSON.parse($('#tightest')?.getAttribute('hx-vals') ?? '{"unfolded":"true"}') }); }
  else if (kind === 'code' && $('#text')) htmx.ajax('POST', '/work', { source: $('#state'), values: { code: name } });
  else htmx.ajax('POST', '/tools', { source: $('#tools'), target: '#detail', swap: 'innerHTML', values: { tool: kind === 'code' ? 'code' : 'glossary', about: name, asked: kind === 'code' ? 'code' : 'glossary' } });
});

addEventListener('keydown', (event) => {
  const typing = event.target.closest?.('input, textarea, select, dialog');
  if (event.key === 'Escape') {
    const menu = $('.menu[open]');
    if (menu) { menu.open = false; menu.querySelector('summary').focus(); } else if (root.dataset.full !== undefined) { delete root.dataset.full; fit(); } else if (!$('#palette')?.open) shut();
    return;
  }
  const border = event.target.closest?.('.border');
  if (border && (event.key === 'ArrowLeft' || event.key === 'ArrowRight')) { event.preventDefault(); move(border, event.key === 'ArrowLeft' ? -2 : 2); settled(); return; }
  const tabs = event.target.closest?.('[role=tablist]');
  if (tabs && (event.key === 'ArrowLeft' || event.key === 'ArrowRight')) {
    const every = [...tabs.querySelectorAll('[role=tab]')];
    every[(every.indexOf(event.target) + (event.key === 'ArrowLeft' ? every.length - 1 : 1)) % every.length].focus();
    event.preventDefault();
    return;
  }
  if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === '/') { event.preventDefault(); palette(); }
  else if (event.key === '?') { event.preventDefault(); keys(); }
  else if (['1', '2', '3'].includes(event.key) && $('#panes')) { event.preventDefault(); show(event.key); }
});

// Whether antrieb still answers: asked every two seconds while the page is looked at.
setInterval(async () => {
  if (document.hidden) return;
  const reply = await fetch('/health').catch(() => null);
  if (reply?.ok) back(); else if (!reply) away();
}, 2000);

borders();
left();
fit();
