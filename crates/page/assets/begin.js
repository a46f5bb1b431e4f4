// A beginning on the start page: reloading keeps its tile and what was typed.
const BEGUN = 'antrieb-begun';
const form = () => document.querySelector('main.start .begin-form');
const kept = () => { try { return JSON.parse(sessionStorage.getItem(BEGUN) ?? '[]'); } catch { return []; } };
const values = (of) => [...new FormData(of)].filter(([, value]) => typeof value === 'string');

function restored() {
  const held = new Map(kept());
  if (!form() || held.get('begin') !== form().elements.begin?.value) return;
  for (const [name, value] of held) {
    const field = form().elements[name];
    if (field && field.type !== 'hidden' && field.value !== value) {
      field.value = value;
      field.dispatchEvent(new Event('change', { bubbles: true }));
    }
  }
}
document.addEventListener('input', ({ target }) => {
  if (!target.closest?.('main.start .begin-form')) return;
  try { sessionStorage.setItem(BEGUN, JSON.stringify(values(form()))); } catch { /* a browser that keeps nothing */ }
});
document.addEventListener('htmx:after:swap', () => {
  const kind = form()?.elements.begin?.value;
  if (!kind || new URLSearchParams(location.search).get('kind') === kind) return;
  const address = new URL(location.href);
  address.searchParams.set('kind', kind);
  try { history.replaceState(history.state, '', address); } catch { /* a page opened as a file keeps its address */ }
});
restored();
