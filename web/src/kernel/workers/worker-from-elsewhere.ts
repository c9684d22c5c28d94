// Workers whose scripts lie on another origin than the page, on a CDN for example. Browsers start workers
// only with scripts of the page's own origin. So the worker's script is one line that belongs to the page,
// and imports the other one. The other server has to allow that (CORS), and a policy of the page, too.

import { trustedScript } from './trusted-script.js';

/** Addresses of the scripts of one line, by those of the scripts that they import. */
const importers = new Map<string, string>();

/** The scripts that workers import from another origin. */
const imported = new WeakMap<object, string>();

/** Whether an address is of another origin than the page. */
export function isElsewhere(address: string): boolean {
  return /^https?:/i.test(address) && new URL(address).origin !== globalThis.origin;
}

/** The address of the script that a worker imports from another origin; undefined where it does not. */
export function scriptFromElsewhere(worker: object): string | undefined {
  return imported.get(worker);
}

/** `Worker` that also takes scripts of other origins, all as modules, and has the page trust them. */
export function workerFromAnywhere(Own: typeof Worker): typeof Worker {
  return class extends Own {
    constructor(script: string | URL, options?: WorkerOptions) {
      const address = String(script);
      if (!isElsewhere(address)) {
        super(trustedScript(script), options);
        return;
      }
      super(trustedScript(importerOf(address)), { ...options, type: 'module' });
      imported.set(this, address);
    }
  };
}

/**
 * Makes a worker wherever its script lies. `open` calls `new Worker(new URL(...))`, as bundlers recognise it, and
 * gives the worker or what holds it.
 */
export function openWorker<Made>(open: () => Made): Made {
  const own = globalThis.Worker as typeof Worker | undefined;
  if (!own) return open();
  // Only `open` knows the script's address. Nothing else runs meanwhile.
  globalThis.Worker = workerFromAnywhere(own);
  try {
    return open();
  } finally {
    globalThis.Worker = own;
  }
}

/** The address of a script of the page's own origin that imports another one. */
function importerOf(address: string): string {
  let importer = importers.get(address);
  if (importer === undefined) {
    const line = `import ${JSON.stringify(address)};`;
    importer = URL.createObjectURL(new Blob([line], { type: 'text/javascript' }));
    importers.set(address, importer);
  }
  return importer;
}
