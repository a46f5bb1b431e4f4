// A work that takes longer says how far it is, and can be cancelled.
const QUIET = 700;
const BETWEEN = 400;
const works = new Map();

document.addEventListener('htmx:before:request', (event) => {
  const { ctx } = event.detail;
  if (event.defaultPrevented || ctx.request.method?.toUpperCase() !== 'POST') return;
  const name = crypto.getRandomValues(new Uint32Array(4)).join('-');
  ctx.request.headers['X-Work'] = name;
  works.set(ctx, name);
  setTimeout(() => { if (works.has(ctx)) show(); }, QUIET);
});
document.addEventListener('htmx:finally:request', (event) => {
  works.delete(event.detail.ctx);
  if (works.size === 0) hide();
});

let shown = false;
async function show() {
  const busy = document.getElementById('busy');
  const text = document.getElementById('busy-text');
  if (shown || !busy || !text) return;
  shown = true;
  busy.hidden = false;
  while (shown && works.size > 0) {
    const [name] = works.values();
    const reply = await fetch(`/progress?work=${name}&lang=${document.documentElement.lang}`).catch(() => null);
    text.textContent = reply?.ok ? await reply.text() : text.dataset.usual;
    await new Promise((resolve) => setTimeout(resolve, BETWEEN));
  }
  hide();
}
function hide() {
  shown = false;
  const busy = document.getElementById('busy');
  if (busy) busy.hidden = true;
}
document.addEventListener('click', (event) => {
  if (!event.target.closest?.('[data-cancel]')) return;
  for (const name of works.values()) fetch(`/cancel?work=${name}`, { method: 'POST' }).catch(() => {});
});
