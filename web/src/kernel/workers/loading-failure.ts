// Why a part of the program could not be loaded, and what to do about it: PROGRAM_NOT_LOADED.

import { failure, fieldsOf, type GirthError } from '../types/errors.js';
import { isElsewhere, scriptFromElsewhere } from './worker-from-elsewhere.js';

/** The remedy where the program lies on another origin. */
const orCopy = 'or copy the folder dist of the package to this site';
const allowOrigin = (origin: string) =>
  `let ${origin} send the header Access-Control-Allow-Origin with all files of the package, .wasm too, ${orCopy}`;

/** The remedy where the program is a package that Node.js has loaded. */
export const installAgain =
  'install the package girth again; a file of it is missing, damaged or of another version';

/** Why `new Worker` has failed. */
export function workerNotMade(thrown: unknown): GirthError {
  const text = String(thrown);
  const isRefused = thrown instanceof DOMException && thrown.name === 'SecurityError';
  const hint = isRefused
    ? 'let the content security policy of this page allow worker-src'
    : /TrustedScriptURL/.test(text)
      ? `let the content security policy of this page allow trusted-types girth 'allow-duplicates'`
      : `use a browser with workers; in Node.js, import 'girth'`;
  return failure('PROGRAM_NOT_LOADED', `a worker cannot be made: ${text}`, { hint, cause: thrown });
}

/** Why the script of a worker could not be loaded; browsers do not report it. */
export async function workerNotLoaded(worker: object): Promise<GirthError> {
  const script = scriptFromElsewhere(worker);
  if (script === undefined) {
    return failure('PROGRAM_NOT_LOADED', 'the script of a worker could not be loaded', {
      hint: `check that the folder of the package is on the server as a whole, and that a content security policy allows worker-src 'self'`,
    });
  }
  const { origin } = new URL(script);
  try {
    const { ok, status } = await fetch(script);
    if (!ok) {
      return failure('PROGRAM_NOT_LOADED', `${script} could not be loaded: status ${status}`, {
        hint: `let ${origin} have the folder dist of the package as a whole`,
      });
    }
  } catch (cause) {
    const message = `${script}, of another origin, could not be loaded`;
    return failure('PROGRAM_NOT_LOADED', message, { hint: allowOrigin(origin), cause });
  }
  return failure('PROGRAM_NOT_LOADED', `a worker was not allowed to import ${script}`, {
    hint: `let the content security policy of this page allow worker-src blob: and script-src ${origin}, ${orCopy}`,
  });
}

/** Why a worker has ended before it could be asked anything: an error of its script, in the browser's words. */
export function workerNotStarted(text: string): GirthError {
  return failure('PROGRAM_NOT_LOADED', `the script of a worker has failed as it started: ${text}`, {
    hint: 'reload the page; if it stays, a script on the server is damaged or of another version, or the browser is too old',
  });
}

/**
 * The module of WebAssembly that `load` gives; or the reason why it could not be loaded. `from`: the address
 * of the script that loads it.
 */
export async function loadedModule<Module>(
  load: () => Promise<Module>,
  from: string,
): Promise<Module> {
  try {
    return await load();
  } catch (thrown) {
    const { code, message } = fieldsOf(thrown);
    if (code !== 'INTERNAL') throw thrown;
    // Emscripten's words around the browser's.
    const text = message.replace(/^Aborted\(([^]*)\)\. Build with .*$/, '$1');
    const hint = /unsafe-eval|content security policy|blocked by CSP/i.test(text)
      ? `let the content security policy of this page allow script-src 'wasm-unsafe-eval'`
      : isElsewhere(from)
        ? allowOrigin(new URL(from).origin)
        : from.startsWith('file:')
          ? installAgain
          : 'reload the page; if it stays, the .wasm file is missing on the server, damaged, or of another version';
    throw failure('PROGRAM_NOT_LOADED', `a WebAssembly module could not be loaded: ${text}`, {
      hint,
      cause: thrown,
    });
  }
}
