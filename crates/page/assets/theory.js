// A chapter of the theory opens in the drawer; the derivation that led to it stays one step back.
import { onward } from './page.js';

const base = () => new URL('theory/', document.baseURI);

document.addEventListener('click', async (event) => {
  const link = event.target.closest?.('#detail a[data-chapter], #detail #theory a[href]');
  if (!link || event.button !== 0 || event.ctrlKey || event.metaKey || event.shiftKey) return;
  const isInside = link.closest('#theory');
  const address = link.getAttribute('href');
  event.preventDefault();
  if (address.startsWith('#')) { document.getElementById(address.slice(1))?.scrollIntoView(); return; }
  const to = new URL(address, isInside ? base() : document.baseURI);
  const reply = await fetch(to.pathname).catch(() => null);
  const chapter = reply?.ok ? new DOMParser().parseFromString(await reply.text(), 'text/html').querySelector('#theory') : null;
  // Without an answer the browser shows its own.
  if (!chapter) { location.assign(to); return; }
  for (const picture of chapter.querySelectorAll('img[src]')) picture.src = new URL(picture.getAttribute('src'), base()).href;
  const title = chapter.querySelector('h1');
  title?.remove();
  onward(title?.textContent ?? '', chapter);
  if (to.hash) document.getElementById(to.hash.slice(1))?.scrollIntoView();
});
