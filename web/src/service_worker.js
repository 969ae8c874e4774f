// Serves the page without a network once it was loaded: all files are taken from a cache, which a
// new build replaces as a whole.
const PREFIX = 'schlupf-';
const version = PREFIX + VERSION;
const files = FILES;

self.addEventListener('install', (event) => {
  event.waitUntil(
    caches
      .open(version)
      .then((cache) => cache.addAll(files))
      .then(() => self.skipWaiting()),
  );
});

self.addEventListener('activate', (event) => {
  event.waitUntil(
    caches
      .keys()
      .then((names) => names.filter((name) => name.startsWith(PREFIX) && name !== version))
      .then((old) => Promise.all(old.map((name) => caches.delete(name))))
      .then(() => self.clients.claim()),
  );
});

// From the cache; what is not in it is kept once it was fetched.
async function answer(request) {
  const cache = await caches.open(version);
  const wanted = request.mode === 'navigate' ? './' : request;
  const cached = await cache.match(wanted, { ignoreSearch: true, ignoreVary: true });
  if (cached) return cached;
  const response = await fetch(request);
  if (response.ok) await cache.put(request, response.clone());
  return response;
}

self.addEventListener('fetch', (event) => {
  const { method, url } = event.request;
  const isOfPage = url.startsWith(self.registration.scope) && !url.endsWith('/case.json');
  if (method === 'GET' && isOfPage) event.respondWith(answer(event.request));
});
