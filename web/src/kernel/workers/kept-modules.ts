// WebAssembly without a network: what a service worker of the page has kept.

/**
 * Lets this worker find modules that the network does not give in the stores of the page's origin. Most browsers ask
 * the service worker of a page also for what its workers fetch; WebKit does so for their scripts alone.
 */
export function findKeptModules(): void {
  const { fetch } = globalThis;
  globalThis.fetch = async (request, options) => {
    try {
      return await fetch(request, options);
    } catch (failure) {
      const { href, pathname } = new URL(request instanceof Request ? request.url : request);
      const kept = pathname.endsWith('.wasm') ? await keptFile(href) : undefined;
      if (kept) return kept;
      throw failure;
    }
  };
}

/** A file that is kept, whatever stands behind its path there; pages without a safe connection keep none. */
async function keptFile(address: string): Promise<Response | undefined> {
  try {
    return await caches.match(address, { ignoreSearch: true, ignoreVary: true });
  } catch {
    return undefined;
  }
}
