// The folder: a file that another has changed since it was opened is merged with what is not saved here; where both changed the same
// value, the user is asked.
import { loaded, save, savedText, tell } from './page.js';
const $ = (selector) => document.querySelector(selector);
const known = () => $('#state [name=known]');
const lang = () => document.documentElement.lang;

// Of a file of another name than the one that was opened no version is known.
function opened(name) {
  const value = known()?.value ?? '';
  const of = value.slice(value.indexOf(' ') + 1);
  return name === undefined || name === of ? value : ` ${name}`;
}
let shown = '';
let isOfSaving = false;
// The verdict takes the focus of a question that is answered.
function cleared() {
  const notice = $('#disk');
  const had = notice?.contains(document.activeElement);
  notice?.replaceChildren();
  isOfSaving = false;
  if (had) $('#standing')?.focus({ preventScroll: true });
}
let isLooking = false;
async function look(asked, isSaving = false) {
  const notice = $('#disk');
  if (!notice || !asked || document.hidden || isLooking) return;
  isLooking = true;
  try {
    const reply = await fetch(`/watch?${new URLSearchParams({ known: asked, lang: lang() })}`).catch(() => undefined);
    // The choices about a refused name stay until one is made.
    if (reply?.status !== 200) { if (reply?.status === 204 && (isSaving || !isOfSaving)) { cleared(); shown = ''; } return; }
    const version = reply.headers.get('x-version') ?? '';
    const words = await reply.text();
    const of = asked + version + words;
    if (shown === of && notice.firstChild) return;
    shown = of;
    if (version === '') notice.innerHTML = words; else await merge(asked, undefined, isSaving);
  } finally { isLooking = false; }
}
async function merge(asked, prefer, isSaving) {
  const body = new URLSearchParams(new FormData($('#state')));
  body.set('known', asked);
  body.set('base', savedText());
  if (prefer) body.set('prefer', prefer);
  const before = body.get('text');
  const reply = await fetch('/merge', { method: 'POST', body }).catch(() => undefined);
  if (!reply?.ok) { if (reply) tell(await reply.text()); return; }
  const found = new URLSearchParams(await reply.text());
  if (found.has('notice')) { $('#disk').innerHTML = found.get('notice'); isOfSaving = isSaving === true; return; }
  // What was typed meanwhile is merged with the next look.
  if ($('#text').value !== before) { shown = ''; return; }
  known().value = found.get('known');
  loaded(found.get('text'), found.get('base'));
  cleared();
  tell(found.get('said'));
  if (isSaving) save();
}
async function load(name) {
  const reply = await fetch(`/text?${new URLSearchParams({ file: name, lang: lang() })}`);
  const text = await reply.text();
  if (!reply.ok) { tell(text); return; }
  known().value = `${reply.headers.get('x-version') ?? ''} ${name}`;
  $('#file').value = name;
  loaded(text);
  cleared();
  tell('');
}
document.addEventListener('click', (event) => {
  const button = event.target.closest?.('[data-disk]');
  if (button?.dataset.disk === 'load') load(button.dataset.name);
  else if (button?.dataset.disk === 'merge') merge(opened(), button.dataset.prefer, false);
  else if (button?.dataset.disk === 'mine') {
    known().value = button.dataset.known;
    cleared();
    tell('');
    $('#save')?.focus();
  } else if (button?.dataset.disk === 'as') {
    $('#file').value = button.dataset.name;
    cleared();
    save();
  } else if (button?.dataset.disk === 'over') {
    known().value = button.dataset.known;
    $('#file').value = button.dataset.known.split(' ').slice(1).join(' ');
    cleared();
    save();
  }
});
addEventListener('antrieb:conflict', ({ detail }) => look(opened(detail), true));
addEventListener('focus', () => look(opened()));
document.addEventListener('visibilitychange', () => look(opened()));
setInterval(() => look(opened()), 4000);
