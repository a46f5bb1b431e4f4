// What is printed is the first page of the report, not the window.
import { $, asked } from './cursor.js';

const paper = () => $('#paper');
async function printed() {
  const reply = $('#state') ? await fetch('/paper', { method: 'POST', body: asked('') }).catch(() => null) : null;
  const page = reply?.ok ? new DOMParser().parseFromString(await reply.text(), 'text/html').body : null;
  paper()?.remove();
  // Without an answer the window is printed as the style sheet arranges it.
  if (page?.childElementCount) {
    const section = document.createElement('section');
    section.id = 'paper';
    section.append(...page.childNodes);
    document.body.append(section);
  }
  print();
}
addEventListener('afterprint', () => paper()?.remove());
document.addEventListener('click', ({ target }) => { if (target.closest?.('[data-print]')) printed(); });
addEventListener('keydown', (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.key !== 'p' || !$('#state')) return;
  event.preventDefault();
  printed();
});
