// Files that come from outside: a project is opened, a recording is shown first and written only when it is used. They are chosen,
// dropped anywhere, or pasted.
import { begin, choose, named, fields, openedBy, put, said, sentences, shut, tell } from './page.js';
const $ = (selector) => document.querySelector(selector);
const ENDINGS = '.csv,.txt,.tsv,.parquet,.pq,.gz,.zst';
const PREVIEW = '/recording/preview';

// A project has keys or headings of TOML at the beginning of a line; whatever else comes is a recording, or is said to be none.
async function isProject(file) {
  if (/\.toml$/i.test(file.name)) return true;
  const head = await file.slice(0, 4096).text();
  return !head.startsWith('PAR1') && /^\s*format\s*=\s*\d+\s*$|^\s*\[\[?(axis|load|motion|mechanism\.\w+)\]?\]\s*$/m.test(head);
}
export async function bring(file) {
  if (await isProject(file)) { begin(await file.text(), /\.toml$/i.test(file.name) ? file.name : 'axis.toml'); return; }
  const most = Number($('#messages').dataset.most);
  if (file.size > most) { tell(said('tooLarge')); return; }
  brought = file;
  openedBy(document.activeElement);
  $('#detail').textContent = '';
  tell(`${file.name} …`);
  await ask('');
}

// The file stays here until it is used; each question carries it. The next question ends the one before it.
let brought = null;
let asking = null;
function body(changed) {
  const query = new URLSearchParams(fields());
  query.set('text', $('#text')?.value ?? '');
  query.set('name', brought.name);
  query.set('changed', changed);
  const form = $('#incoming');
  if (form) for (const [key, value] of new FormData(form)) query.append(key, value);
  return new Blob([query.toString(), '\n', brought]);
}
const send = (path, content, signal) => fetch(path, { method: 'POST', headers: { 'content-type': 'application/octet-stream' }, body: content, signal });
async function ask(changed) {
  asking?.abort();
  const mine = new AbortController();
  asking = mine;
  $('#incoming')?.setAttribute('aria-busy', 'true');
  try {
    const reply = await send(PREVIEW, body(changed), mine.signal);
    const words = await reply.text();
    if (asking !== mine || brought === null) return;
    if (!reply.ok) { tell(sentences(words)); return; }
    show(words);
    tell('');
  } catch { if (asking === mine) tell(said('noAnswer')); } finally { if (asking === mine) asking = null; }
}
// What has the focus keeps it, and the drawer its place.
function show(words) {
  const drawer = $('#detail');
  const focus = drawer.contains(document.activeElement) ? document.activeElement.id : '';
  const open = [...drawer.querySelectorAll('details[open]')].map((each) => each.id);
  const at = drawer.scrollTop;
  drawer.innerHTML = words;
  htmx.process(drawer);
  for (const id of open) { const fold = document.getElementById(id); if (fold) fold.open = true; }
  drawer.scrollTop = at;
  (document.getElementById(focus) ?? $('#detail-title'))?.focus({ preventScroll: true });
}
async function use() {
  const button = $('#incoming-use');
  const form = $('#incoming');
  if (!button || button.disabled || !brought || form.dataset.used !== undefined) return;
  form.dataset.used = '';
  asking?.abort();
  const reply = await send('/recording', body('')).catch(() => undefined);
  const words = await reply?.text();
  if (!reply?.ok) { delete form.dataset.used; tell(reply ? sentences(words) : said('noAnswer')); return; }
  brought = null;
  shut();
  $('#standing')?.focus({ preventScroll: true });
  if ($('#text')) put(words); else begin(words, named(reply) ?? 'axis.toml');
}
document.addEventListener('change', (event) => { if (brought && event.target.form?.id === 'incoming') ask(event.target.name); });
addEventListener('submit', (event) => { if (event.target.id === 'incoming') { event.preventDefault(); use(); } }, true);

document.addEventListener('click', (event) => {
  if (event.target.closest?.('[data-open]')) choose(`.toml,${ENDINGS}`, bring);
  else if (event.target.closest?.('[data-recording]')) choose(ENDINGS, bring);
});

const hasFiles = (event) => [...(event.dataTransfer?.types ?? [])].includes('Files');
let deep = 0;
function over(is) { document.documentElement.toggleAttribute('data-drop', is); if (!is) deep = 0; }
addEventListener('dragenter', (event) => { if (hasFiles(event)) { deep += 1; over(true); } });
addEventListener('dragleave', (event) => { if (hasFiles(event) && (deep -= 1) <= 0) over(false); });
addEventListener('dragover', (event) => { if (hasFiles(event)) { event.preventDefault(); event.dataTransfer.dropEffect = 'copy'; } });
addEventListener('drop', (event) => {
  if (!hasFiles(event)) return;
  event.preventDefault();
  over(false);
  const { files } = event.dataTransfer;
  if (files.length > 1) tell(said('oneFile'));
  if (files[0]) bring(files[0]);
});

addEventListener('paste', (event) => {
  if (event.target.closest?.('input, textarea')) return;
  const [file] = event.clipboardData?.files ?? [];
  const pasted = event.clipboardData?.getData('text') ?? '';
  // A table has several lines, and numbers in several columns.
  const rows = pasted.split(/\r\n?|\n/).filter((row) => row.trim());
  const isTable = rows.length > 1 && rows.some((row) => row.split(/[;\t|]|,(?=\s|-?\d*\.)|,/).filter((cell) => /\d/.test(cell)).length > 1);
  const isText = rows.length > 1 && /^\s*format\s*=\s*\d/m.test(pasted);
  if (!file && !isTable && !isText) return;
  event.preventDefault();
  bring(file ?? new File([pasted], 'pasted.csv', { type: 'text/csv' }));
});
