// The page without a server: what the page asks is answered by the engine, which runs in a worker, and what it saves is kept
// by the browser. Works from a web address and from a folder that is opened as a file.
(() => {
  const own = document.currentScript;
  const home = new URL('.', own.src);
  const isFile = location.protocol === 'file:';
  const html = document.documentElement;
  const asked = new URLSearchParams(location.search);
  html.lang = asked.get('lang') ?? (navigator.language.startsWith('de') ? 'de' : 'en');
  const words = (name) => (document.querySelector(`template[lang=${CSS.escape(html.lang)}]`) ?? document.querySelector('template')).dataset[name];

  // In the worker: the engine of the page and the larger one; each made anew where it has failed.
  function work() {
    const modules = {};
    let engines = {};
    let engine;
    // What the browser keeps, for an engine that begins.
    const files = new Map();
    // It has no clock, no chance and no surroundings: the same input gives the same bytes.
    const NO = 8;
    const zero = (at, bytes) => { new Uint8Array(engine.memory.buffer, at, bytes).fill(0); return 0; };
    const world = {
      clock_time_get: (_, __, at) => zero(at, 8),
      random_get: zero,
      environ_sizes_get: (count, size) => zero(count, 4) + zero(size, 4),
      environ_get: () => 0,
    };
    const imports = { wasi_snapshot_preview1: new Proxy(world, { get: (known, name) => known[name] ?? (() => NO) }) };
    function begin(name) {
      engine = new WebAssembly.Instance(modules[name], imports).exports;
      engine._initialize?.();
      for (const [file, { modified_s, body }] of files) answer({ put: { name: file, modified_s } }, body);
      engines[name] = engine;
    }
    function note({ put, gone }, body) {
      if (put) files.set(put.name, { modified_s: put.modified_s, body });
      if (gone) files.delete(gone.name);
      const answered = Object.values(engines).map((each) => { engine = each; return answer({ put, gone }, body); });
      return answered[0] ?? { head: { status: 204 }, body: new Uint8Array() };
    }
    function asked(head, body, name) {
      if (head.put || head.gone) return note(head, body);
      engine = engines[name];
      if (!engine) begin(name);
      return answer(head, body);
    }
    function answer(head, body) {
      const said = new TextEncoder().encode(JSON.stringify(head));
      const size = 4 + said.length + body.length;
      const at = engine.antrieb_room(size);
      new DataView(engine.memory.buffer).setUint32(at, said.length, true);
      const room = new Uint8Array(engine.memory.buffer, at, size);
      room.set(said, 4);
      room.set(body, 4 + said.length);
      const length = engine.antrieb_answer();
      const answered = new Uint8Array(engine.memory.buffer, engine.antrieb_answered(), length).slice();
      const first = 4 + new DataView(answered.buffer).getUint32(0, true);
      return { head: JSON.parse(new TextDecoder().decode(answered.subarray(4, first))), body: answered.slice(first) };
    }
    self.onmessage = ({ data }) => {
      if (data.module) { modules[data.name] = data.module; return; }
      let answered;
      try { answered = asked(data.head, data.body, data.of); } catch (error) { engines = {}; answered = { head: { status: 500, failed: String(error) } }; }
      self.postMessage({ id: data.id, ...answered }, answered.body ? [answered.body.buffer] : []);
    };
  }

  const source = URL.createObjectURL(new Blob([`(${work})()`], { type: 'text/javascript' }));
  const worker = new Worker(source);
  const waiting = new Map();
  let last = 0;
  worker.onmessage = ({ data }) => { waiting.get(data.id)(data); waiting.delete(data.id); };
  // A folder that is opened as a file has the larger one alone: there nothing is fetched, and its scripts come from it too.
  const FIRST = isFile ? 'interface' : 'engine';
  const said = (head, body = new Uint8Array(), of = FIRST) => new Promise((done) => {
    waiting.set(++last, done);
    worker.postMessage({ id: last, head, body, of });
  });
  const script = (path, set = {}) => new Promise((done, failed) => {
    const element = Object.assign(document.createElement('script'), set, { src: new URL(path, home).href, onload: done, onerror: failed });
    document.head.append(element);
  });
  const outside = window.fetch.bind(window);
  // A file may not be fetched by a file: there the engine comes packed in a script.
  async function compiled(name) {
    if (!isFile) {
      const reply = await outside(new URL(name + '.wasm', home));
      if (!reply.ok) throw new Error(String(reply.status));
      if (reply.headers.get('content-type') === 'application/wasm') return WebAssembly.compileStreaming(reply);
      return WebAssembly.compile(await reply.arrayBuffer());
    }
    await script(name + '.js');
    const packed = Uint8Array.from(atob(self.antriebEngine), (sign) => sign.charCodeAt(0));
    delete self.antriebEngine;
    const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
    return WebAssembly.compile(await new Response(bytes).arrayBuffer());
  }
  const loaded = new Map();
  function engine(name) {
    if (!loaded.has(name)) loaded.set(name, compiled(name).then((module) => worker.postMessage({ name, module })));
    return loaded.get(name);
  }
  const ready = engine(FIRST);

  // What is kept: a file by its name, and a stamp of each that tells which of them another tab has written.
  const database = new Promise((done, failed) => {
    const opening = indexedDB.open('antrieb', 1);
    opening.onupgradeneeded = () => { for (const name of ['files', 'stamps']) opening.result.createObjectStore(name); };
    opening.onsuccess = () => done(opening.result);
    opening.onerror = () => failed(opening.error);
  });
  database.catch(() => {});
  const kept = async (mode, action) => {
    const transaction = (await database).transaction(['files', 'stamps'], mode);
    const request = action(transaction.objectStore('files'), transaction.objectStore('stamps'));
    return new Promise((done, failed) => {
      transaction.oncomplete = () => done(request.result);
      transaction.onerror = transaction.onabort = () => failed(transaction.error);
    });
  };
  const held = new Map();
  async function sync() {
    // Without a store nothing is kept, and nothing is there.
    const stamps = new Map((await kept('readonly', (_, all) => all.getAll()).catch(() => [])).map((stamp) => [stamp.name, stamp]));
    for (const name of held.keys()) if (!stamps.has(name)) { await said({ gone: { name } }); held.delete(name); }
    for (const [name, { stamp, modified_s }] of stamps) {
      if (held.get(name) === stamp) continue;
      const bytes = await kept('readonly', (files) => files.get(name));
      if (!bytes) continue;
      await said({ put: { name, modified_s } }, bytes);
      held.set(name, stamp);
    }
  }
  async function keep(name, modified_s, of) {
    const { body } = await said({ take: { name } }, undefined, of);
    const stamp = { name, modified_s, stamp: `${Date.now()} ${Math.random()}` };
    await kept('readwrite', (files, stamps) => { stamps.put(stamp, name); return files.put(body, name); });
    // The other engine has it as well.
    await said({ put: { name, modified_s } }, body);
    held.set(name, stamp.stamp);
  }
  const forget = (name) => kept('readwrite', (files, stamps) => { stamps.delete(name); return files.delete(name); });
  const alone = (action) => navigator.locks?.request('antrieb', action) ?? action();

  const FORM_MEDIA = 'application/x-www-form-urlencoded';
  // Status of a request that only the larger engine answers; it is fetched with the first of them.
  const MISDIRECTED = 421;
  // One after the other: an answer is that of the files as they are.
  let before = ready;
  function answer(question, body, signal) {
    const ask = async () => {
      signal?.throwIfAborted();
      const now_s = Math.floor(Date.now() / 1000);
      await sync();
      const asking = (of) => said({ ask: { language: html.lang, now_s, ...question } }, body, of);
      let of = FIRST;
      let reply = await asking(of);
      if (reply.head.status === MISDIRECTED) {
        of = 'interface';
        try { await engine(of); } catch (error) {
          console.error(error);
          loaded.delete(of);
          return plain(503, words('none'));
        }
        reply = await asking(of);
      }
      if (reply.head.failed) {
        console.error(reply.head.failed);
        return plain(500, words('failed'));
      }
      const name = reply.head.kept;
      if (!name) return reply;
      try { await keep(name, now_s, of); } catch {
        await said({ gone: { name } });
        return plain(507, words('full'));
      }
      return reply;
    };
    const writes = question.path === '/save' || question.path === '/recording';
    const turn = before.then(() => (writes ? alone(ask) : ask()));
    before = turn.catch(() => {});
    return turn;
  }
  const plain = (status, text) => ({ head: { status, media: 'text/plain; charset=utf-8', headers: [] }, body: new TextEncoder().encode(text) });
  const decoded = (path) => { try { return decodeURIComponent(path); } catch { return path; } };
  window.fetch = async (address, options = {}) => {
    const url = new URL(address, location.href);
    // The chapters of the theory are files beside the engine.
    if (!isFile && url.pathname.startsWith(new URL('theory/', home).pathname)) return outside(address, options);
    const body = options.body === undefined || options.body === null ? new Response() : new Response(options.body);
    const media = new Headers(options.headers).get('content-type') ?? body.headers.get('content-type');
    const question = { post: options.method?.toUpperCase() === 'POST', path: decoded(url.pathname), query: url.search.slice(1), media };
    const { head, body: bytes } = await answer(question, new Uint8Array(await body.arrayBuffer()), options.signal);
    options.signal?.throwIfAborted();
    return new Response(head.status === 204 ? null : bytes, { status: head.status, headers: [['content-type', head.media], ...head.headers] });
  };

  // The state of the page is kept for the tab: a reload loses nothing.
  const STATE = 'antrieb state';
  const FORM = 'antrieb form';
  function remember() {
    const form = document.querySelector('form#state');
    if (!form) return;
    // Where it has no room the page works as it would without.
    try { sessionStorage.setItem(STATE, JSON.stringify([...new FormData(form)])); } catch { sessionStorage.removeItem(STATE); }
  }
  function links() {
    for (const link of document.querySelectorAll('a[href^="/?"]')) link.href = link.getAttribute('href').slice(1);
  }
  // The example or the file that was opened stays in the address: it can be opened again, unlike an axis that was begun.
  const begun = () => `?project${['new', 'open', 'theme'].filter((name) => asked.has(name)).map((name) => `&${name}=${encodeURIComponent(asked.get(name))}`).join('')}`;
  async function show({ head, body }) {
    const text = new TextDecoder().decode(body);
    const page = head.media.startsWith('text/html') ? new DOMParser().parseFromString(text, 'text/html') : undefined;
    if (!page) {
      const line = document.createElement('p');
      line.textContent = text;
      document.body.replaceChildren(line);
      return;
    }
    html.lang = page.documentElement.lang;
    Object.assign(html.dataset, page.documentElement.dataset);
    document.title = page.title;
    document.head.append(...page.querySelectorAll('meta[name=htmx-config]'));
    document.body.replaceWith(document.adoptNode(page.body));
    performance.mark('antrieb-answered');
    links();
    if (document.querySelector('form#state')) { history.replaceState(null, '', location.pathname + begun() + location.hash); remember(); }
    await script('assets/htmx.min.js');
    for (const each of page.querySelectorAll('script[type=module]')) {
      const name = each.getAttribute('src').replace('/assets/', '');
      if (isFile) await import(await module(name)); else await script('assets/' + name, { type: 'module' });
    }
  }
  // A file may not be imported by a file: the engine has the modules too.
  const modules = new Map();
  async function module(name) {
    if (modules.has(name)) return modules.get(name);
    let text = await (await fetch('/assets/' + name)).text();
    for (const [all, before, of] of text.matchAll(/((?:from|import)\s*\(?\s*)['"]\.\/([^'"]+)['"]/g)) text = text.replace(all, `${before}'${await module(of)}'`);
    modules.set(name, URL.createObjectURL(new Blob([text], { type: 'text/javascript' })));
    return modules.get(name);
  }
  const form = (fields) => new TextEncoder().encode(new URLSearchParams(fields).toString());
  function first() {
    const sent = sessionStorage.getItem(FORM);
    const state = sessionStorage.getItem(STATE);
    if (asked.has('post') && sent) {
      sessionStorage.removeItem(FORM);
      const { path, query, fields } = JSON.parse(sent);
      return answer({ post: true, path, query, media: FORM_MEDIA }, form(fields));
    }
    if ((asked.has('project') || asked.has('post')) && state) return answer({ post: true, path: '/', query: '', media: FORM_MEDIA }, form(JSON.parse(state)));
    return answer({ post: false, path: '/', query: location.search.slice(1), media: null });
  }
  const parsed = document.readyState === 'loading' ? new Promise((done) => addEventListener('DOMContentLoaded', done)) : undefined;
  const beginning = first();
  Promise.all([beginning, parsed]).then(([reply]) => show(reply)).then(() => { html.dataset.ready = ''; }, (error) => {
    console.error(error);
    document.querySelector('#waiting').textContent = words('none');
  });

  document.addEventListener('htmx:after:swap', () => { links(); remember(); });
  addEventListener('pagehide', remember);
  // A form that would be sent to a server: the page that it asks for is a page of its own.
  addEventListener('submit', (event) => {
    const url = new URL(event.target.action, location.href);
    if (event.defaultPrevented || event.target.method === 'dialog') return;
    const fields = [...new FormData(event.target, event.submitter)];
    if (event.target.method === 'get') {
      if (event.target.getAttribute('action') !== '/') return;
      event.preventDefault();
      location.assign(`${location.pathname}?${new URLSearchParams(fields)}`);
      return;
    }
    event.preventDefault();
    sessionStorage.setItem(FORM, JSON.stringify({ path: url.pathname, query: url.search.slice(1), fields }));
    location.assign(location.pathname + '?post');
  });
  addEventListener('click', async (event) => {
    const link = event.target.closest?.('a[href^="/"]');
    const gone = event.target.closest?.('[data-forget]');
    if (gone) {
      await forget(gone.dataset.forget);
      const item = gone.closest('li');
      const list = item.parentElement;
      // The button takes the focus with it: the next file has it then, or what opens one.
      const next = (item.nextElementSibling ?? item.previousElementSibling)?.querySelector('[data-forget]');
      item.remove();
      (next ?? list.parentElement.querySelector('[data-open]') ?? document.querySelector('[data-open]'))?.focus();
      if (!list.childElementCount) { list.previousElementSibling.remove(); list.remove(); }
    } else if (link) {
      event.preventDefault();
      const reply = await fetch(link.getAttribute('href'));
      const name = /filename="([^"]+)"/.exec(reply.headers.get('content-disposition') ?? '')?.[1] ?? link.download;
      const copy = document.createElement('a');
      copy.href = URL.createObjectURL(await reply.blob());
      if (name) copy.download = name; else copy.target = '_blank';
      copy.click();
      setTimeout(() => URL.revokeObjectURL(copy.href), 10000);
    }
  });
  // With no network either, where the browser allows it.
  if (!isFile && window.isSecureContext) navigator.serviceWorker?.register(new URL('sw.js', home)).catch(() => {});
})();
