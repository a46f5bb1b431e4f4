// A chapter of the theory opens in the drawer; the derivation that led to it stays one step back.
import { onward } from './page.js';

// Umlauts of a heading are escaped in an address.
const toHeading = (hash) => { if (hash) document.getElementById(decodeURIComponent(hash.slice(1)))?.scrollIntoView(); };

document.addEventListener('click', async (event) => {
  const link = event.target.closest?.('#detail a[data-chapter], #detail #theory a[href]');
  if (!link || event.button !== 0 || event.ctrlKey || event.metaKey || event.shiftKey) return;
  const address = link.getAttribute('href');
  event.preventDefault();
  if (address.startsWith('#')) { toHeading(address); return; }
  const to = new URL(address, document.baseURI);
  const reply = await fetch(to.pathname).catch(() => null);
  const chapter = reply?.ok ? new DOMParser().parseFromString(await reply.text(), 'text/html').querySelector('#theory') : null;
  // Without an answer the browser shows its own.
  if (!chapter) { location.assign(to); return; }
  // Addresses of a chapter are relative to it, not to the workbench.
  for (const onwards of chapter.querySelectorAll('a[href]')) {
    const written = onwards.getAttribute('href');
    if (!written.startsWith('#')) onwards.href = new URL(written, to).href;
  }
  for (const picture of chapter.querySelectorAll('img[src]')) picture.src = new URL(picture.getAttribute('src'), to).href;
  const title = chapter.querySelector('h1');
  title?.remove();
  onward(title?.textContent ?? '', chapter);
  toHeading(to.hash);
});
