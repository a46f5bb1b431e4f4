// Keeps the files of the page, all of one version together, so that it opens without a network.
const VERSION = 'antrieb @version@';
const FILES = @files@;
addEventListener('install', (event) => {
  const fresh = FILES.map((file) => new Request(file, { cache: 'reload' }));
  event.waitUntil(caches.open(VERSION).then((cache) => cache.addAll(fresh)));
});
addEventListener('activate', (event) => {
  const old = (names) => names.filter((name) => name.startsWith('antrieb ') && name !== VERSION);
  event.waitUntil(caches.keys().then((names) => Promise.all(old(names).map((name) => caches.delete(name)))));
});
addEventListener('fetch', (event) => {
  if (event.request.method !== 'GET') return;
  const found = caches.open(VERSION).then((cache) => cache.match(event.request, { ignoreSearch: true }));
  event.respondWith(found.then((reply) => reply ?? fetch(event.request)));
});
