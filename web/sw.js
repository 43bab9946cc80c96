// Keeps the page for use without a connection. The build puts `BUILD`, a list of its files with their hashes, in front of this.
//
// A build is stored whole, in a cache of its own, before any of it is used; from then on every load of the page gets it. Pages that are
// open stay with theirs, whichever worker serves them, because all that a page loads has its hash in its name. The worker of an earlier build
// ends with the last of these pages, and then the earlier builds go.

const { version, files, modules } = BUILD;
const page = registration.scope;
/** Has the name of the cache of the newest build that is whole. */
const store = `abflat ${page}`;
const own = `${store} ${version}`;
/** The build of the module that runs in this browser; the others are fetched where that should change. */
const module = modules[new URL(location).searchParams.get('build')];

const urlOf = ([path]) => new URL(path, page).href;

/** What is sent with another hash belongs to another build. Headers may have changed even where the content has not. */
const fetchFile = (file) =>
  fetch(urlOf(file), { integrity: file[1], cache: 'no-cache', redirect: 'error' });

async function storeBuild() {
  const isNew = !(await caches.has(own));
  try {
    const cache = await caches.open(own);
    await Promise.all(
      [...files, ...(module ? [module] : [])].map(async (file) =>
        cache.put(urlOf(file), await fetchFile(file)),
      ),
    );
  } catch (error) {
    if (isNew) await caches.delete(own);
    throw error;
  }
  const cache = await caches.open(store);
  await cache.put(page, new Response(own));
}

async function newest() {
  const name = await caches.match(page, { cacheName: store });
  return name?.text();
}

const namesOfBuilds = async () =>
  (await caches.keys()).filter((name) => name.startsWith(`${store} `));

async function deleteEarlier() {
  // The cache of a build that is being stored is not the newest one yet.
  if (registration.installing) return;
  const kept = await newest();
  for (const name of await namesOfBuilds()) if (name !== kept) await caches.delete(name);
}

const matchIn = (name, url) => caches.match(url, { cacheName: name, ignoreVary: true });

async function pageOf(event) {
  const name = await newest();
  const response = name && (await matchIn(name, page));
  if (response) return response;
  event.waitUntil(keepAnew());
  return fetch(event.request);
}

/** Where nothing is kept any more, for the browser has deleted it, or the page is gone. */
async function keepAnew() {
  await deleteEarlier();
  await storeBuild().catch(() => registration.unregister());
}

async function fileOf(event) {
  const { request } = event;
  const first = await newest();
  const others = (await namesOfBuilds()).filter((name) => name !== first);
  for (const name of first ? [first, ...others] : others) {
    const response = await matchIn(name, request.url);
    if (response) return response;
  }
  const other = Object.values(modules).find((file) => urlOf(file) === request.url);
  return other ? fetchModule(event, other) : fetch(request);
}

/** Once fetched it is there like the other files. */
async function fetchModule(event, file) {
  const response = await fetchFile(file);
  if (await caches.has(own)) {
    const copy = response.clone();
    event.waitUntil(caches.open(own).then((cache) => cache.put(urlOf(file), copy)));
  }
  return response;
}

/**
 * Where the page was taken away, or another one has its place, as on a port of localhost, the kept one would hide that. The one that is
 * being loaded still gets its files.
 */
async function forgetIfGone() {
  const { status } = await fetch(location, { method: 'HEAD', cache: 'no-store' });
  if (status === 404 || status === 410) await caches.delete(store);
}

addEventListener('install', (event) => event.waitUntil(storeBuild()));
addEventListener('activate', (event) => event.waitUntil(deleteEarlier()));
addEventListener('fetch', (event) => {
  const { method, mode, url } = event.request;
  if (method !== 'GET' || !url.startsWith(page)) return;
  if (mode !== 'navigate') return event.respondWith(fileOf(event));
  if (![page, `${page}index.html`].includes(url.replace(/[?#].*/, ''))) return;
  event.respondWith(pageOf(event));
  event.waitUntil(forgetIfGone().catch(() => undefined)); // without a connection nobody knows
});
