// The token of the printed address. The browser keeps it for this origin alone: scheme, address and port. A cookie would go to every
// port of the address, so to a server of another user of the machine. It is sent as a header, and with what no script sends in the query.
(() => {
  const NAME = 'antrieb-token';
  const address = new URL(location.href);
  const isLocked = document.documentElement.dataset.locked !== undefined;
  const brought = address.searchParams.get('token');
  const keep = (value) => { try { if (value) localStorage.setItem(NAME, value); else localStorage.removeItem(NAME); } catch { /* a browser that keeps nothing */ } };
  const kept = () => { try { return localStorage.getItem(NAME); } catch { return null; } };
  const opened = (href, token) => { const url = new URL(href, location.href); url.searchParams.set('token', token); return url.href; };
  if (brought !== null) {
    address.searchParams.delete('token');
    history.replaceState(history.state, '', address);
    if (!isLocked) keep(brought);
    else if (brought === kept()) keep(null);
  }
  if (isLocked) {
    // What the browser has kept opens the page, unless that was refused just now. How the page was opened, and the name of its axis, are kept for it.
    const token = kept();
    if (!token || token === brought) return;
    try { sessionStorage.setItem('antrieb-navigation', performance.getEntriesByType('navigation')[0]?.type ?? ''); sessionStorage.setItem('antrieb-axis', history.state?.axis ?? ''); } catch { /* a browser that keeps nothing */ }
    location.replace(opened(location.href, token));
    return;
  }
  const token = brought ?? kept();
  if (!token) return;
  const plain = window.fetch.bind(window);
  window.fetch = (to, options) => {
    const request = new Request(to, options);
    if (new URL(request.url).origin === location.origin) request.headers.set('authorization', `Bearer ${token}`);
    return plain(request);
  };
  const isOurs = (href) => { const url = new URL(href, location.href); return url.origin === location.origin && url.protocol === location.protocol && !url.pathname.startsWith('/theory/'); };
  // The address with the token is that of the request alone: what is shown and copied goes without it.
  function briefly(element, name, value) {
    const before = element.getAttribute(name);
    element.setAttribute(name, value);
    setTimeout(() => { if (before === null) element.removeAttribute(name); else element.setAttribute(name, before); });
  }
  for (const kind of ['click', 'auxclick']) addEventListener(kind, (event) => {
    const link = event.target.closest?.('a[href]');
    if (!event.defaultPrevented && link && !link.getAttribute('href').startsWith('#') && isOurs(link.href)) briefly(link, 'href', opened(link.href, token));
  });
  addEventListener('submit', (event) => {
    const form = event.target;
    const action = form.getAttribute('action') ?? location.href;
    if (event.defaultPrevented || form.getAttribute('method') === 'dialog' || !isOurs(action)) return;
    if (form.getAttribute('method') === 'post') { briefly(form, 'action', opened(action, token)); return; }
    const field = Object.assign(document.createElement('input'), { type: 'hidden', name: 'token', value: token });
    form.append(field);
    setTimeout(() => field.remove());
  });
})();
