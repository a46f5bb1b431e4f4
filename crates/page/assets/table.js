// The table of the segments: rows of a spreadsheet are pasted into it, Enter and the arrows lead to the cell above or below.
const cell = (target) => (target.dataset?.cell !== undefined ? target : target.closest?.('.segment-line')?.querySelector('select') === target ? target : null);
addEventListener('paste', (event) => {
  const into = cell(event.target);
  const rows = event.clipboardData?.getData('text') ?? '';
  if (!into || !/[\t\n]/.test(rows.trim())) return;
  event.preventDefault();
  event.stopImmediatePropagation();
  // The cell shows what the answer says, not what was being typed.
  document.addEventListener('htmx:after:swap', () => { if (into.matches('input')) into.value = into.defaultValue; }, { once: true });
  const { row } = into.closest('.segment-line').dataset;
  const path = into.closest('[data-path]').dataset.path;
  htmx.ajax('POST', '/work', { source: into.closest('.segment-line'), values: { rows, into: [path.replace(/\[\d+\]\.[a-z_]+$/, ''), row, into.dataset.cell ?? 0].join(' ') } });
}, true);
document.addEventListener('keydown', (event) => {
  const from = event.target.dataset?.cell !== undefined ? event.target : null;
  const by = { ArrowUp: -1, ArrowDown: 1, Enter: 1 }[event.key];
  if (!from || !by || event.ctrlKey || event.altKey || event.metaKey) return;
  const row = Number(from.dataset.row) + by;
  const to = document.querySelector(`[data-cell="${from.dataset.cell}"][data-row="${row}"]`);
  if (!to) return;
  event.preventDefault();
  to.focus();
  to.select();
});
