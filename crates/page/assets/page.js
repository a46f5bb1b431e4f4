// What must move in the page: the cursor of the pictures, undo and redo, files, and that no change is lost on its way.
import { base, cursor, jump, overlay } from './plots.js';
import './waiting.js';

const $ = (selector) => document.querySelector(selector);
const all = (selector) => [...document.querySelectorAll(selector)];
const text = () => $('#text');
// The messages of the scripts in the language of the page.
export const said = (name) => $('#messages')?.dataset[name] ?? '';
let quiet = 0;
// A message stays until it is read: some seconds, longer where it is long; that antrieb does not answer, until it does.
export function tell(words) {
  const status = $('#status');
  if (!status) return;
  status.textContent = words || (isAway() ? said('noAnswer') : '');
  clearTimeout(quiet);
  if (words) quiet = setTimeout(() => { if (status.textContent === words) tell(''); }, 4000 + 60 * words.length);
}
// The faults of an answer as sentences: an interface for programs writes them as JSON.
export function sentences(words) {
  try { return JSON.parse(words).errors.map((each) => each.message).join('; '); } catch { return words; }
}

// Requests wait for each other; each takes the text as the one before it left it.
let answered = null;
// What is typed in a field in one go is one step back, however often it was answered meanwhile.
let visit = 0;
let typed = null;
let step = { typed: null, at: 0 };
document.addEventListener('focusin', () => { visit += 1; });
document.addEventListener('htmx:after:swap', (event) => {
  const { asked, typing } = event.detail.ctx;
  if (asked && text()) answered = { asked, text: text().value };
  typed = typing ?? null;
});
document.addEventListener('htmx:before:request', (event) => {
  const body = event.detail.ctx.request.body;
  if (!(body instanceof URLSearchParams) || !text()) return;
  const source = event.detail.ctx.sourceElement;
  const asked = [source.id, ...[...body].filter(([key]) => key !== 'text' && key !== 'good').flat()].join('\n');
  // What a field holds now is on its way behind this request.
  if (body.has('path') && body.has('value') && source === document.activeElement && source.matches('input[type=text]') && source.value !== body.get('value')) { event.preventDefault(); return; }
  // A field that is left tells once more what was answered while it was typed.
  if (source.id && body.has('path') && base(source) === undefined && answered?.asked === asked && answered.text === text().value) { event.preventDefault(); return; }
  event.detail.ctx.asked = asked;
  if (source.matches('input[type=text], textarea')) event.detail.ctx.typing = `${source.id} ${visit}`;
  if (body.has('path') && source.closest('details.more')) body.append('folded', '');
  if (event.detail.ctx.request.action.endsWith('/work')) body.append('parts', parts());
  for (const [id, open] of folds) if (open && (id.startsWith('f-') || id === 'ranking-rest')) body.append('fold', id);
  // A pull at the end of a segment begins at the text that was there when it began. So does what is typed into a field in one go: other
  // segments follow one of the motion, and a value that is emptied and typed anew keeps its line with the comment.
  if (base(source) !== undefined) body.set('text', base(source));
  else if (source.matches('input[type=text]') && body.has('path') && body.has('value')) body.set('text', begun(source));
  else if (source !== text()) body.set('text', text().value);
  const good = $('#state [name=good]');
  if (good) body.set('good', good.value);
  interrupt(event.detail.ctx);
});

let typing = { of: null };
function begun(source) {
  const of = `${source.id} ${visit}`;
  if (typing.of !== of || text().value !== typing.answered) typing = { of, text: text().value };
  return typing.text;
}
document.addEventListener('htmx:after:swap', (event) => { if (event.detail.ctx.typing === typing.of) typing.answered = text()?.value; });

// The picture of a long recording is drawn beside the answers and waits for none of them. What is asked next ends it: its cores
// and its insertion would delay the numbers. Where the answer asks for no other picture, it is drawn after all.
let drawn = null;
let interrupted = null;
function interrupt(ctx) {
  const { action } = ctx.request;
  if (action.endsWith('/picture')) drawn = ctx;
  else if (action.endsWith('/work') && drawn) { interrupted = drawn.sourceElement; drawn.request.abort(); drawn = null; }
}
document.addEventListener('htmx:finally:request', (event) => {
  const { ctx } = event.detail;
  if (drawn === ctx) drawn = null;
  if (!interrupted || !ctx.request.action.endsWith('/work')) return;
  interrupted.dispatchEvent(new Event('antrieb:again'));
  interrupted = null;
});

// Undo and redo are former texts.
const past = [];
const future = [];
let last = null;
let saved = null;
function note() {
  const field = text();
  if (!field) return;
  const now = field.defaultValue;
  // What is pulled is one step, however often it was answered meanwhile.
  if (base() !== undefined) return;
  if (last !== null && now !== last) {
    const isOne = typed !== null && typed === step.typed && performance.now() - step.at < 3000;
    step = { typed, at: performance.now() };
    if (!isOne) past.push(last);
    future.length = 0;
    if (past.length > 500) past.shift();
  }
  last = now;
  if (saved === null) saved = isNew() ? '' : now;
  buttons();
}
// Whether the entry in the history has the name of the draft: one that goes on has that of the draft.
let isNamed = false;
function buttons() {
  const set = (id, is) => { const button = $(id); if (button) button.setAttribute('aria-disabled', String(is)); };
  set('#undo', past.length === 0);
  set('#redo', future.length === 0);
  const changed = last !== null && last !== saved;
  document.title = (changed ? '• ' : '') + titled();
  const state = $('#file-state');
  if (state) { state.className = changed ? 'changed' : 'saved'; state.textContent = known() || changed ? state.dataset[changed ? 'changed' : 'saved'] : ''; }
  if (text() && isNamed) keepDraft(changed);
}
// An axis that was begun here, or brought along, is kept nowhere yet; an example can be opened again.
const isNew = () => !known() && !location.hash && !location.pathname.endsWith('/example') && !['new', 'open'].some((name) => new URLSearchParams(location.search).has(name));
const known = () => ($('#state [name=known]')?.value ?? '').trim() !== '';
const titled = () => [$('#verdict strong.code')?.textContent, $('#file')?.value, 'antrieb'].filter(Boolean).join(' – ');

// The address of the page itself: the folder of the server, also behind the path of an example, or the first file of the folder without one.
const root = () => (location.pathname.endsWith('.html') ? location.pathname : location.pathname.replace(/[^/]*$/, ''));
// What is not saved is kept by the browser until it is saved: under the name of its file, which an axis that has never been saved lacks, and
// a name of its own, which its entry in the history holds, so that reloading finds it and no other tab with the same file overwrites it.
const DRAFT = 'antrieb-draft ';
const OWN = '\t';
const DRAFTS_MOST = 30;
const fileName = () => $('#file')?.value || 'axis.toml';
function draftKey() {
  const of = ($('#state [name=known]')?.value ?? '').split(' ').slice(1).join(' ');
  if (!history.state?.axis) history.replaceState({ ...history.state, axis: crypto.getRandomValues(new Uint32Array(2)).join('-') }, '');
  return of ? `${DRAFT}${of}${OWN}${history.state.axis}` : `${DRAFT}/${history.state.axis}`;
}
// The file of a draft, or its own name behind a slash; and the name of its tab.
const ofDraft = (key) => key.slice(DRAFT.length).split(OWN);
function drafts() {
  const found = [];
  try {
    for (const key of Object.keys(localStorage)) {
      if (!key.startsWith(DRAFT)) continue;
      try { found.push({ key, ...JSON.parse(localStorage.getItem(key)) }); } catch { /* written by another program */ }
    }
  } catch { /* a browser that keeps nothing */ }
  return found.filter((each) => typeof each.text === 'string').sort((a, b) => b.at - a.at);
}
let full = false;
let hasTyped = false;
function keepDraft(changed) {
  const key = draftKey();
  // What was typed while nothing answers is not in the text yet.
  const typed = [...unsent].map((id) => document.getElementById(id)).filter((field) => field?.matches('#fields input[type=text], #fields select, #fields textarea'))
    .map((field) => [field.id, field.value]);
  try {
    if (changed || typed.length > 0) {
      for (const old of drafts().filter((each) => each.key !== key).slice(DRAFTS_MOST - 1)) localStorage.removeItem(old.key);
      localStorage.setItem(key, JSON.stringify({ text: last, base: saved, file: fileName(), at: Date.now(), from: location.search, typed }));
    } else if (past.length || future.length || hasTyped) localStorage.removeItem(key);
    hasTyped = typed.length > 0;
    full = false;
  } catch (fault) {
    // A browser that keeps nothing at all is not reported with every key.
    if (fault.name === 'QuotaExceededError' && !full) { full = true; tell(said('full')); }
  }
}
const button = (words, then) => Object.assign(document.createElement('button'), { type: 'button', textContent: words, onclick: then });
const instant = (at) => new Date(at).toLocaleString(document.documentElement.lang, { dateStyle: 'medium', timeStyle: 'short' });
const CONTINUED = 'antrieb-continued';
const CHOSEN = 'antrieb-chosen';
function taken(name) {
  try { const value = sessionStorage.getItem(name); sessionStorage.removeItem(name); return value; } catch { return null; }
}
function draft() {
  const place = $('#draft');
  if (!place || !text()) return;
  let found;
  // Without the token in its address the page is opened in two steps: the first one has the kind.
  const [first, continued, axis] = [taken('antrieb-navigation'), taken(CONTINUED), [taken('antrieb-axis'), taken(CHOSEN)].findLast(Boolean)];
  if (axis) history.replaceState({ ...history.state, axis }, '');
  // A draft of the start page goes on under its own name.
  if (continued) history.replaceState({ ...history.state, axis: continued.slice(DRAFT.length + 1) }, '');
  let key = draftKey();
  try { found = JSON.parse(localStorage.getItem(key) ?? 'null'); } catch { return; }
  // Of a file, the draft of another tab that was closed or is still open; the latest that belongs to what is in the folder.
  if (!found && key.includes(OWN)) {
    found = drafts().find((each) => ofDraft(each.key)[0] === ofDraft(key)[0] && each.base === text().defaultValue && each.text !== each.base);
    key = found?.key ?? key;
  }
  // Behind a page of the browser that says that nothing answers, an axis that was begun has lost its name: the latest draft that was
  // begun with the same values is offered.
  const isBegun = new URLSearchParams(location.search).has('begin');
  if (!found && isBegun) {
    found = drafts().find((each) => each.from === location.search && each.text !== text().defaultValue);
    key = found?.key ?? key;
  }
  const isSame = found?.text === text().defaultValue;
  if (continued && found) {
    if (isSame) { saved = found.base; buttons(); }
    restore(found);
    return;
  }
  if (!found || (isSame && !found.typed?.length) || (!isSame && found.base !== text().defaultValue && found.base !== '')) return;
  const kind = first || performance.getEntriesByType('navigation')[0]?.type;
  if (kind === 'reload' || kind === 'back_forward') { restore(found); tell(said('restored')); return; }
  const chosen = (then) => () => { place.replaceChildren(); $('#standing')?.focus({ preventScroll: true }); then(); };
  place.replaceChildren(`${said('draft')} ${fileName()}, ${instant(found.at)} `,
    button(said('restore'), chosen(() => restore(found))), ' ', button(said('discard'), chosen(() => localStorage.removeItem(key))));
}
// The text of a draft, then what was typed into its fields while nothing answered.
function restore({ text: value, typed = [] }) {
  const retype = () => {
    for (const [id, held] of typed) {
      const field = document.getElementById(id);
      if (!field) continue;
      field.value = held;
      field.dispatchEvent(new Event('change', { bubbles: true }));
    }
  };
  if (value === text().value) { retype(); return; }
  if (typed.length > 0) document.addEventListener('htmx:after:swap', retype, { once: true });
  put(value);
}
// The start page lists what was not saved, the latest first.
const UNSAVED_SHOWN = 3;
function unsaved() {
  const place = $('#unsaved');
  if (!place) return;
  const rows = drafts().map((each) => {
    const row = document.createElement('li');
    const [of, tab] = ofDraft(each.key);
    // An axis without a name is called by its mechanism, as its tile is.
    const kind = /^\s*\[(?:axis\.)?(?:mechanism\.)?(\w+)\]/gm;
    const tile = [...each.text.matchAll(kind)].map(([, of]) => $(`.tile[data-kind="${of}"]`)).find(Boolean);
    const name = /^\s*name\s*=\s*"([^"]*)"/m.exec(each.text)?.[1] || tile?.textContent.trim().replaceAll('\u00ad', '');
    const go = () => {
      if (!of.startsWith('/')) { try { if (tab) sessionStorage.setItem(CHOSEN, tab); } catch { /* a browser that keeps nothing */ } location.href = `${root()}?${new URLSearchParams({ open: of, lang: document.documentElement.lang })}`; return; }
      try { sessionStorage.setItem(CONTINUED, each.key); } catch { /* a browser that keeps nothing */ }
      // An axis that was begun goes on at the address that it was begun with, so that reloading it posts nothing again.
      if (new URLSearchParams(each.from ?? '').has('begin')) location.href = root() + each.from;
      else begin(each.text, each.file || 'axis.toml');
    };
    const file = of.startsWith('/') ? each.file : of;
    row.append(button([name, file === 'axis.toml' && name ? '' : file].filter(Boolean).join(' – '), go), ` ${instant(each.at)} `,
      button(said('discard'), () => { localStorage.removeItem(each.key); unsaved(); ($('#unsaved:not([hidden]) button') ?? $('.tile'))?.focus(); }));
    return row;
  });
  // An axis that was brought along has no address of its own: reloading it leads here, and on to it.
  const reloaded = performance.getEntriesByType('navigation')[0]?.type === 'reload' && history.state?.axis;
  if (reloaded && location.search === '') {
    const place = drafts().findIndex((each) => each.key === `${DRAFT}/${history.state.axis}`);
    if (place >= 0) { rows[place].querySelector('button').click(); return; }
  }
  const [list, more] = place.querySelectorAll('ul');
  list.replaceChildren(...rows.slice(0, UNSAVED_SHOWN));
  more.replaceChildren(...rows.slice(UNSAVED_SHOWN));
  more.parentElement.hidden = rows.length <= UNSAVED_SHOWN;
  more.parentElement.firstElementChild.textContent = `+ ${rows.length - UNSAVED_SHOWN}`;
  place.hidden = rows.length === 0;
}
export function put(value) {
  const field = text();
  if (!field) return;
  field.value = value;
  field.dispatchEvent(new Event('change', { bubbles: true }));
}
// A field that has the focus while a step is taken shows the text of that step too, unless something was typed into it since.
let stepTo = null;
let typedSince = null;
document.addEventListener('input', ({ target }) => { if (stepTo !== null) typedSince = target; }, true);
function showStep() {
  if (stepTo === null || text()?.defaultValue !== stepTo) return;
  stepTo = null;
  for (const field of all('#fields input[type=text], #fields textarea')) if (field !== typedSince && field.value !== field.defaultValue) field.value = field.defaultValue;
}
function stepped(from, to) {
  // What is being pulled ends first: it is one step.
  if (base() !== undefined) { addEventListener('antrieb:pulled', () => stepped(from, to), { once: true }); return; }
  if (from.length === 0) return;
  to.push(last);
  last = from.pop();
  [stepTo, typedSince] = [last, null];
  put(last);
  buttons();
}

// What a browser keeps of a field is not what the page says: it is put right behind every answer.
function right() {
  for (const select of all('select[data-chosen]')) if (document.activeElement !== select) select.value = select.dataset.chosen;
  for (const box of all('input[data-checked]')) box.checked = box.dataset.checked === 'true';
  const held = (name) => $(`#state [name=${name}]`)?.value;
  // Even the same language set once more has the style of the whole page computed again.
  if (held('lang') && document.documentElement.lang !== held('lang')) document.documentElement.lang = held('lang');
  if (held('theme') === 'dark') document.documentElement.dataset.theme = 'dark'; else delete document.documentElement.dataset.theme;
  note();
  showStep();
  overlay();
  cursor();
  tolerances();
  follow();
}
// What somebody has opened or closed stays so.
const folds = new Map();
document.addEventListener('click', (event) => {
  const fold = event.target.closest?.('summary')?.parentElement;
  if (fold?.id && !fold.matches('.menu')) folds.set(fold.id, !fold.open);
}, true);
export const opened = (ids) => { for (const id of ids) folds.set(id, true); };
// A menu that is open stays so.
let menus = [];
let hadFocus = false;
document.addEventListener('htmx:before:swap', () => { hadFocus = document.activeElement !== document.body; });
document.addEventListener('htmx:before:swap', () => { menus = all('.menu[open]').map((menu) => [menu.id, menu.contains(document.activeElement) ? document.activeElement.id : '']); });
document.addEventListener('htmx:after:swap', () => {
  for (const [id, focus] of menus) { const menu = document.getElementById(id); if (menu) menu.open = true; if (focus && document.activeElement.id !== focus) document.getElementById(focus)?.focus(); }
  menus = [];
  for (const [id, open] of folds) { const fold = document.getElementById(id); if (fold) fold.open = open; }
  right();
  // What is new takes the focus, unless a field inside has it: any part of the page may be swapped while one types.
  const isNew = (title) => { const is = title && title.dataset.seen === undefined; if (is) title.dataset.seen = ''; return is; };
  const isTypedIn = (part) => part.contains(document.activeElement) && document.activeElement.matches('input, textarea, select');
  const head = $('#detail-title');
  if (isNew(head) && !isTypedIn($('#detail'))) head.focus();
  for (const place of all('.begin-form .fault')) {
    for (const field of place.parentElement.querySelectorAll('[aria-describedby]')) {
      if (place.childElementCount > 0) field.setAttribute('aria-invalid', 'true'); else field.removeAttribute('aria-invalid');
    }
  }
  const begin = $('#begin-title');
  if (isNew(begin) && !isTypedIn(begin.closest('form'))) { $('#begin input[type=text]')?.focus(); $('#begin input[type=text]')?.select(); begin.closest('form').scrollIntoView({ block: 'nearest' }); }
  // What had the focus is gone: the verdict, which the change was about, takes it.
  if (hadFocus && document.activeElement === document.body) $('#standing')?.focus({ preventScroll: true });
});
// A beginning with a fault is not sent: its first field with one takes the focus. It is examined as it is sent, since what was typed last
// may not have been answered yet.
const examined = new WeakMap();
const valuesOf = (form) => String(new URLSearchParams(new FormData(form)));
document.addEventListener('submit', async (event) => {
  const form = event.target;
  if (!form.matches('.begin-form') || examined.get(form) === valuesOf(form)) return;
  event.preventDefault();
  event.stopImmediatePropagation();
  const values = valuesOf(form);
  const reply = await fetch(`/begin/drawing?${values}`).catch(() => undefined);
  const answer = new DOMParser().parseFromString(reply?.ok ? await reply.text() : '', 'text/html');
  let wrong;
  for (const part of answer.querySelectorAll('template[hx-target]')) {
    const place = form.querySelector(part.getAttribute('hx-target'));
    if (!place) continue;
    place.replaceChildren(...document.importNode(part.content, true).childNodes);
    for (const field of place.parentElement.querySelectorAll('[aria-describedby]')) {
      if (place.childElementCount > 0) { field.setAttribute('aria-invalid', 'true'); wrong ??= field; } else field.removeAttribute('aria-invalid');
    }
  }
  if (wrong) { wrong.focus(); return; }
  examined.set(form, values);
  form.requestSubmit();
}, true);
// The drawer gives the focus back to where it was opened.
let opener = null;
export const openedBy = (element) => { if (!$('#detail').contains(element)) opener = element === document.body ? null : element.id || element; };
document.addEventListener('htmx:before:request', (event) => {
  const { ctx } = event.detail;
  if (ctx.target?.id === 'detail' && !$('#detail').contains(ctx.sourceElement)) opener = ctx.sourceElement.id || ctx.sourceElement;
});
// What the drawer showed before leads back: what is opened from inside it is put on a trail.
const trail = [];
let inside = null;
document.addEventListener('htmx:before:swap', (event) => {
  const { ctx } = event.detail;
  inside = ctx.target?.id === 'detail' && $('#detail').contains(ctx.sourceElement) ? $('#detail').innerHTML : null;
  if (ctx.target?.id === 'detail' && !$('#detail').contains(ctx.sourceElement)) trail.length = 0;
});
document.addEventListener('htmx:after:swap', () => {
  if (inside !== null) { trail.push(inside); inside = null; if (trail.length > 20) trail.shift(); }
  const back = $('#detail-back');
  if (back) back.hidden = trail.length === 0;
});
document.addEventListener('click', (event) => {
  if (!event.target.closest?.('[data-back]') || trail.length === 0) return;
  const drawer = $('#detail');
  drawer.innerHTML = trail.pop();
  htmx.process(drawer);
  const back = $('#detail-back');
  if (back) back.hidden = trail.length === 0;
  $('#detail-title')?.focus();
});
// Shows an element in the drawer, one step further than what it shows.
export function onward(title, content) {
  const drawer = $('#detail');
  trail.push(drawer.innerHTML);
  const section = drawer.firstElementChild.cloneNode(false);
  section.append(drawer.querySelector('.bar-head').cloneNode(true), content);
  drawer.replaceChildren(section);
  $('#detail-title').textContent = title;
  $('#detail-back').hidden = false;
  drawer.scrollTop = 0;
  $('#detail-title').focus({ preventScroll: true });
}
export function shut() {
  const drawer = $('#detail');
  if (!drawer?.firstElementChild) return false;
  trail.length = 0;
  drawer.replaceChildren();
  const to = typeof opener === 'string' ? document.getElementById(opener) : opener?.isConnected ? opener : null;
  (to?.closest('details.menu:not([open])')?.querySelector('summary') ?? to ?? $('#tools'))?.focus();
  opener = null;
  return true;
}
// What has not changed is not sent again: it stays as it is. Should it not be there, the whole page is requested.
htmx.registerExtension('antrieb', {
  htmx_before_morph_node: (_, { newNode }) => newNode.dataset?.same === undefined,
  // Styles of elements are set by scripts alone; taken away and set again they would have the style of all inside computed twice.
  htmx_before_morph_attr: (element, { attrName }) => attrName !== 'style' && (attrName !== 'aria-selected' || !element.dataset.left) && (attrName !== 'open' || !folds.has(element.id)) && !(attrName === 'value' && isAhead(element)),
});
// A field of a calculator that was changed behind the request keeps what it holds: the next request carries it.
let carried = null;
document.addEventListener('htmx:before:swap', (event) => { carried = event.detail.ctx.request?.body; });
const isAhead = (element) => ['tool', 'tool-view'].includes(element.form?.id) && carried instanceof URLSearchParams && carried.has(element.name)
  && carried.get(element.name) !== element.value;
document.addEventListener('htmx:after:swap', () => {
  if (!$('[data-same]:not(#view, #reserve)')) return;
  for (const each of all('[data-part]')) delete each.dataset.part;
  text()?.dispatchEvent(new Event('change', { bubbles: true }));
});
const parts = () => all('[data-part]').map((each) => `${each.id}=${each.dataset.part}`).join(' ');
addEventListener('antrieb:pulled', note);

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

// What was found of the tolerances stays as long as it is about what is shown; where it is found quickly, it is asked for unasked.
const judged = new Map();
let asked = null;
function tolerances() {
  const place = $('#tolerances');
  const found = $('#tolerances-found');
  if (!place || !found) return;
  if (asked !== null && found.childElementCount > 0 && found.dataset.of === undefined) {
    found.dataset.of = asked;
    judged.clear();
    judged.set(asked, found.innerHTML);
  }
  const of = place.dataset.of;
  if (found.dataset.of === of && found.childElementCount > 0) return;
  if (judged.has(of)) { found.innerHTML = judged.get(of); found.dataset.of = of; return; }
  found.replaceChildren();
  delete found.dataset.of;
  if (asked !== of && place.dataset.atOnce !== undefined) $('#tolerances-go').click();
}
document.addEventListener('htmx:before:request', (event) => { if (event.detail.ctx.sourceElement.id === 'tolerances-go') asked = $('#tolerances').dataset.of; });

// A failed request is reported; the page stays as it is.
document.addEventListener('htmx:response:error', (event) => {
  tell(sentences(event.detail.ctx.text));
});
// No answer: what was typed is sent again as soon as antrieb answers.
const unsent = new Set();
function gone(event) {
  const source = event.detail?.ctx?.sourceElement;
  if (source?.id) {
    unsent.delete(source.id);
    unsent.add(source.id);
    if (text() && isNamed) keepDraft(last !== saved);
  }
  document.documentElement.dataset.away = '';
  tell('');
}
export const isAway = () => document.documentElement.dataset.away !== undefined;
export function back() {
  if (!isAway()) return;
  delete document.documentElement.dataset.away;
  tell(said('answers'));
  const sources = [...unsent];
  unsent.clear();
  for (const id of sources) document.getElementById(id)?.dispatchEvent(new Event('change', { bubbles: true }));
  if (savesAgain) idle().then(save);
}
export const away = () => { if (!isAway()) gone({}); };
document.addEventListener('htmx:error', gone);

// A law chosen by its picture is chosen in the plain menu.
document.addEventListener('change', (event) => {
  const menu = event.target.closest?.('[data-law]');
  const plain = menu && document.getElementById(menu.dataset.law);
  if (!plain) return;
  plain.value = event.target.value;
  plain.dispatchEvent(new Event('change', { bubbles: true }));
});

export const fields = () => new URLSearchParams(new FormData($('#state')));
async function send(path) {
  try { return await fetch(path, { method: 'POST', body: fields() }); } catch { away(); return undefined; }
}
// A file for the user.
export function keep(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
// What a client of the interface would ask for, about the axis and the actuator that are shown.
// Files are named after the project, of one of several axes with its name too; before a project has a name, after its axis.
const stem = () => {
  const file = ($('#file')?.value || 'axis.toml').replace(/\.toml$/i, '').trim() || 'axis';
  return file === 'axis' ? /^\s*name\s*=\s*"([^"]+)"/m.exec(text()?.value ?? '')?.[1] ?? file : file;
};
const plain = (name) => name.trim().replace(/[^\p{L}\p{N}._-]+/gu, '-');
async function download(what, ending) {
  const held = (name) => $(`#state [name=${name}]`)?.value ?? '';
  const query = new URLSearchParams({ lang: held('lang') });
  const tab = $('.tabs [aria-current][data-axis]');
  if (tab && what !== 'report') query.set('axis', tab.dataset.axis);
  if (held('code') && what !== 'size' && (what !== 'report' || !$('.tabs'))) query.set('code', held('code'));
  if (what === 'report') {
    query.set('date', new Date().toISOString().slice(0, 10));
    for (const field of document.querySelectorAll('#report-fields [data-report]')) {
      const lines = field.type === 'checkbox' ? (field.checked ? ['true'] : []) : field.value.split('\n');
      for (const line of lines) if (line.trim()) query.append(field.dataset.report, line.trim());
    }
  }
  tell('…');
  const reply = await fetch(`/api/v1/${what}?${query}`, { method: 'POST', headers: { 'content-type': 'application/toml' }, body: text().value });
  if (!reply.ok) {
    const fault = await reply.json().catch(() => ({ errors: [{ message: reply.statusText }] }));
    tell(fault.errors.map((each) => each.message).join('; '));
    return;
  }
  const axis = query.has('axis') ? `-${query.get('axis')}` : '';
  keep(await reply.blob(), `${plain(stem() + axis)}.${ending}`);
  tell('');
}
function project() { keep(new Blob([text().value], { type: 'application/toml' }), $('#file')?.value || 'axis.toml'); }
export function choose(accept, then) {
  const chooser = document.createElement('input');
  chooser.type = 'file';
  chooser.accept = accept;
  chooser.addEventListener('change', () => { if (chooser.files[0]) then(chooser.files[0]); });
  chooser.click();
}
// The name of a file in a header, which holds ASCII only.
export const named = (reply) => { const name = reply.headers.get('x-file'); return name === null ? undefined : decodeURIComponent(name); };
let savesAgain = false;
const idle = () => new Promise((then) => { const look = setInterval(() => { if (!$('.htmx-request')) { clearInterval(look); then(); } }, 100); });
export async function save() {
  const reply = await send('/save');
  // It is saved when antrieb answers again, with what was typed until then.
  savesAgain = !reply;
  if (!reply) return;
  const words = await reply.text();
  if (reply.ok) {
    try { localStorage.removeItem(draftKey()); for (const each of drafts()) if (each.text === last && ofDraft(each.key)[0] === ofDraft(draftKey())[0]) localStorage.removeItem(each.key); } catch { /* a browser that keeps nothing */ }
    $('#file').value = named(reply) ?? $('#file').value;
    $('#file-name').textContent = $('#file').value;
    $('#state [name=known]').value = `${reply.headers.get('x-version') ?? ''} ${$('#file').value}`;
    saved = last;
    // Reloading and a bookmark lead to the saved file, not to what it was begun with.
    try { history.replaceState(history.state, '', `${root()}?${new URLSearchParams({ open: $('#file').value, lang: document.documentElement.lang })}`); } catch { /* a page opened as a file keeps its address */ }
    buttons();
    tell(words);
  } else if (reply.status === 404) {
    project();
    saved = last;
    buttons();
  } else {
    tell(words);
    if (reply.status === 409) dispatchEvent(new CustomEvent('antrieb:conflict', { detail: named(reply) ?? $('#file').value }));
    // A file that was opened keeps its name where another one is refused.
    const of = ($('#state [name=known]')?.value ?? '').split(' ').slice(1).join(' ');
    if (of) { $('#file').value = of; $('#file-name').textContent = of; }
  }
}
// What was loaded from the folder, or merged with what is there: undo leads back.
export function loaded(value, base = value) {
  put(value);
  saved = base;
  buttons();
}
// The text that the unsaved changes are made from.
export const savedText = () => saved;
// The whole page about a text.
export function begin(value, name) {
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
  document.body.append(form);
  form.requestSubmit();
}
// The address of the page itself, without what a project was begun with.
function home() {
  const address = new URL(location.href);
  const query = new URLSearchParams();
  for (const name of ['open', 'lang']) if (address.searchParams.has(name)) query.set(name, address.searchParams.get(name));
  return `${address.pathname}${query.size ? '?' + query : ''}`;
}
// A link holds the text behind its mark, which no browser sends.
async function link() {
  const packed = await new Response(new Blob([text().value]).stream().pipeThrough(new CompressionStream('deflate-raw'))).arrayBuffer();
  const code = btoa(String.fromCharCode(...new Uint8Array(packed))).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
  history.replaceState(history.state, '', `${home()}#p=${code}`);
  await navigator.clipboard?.writeText(location.href).catch(() => {});
  tell(location.href.length > 200 ? location.href.slice(0, 200) + '…' : location.href);
}
async function linked() {
  if (!location.hash.startsWith('#p=')) return;
  const bytes = Uint8Array.from(atob(location.hash.slice(3).replaceAll('-', '+').replaceAll('_', '/')), (sign) => sign.charCodeAt(0));
  const value = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).text();
  if (text()) { if (text().value !== value) put(value); } else begin(value, 'axis.toml');
}
if (document.readyState === 'complete') linked().catch(() => {}); else addEventListener('DOMContentLoaded', () => linked().catch(() => {}));

document.addEventListener('click', (event) => {
  const of = (name) => event.target.closest?.(`[data-${name}]`);
  if (of('undo')) stepped(past, future);
  else if (of('redo')) stepped(future, past);
  else if (of('save')) save();
  else if (of('link')) link();
  else if (of('api')) download(of('api').dataset.api, of('api').dataset.ending);
  else if (of('project')) project();
  else if (of('close')) shut();
  else if (of('shuts')) shuts = of('shuts');
  else if (of('instant')) { lead(of('instant')); jump(Number(of('instant').dataset.instant)); }
  else if (of('into')) { const field = document.getElementById(of('into').dataset.into); field.value = event.target.closest('button').value; field.dispatchEvent(new Event('change', { bubbles: true })); }
});
// What shuts the drawer stays in it until it is answered: what waits for its turn must still be of the page.
let shuts = null;
document.addEventListener('htmx:finally:request', (event) => { if (shuts && event.detail.ctx.sourceElement === shuts) { shuts = null; shut(); } });
// A mark in a picture leads to the row of its check.
let led = null;
function lead(mark) {
  led = mark.dataset.row ?? mark.closest('tr')?.id ?? null;
  follow();
}
function follow() {
  for (const row of all('tr.lit')) row.classList.toggle('lit', row.id === led);
  if (led) document.getElementById(led)?.classList.add('lit');
}
addEventListener('keydown', (event) => {
  if (!(event.ctrlKey || event.metaKey)) return;
  const typing = event.target.closest?.('input, textarea');
  if (event.key === 's') { event.preventDefault(); save(); }
  else if (event.key === 'z' && !typing) { event.preventDefault(); stepped(event.shiftKey ? future : past, event.shiftKey ? past : future); }
  else if (event.key === 'y' && !typing) { event.preventDefault(); stepped(future, past); }
});
addEventListener('beforeunload', (event) => { if (last !== null && last !== saved) event.preventDefault(); });
// Language and theme hold for whatever is asked next, before the page has them.
document.addEventListener('click', (event) => {
  const button = event.target.closest?.('#language, #theme');
  if (!button) return;
  const values = Object.entries(JSON.parse(button.getAttribute('hx-vals')));
  for (const [name, value] of values) { const field = $(`#state [name=${name}]`); if (field) field.value = value; }
  // Reloading keeps the language.
  const address = new URL(location.href);
  for (const [name, value] of values) if (address.searchParams.has(name)) address.searchParams.set(name, value);
  try { history.replaceState(history.state, '', address); } catch { /* a page opened as a file keeps its address */ }
  if (button.id === 'theme') try { localStorage.setItem(THEME, $('#state [name=theme]').value); } catch { /* a browser that keeps nothing */ }
}, true);
// The theme of the last visit, else that of the machine.
const THEME = 'antrieb-theme';
function themed() {
  let wanted = null;
  try { wanted = localStorage.getItem(THEME); } catch { /* a browser that keeps nothing */ }
  wanted ??= matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
  const held = $('#state [name=theme]');
  if (!held || held.value === wanted || new URLSearchParams(location.search).has('theme')) return;
  if (wanted === 'dark') document.documentElement.dataset.theme = wanted; else delete document.documentElement.dataset.theme;
  held.value = wanted;
  htmx.ajax('POST', '/', { source: $('#theme'), target: 'body', swap: 'outerMorph', values: { theme: wanted } });
}
document.addEventListener('input', (event) => { if (event.target.id === 'file') { $('#file-name').textContent = event.target.value; } });
// The versions of this session, the last first: undo leads to them too.
document.addEventListener('click', (event) => {
  if (!event.target.closest?.('[data-versions]')) return;
  const all = [...past, last];
  const body = new URLSearchParams({ lang: document.documentElement.lang });
  for (const version of all.slice(-20)) body.append('version', version);
  fetch('/versions', { method: 'POST', body }).then(async (reply) => {
    if (!reply.ok) return;
    opener = 'versions';
    trail.length = 0;
    $('#detail').innerHTML = await reply.text();
    htmx.process($('#detail'));
    $('#detail-title')?.focus();
  }, away);
});
document.addEventListener('click', (event) => {
  const chosen = event.target.closest?.('[data-version]');
  if (chosen) put(chosen.parentElement.querySelector('textarea').value);
});
// A module runs when the page is there.
right();
draft();
isNamed = true;
if (last !== null) buttons();
unsaved();
themed();
// The verdict is what a page with an axis is about.
if (document.activeElement === document.body) $('#standing')?.focus({ preventScroll: true });
