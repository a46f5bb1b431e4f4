// The folder: a file that another has changed since it was opened is noticed, and whose is kept is asked.
import { loaded, tell } from './page.js';
const $ = (selector) => document.querySelector(selector);
const known = () => $('#state [name=known]');

// Of a file of another name than the one that was opened no version is known.
function opened(name) {
  const value = known()?.value ?? '';
  const of = value.slice(value.indexOf(' ') + 1);
  return name === undefined || name === of ? value : ` ${name}`;
}
let shown = '';
async function look(asked) {
  const notice = $('#disk');
  if (!notice || !asked || document.hidden) return;
  const query = new URLSearchParams({ known: asked, lang: document.documentElement.lang });
  const reply = await fetch(`/watch?${query}`).catch(() => undefined);
  if (reply?.status !== 200) { if (reply?.status === 204) { notice.replaceChildren(); shown = ''; } return; }
  const version = reply.headers.get('x-version') ?? '';
  const words = await reply.text();
  if (shown === asked + version + words && notice.firstChild) return;
  shown = asked + version + words;
  notice.innerHTML = words;
}
async function load(name) {
  const query = new URLSearchParams({ file: name, lang: document.documentElement.lang });
  const reply = await fetch(`/text?${query}`);
  const text = await reply.text();
  if (!reply.ok) { tell(text); return; }
  known().value = `${reply.headers.get('x-version') ?? ''} ${name}`;
  $('#file').value = name;
  loaded(text);
  $('#disk').replaceChildren();
  tell('');
}
document.addEventListener('click', (event) => {
  const button = event.target.closest?.('[data-disk]');
  if (button?.dataset.disk === 'load') load(button.dataset.name);
  else if (button?.dataset.disk === 'mine') {
    known().value = button.dataset.known;
    $('#disk').replaceChildren();
    tell('');
    $('#save')?.focus();
  }
});
addEventListener('antrieb:conflict', () => look(opened($('#file')?.value)));
addEventListener('focus', () => look(opened()));
document.addEventListener('visibilitychange', () => look(opened()));
setInterval(() => look(opened()), 4000);
