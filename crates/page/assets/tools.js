// The tools: a record of measured values goes to and from files; its changes are sent as any other change of the form.
import { choose, keep } from './page.js';
const $ = (selector) => document.querySelector(selector);
const tell = (words) => { const status = $('#record-status'); if (status) status.textContent = words; };
const language = () => document.documentElement.lang;

// The tools begin with the actuator that is shown.
document.addEventListener('htmx:before:request', (event) => {
  const { action, body } = event.detail.ctx.request;
  if (!action.endsWith('/tools') || !(body instanceof URLSearchParams) || body.has('about') || body.get('code')) return;
  const shown = $('#standing strong.code')?.textContent.trim();
  if (shown) body.set('about', shown);
});

// The tool of a view about the project follows its changes.
document.addEventListener('htmx:after:swap', (event) => {
  if (event.detail.ctx.request?.action?.endsWith('/work')) $('#tool-view[data-follows]')?.dispatchEvent(new Event('antrieb:again'));
});

async function save() {
  const [text, file, known] = ['#record-text', '#record-file', '#record-known'].map((id) => $(id).value);
  const reply = await fetch('/save', { method: 'POST', body: new URLSearchParams({ text, file, known, lang: language() }) });
  if (reply.ok) $('#record-known').value = `${reply.headers.get('x-version') ?? ''} ${file}`;
  tell(await reply.text());
}
const download = () => keep(new Blob([$('#record-text').value], { type: 'application/toml' }), $('#record-file').value);
async function open(file) {
  $('#record-file').value = file.name;
  $('#record-known').value = '';
  $('#record-text').value = await file.text();
  $('#record-text').dispatchEvent(new Event('change', { bubbles: true }));
}
// A fault that has no field stands in the text.
function line(number) {
  const field = $('#text');
  if (!field) return;
  document.documentElement.dataset.left = 'text';
  const lines = field.value.split('\n');
  const begin = lines.slice(0, number - 1).reduce((sum, each) => sum + each.length + 1, 0);
  field.focus();
  field.setSelectionRange(begin, begin + (lines[number - 1]?.length ?? 0));
  field.scrollTop = field.scrollHeight * (number - 3) / lines.length;
}
document.addEventListener('click', (event) => {
  const place = event.target.closest?.('[data-line]')?.dataset.line;
  if (place) { event.preventDefault(); line(Number(place)); }
  const what = event.target.closest?.('[data-record]')?.dataset.record;
  if (what === 'save') save();
  else if (what === 'download') download();
  else if (what === 'open') choose('.toml', open);
});

// The shaft of the encoder turns by hand.
document.addEventListener('input', (event) => {
  const field = document.getElementById(event.target.dataset?.turns);
  if (!field) return;
  field.value = `${event.target.value} deg`;
  field.dispatchEvent(new Event('input', { bubbles: true }));
});

// An explanation stays within the page, and goes with Escape until the term is left.
function inside(event) {
  const tip = event.target.closest?.('.tip');
  const text = tip?.querySelector('.tip-text');
  if (!text) return;
  text.style.left = '0';
  const over = text.getBoundingClientRect().right - document.documentElement.clientWidth + 8;
  if (over > 0) text.style.left = `${-over}px`;
}
for (const kind of ['mouseover', 'focusin']) document.addEventListener(kind, inside);
addEventListener('keydown', (event) => {
  if (event.key === 'Escape') for (const tip of document.querySelectorAll('.tip:hover, .tip:focus-within')) tip.classList.add('shut');
});
for (const kind of ['mouseout', 'focusout']) document.addEventListener(kind, (event) => {
  const tip = event.target.closest?.('.tip');
  if (tip && !tip.contains(event.relatedTarget)) tip.classList.remove('shut');
});
