// Lets the page work offline after the first visit: keeps every file of one version, and answers with them.
//
// The build writes the list of files with their hashes into this worker (`web/scripts/offline.mjs`). Files are kept by
// path and hash: another version fetches only what has changed, and a page gets all of its files from one version.
// Files are as the server has sent them, headers included, so that threads are there offline where they were online. A
// new version waits until the page asks for it. Files that are not listed, such as models of others, are none of its
// business, but for the documentation: what was read of it can be read again.

interface Lasting extends Event {
  waitUntil(work: Promise<unknown>): void;
}
interface Fetching extends Lasting {
  readonly request: Request;
  respondWith(answer: Promise<Response>): void;
}
interface Scope {
  /** SHA-256 in base64, by path. */
  readonly girthFiles: Readonly<Record<string, string>>;
  readonly registration: { readonly scope: string };
  skipWaiting(): Promise<void>;
  addEventListener(type: 'install' | 'activate', act: (event: Lasting) => void): void;
  addEventListener(type: 'fetch', act: (event: Fetching) => void): void;
  addEventListener(type: 'message', act: (event: MessageEvent) => void): void;
}

const worker = self as unknown as Scope;
const files = new Map(Object.entries(worker.girthFiles));
const { scope } = worker.registration;
// Another page of the same server has another store.
const store = `girth ${scope}`;
const documentation = new URL('docs/', scope).href;
const readStore = `girth documentation ${scope}`;
const first = 'index.html';

/** The address under which a file is kept, with its version. */
function keyOf(path: string): string {
  return `${new URL(path, scope).href}?${encodeURIComponent(files.get(path)!)}`;
}

/** Servers may send the first page only without its name, and others from elsewhere: then browsers would refuse them. */
async function fetchFile(path: string): Promise<Response> {
  const response = await fetch(new URL(path === first ? '' : path, scope), {
    cache: 'no-cache',
    integrity: `sha256-${files.get(path)!}`,
  });
  if (!response.ok) throw new Error(`${path}: the server answered ${response.status}`);
  if (!response.redirected) return response;
  const { status, headers } = response;
  return new Response(await response.blob(), { status, headers });
}

/** Fetches missing files; files that were fetched stay, should the rest fail. */
async function fetchAll(): Promise<void> {
  const kept = await caches.open(store);
  const known = new Set((await kept.keys()).map(({ url }) => url));
  const missing = [...files.keys()].filter((path) => !known.has(keyOf(path)));
  await Promise.all(missing.map(async (path) => kept.put(keyOf(path), await fetchFile(path))));
}

/** Deletes all files of other versions. */
async function forgetOthers(): Promise<void> {
  const kept = await caches.open(store);
  const ours = new Set([...files.keys()].map(keyOf));
  const all = await kept.keys();
  await Promise.all(all.filter(({ url }) => !ours.has(url)).map((key) => kept.delete(key)));
}

/** Which file is asked for; undefined for what is not listed. */
function pathOf({ method, url }: Request): string | undefined {
  if (method !== 'GET' || !url.startsWith(scope)) return undefined;
  const path = new URL(url).pathname.slice(new URL(scope).pathname.length) || first;
  return files.has(path) ? path : undefined;
}

const isDocumentation = ({ method, url }: Request) =>
  method === 'GET' && url.startsWith(documentation);

async function answer(path: string, request: Request): Promise<Response> {
  // Browsers may clear what is kept at any time.
  const kept = await caches.match(keyOf(path), { cacheName: store, ignoreVary: true });
  return kept ?? fetch(request);
}

/** The network comes first: documentation is of no version. */
async function answerAndKeep(event: Fetching): Promise<Response> {
  const { request } = event;
  try {
    const response = await fetch(request);
    if (response.status === 200) event.waitUntil(keepRead(request, response.clone()));
    return response;
  } catch (failure) {
    const kept = await caches.match(request, { cacheName: readStore, ignoreVary: true });
    if (!kept) throw failure;
    return kept;
  }
}

async function keepRead(request: Request, response: Response): Promise<void> {
  try {
    await (await caches.open(readStore)).put(request, response);
  } catch {
    // The browser has no room left.
  }
}

worker.addEventListener('install', (event) => event.waitUntil(fetchAll()));
worker.addEventListener('activate', (event) => event.waitUntil(forgetOthers()));
worker.addEventListener('fetch', (event) => {
  const path = pathOf(event.request);
  if (path !== undefined) event.respondWith(answer(path, event.request));
  else if (isDocumentation(event.request)) event.respondWith(answerAndKeep(event));
});
worker.addEventListener('message', ({ data }) => {
  if (data === 'take over') void worker.skipWaiting();
});
