// The kernel's failures. The codes are those of the C++ core (`error_codes.def`).

import type { GirthErrorFields } from './types.js';

/**
 * The codes that arise outside the C++ core, with the hints of `error_codes.def`. A test keeps the two
 * equal. All other codes come from the core, with their hints.
 */
export const hints = {
  USAGE: 'see girth --help',
  VERTEX_OUT_OF_RANGE: 'vertices are numbered from 0 to the vertex count minus one',
  INVALID_POINT:
    'name a vertex, a halfedge or a face of the surface, with weights of at least 0 that add up to 1',
  FILE_NOT_FOUND: 'check the path',
  FILE_UNREADABLE: 'check that it is a file that you may read',
  UNKNOWN_FORMAT: 'use GLB, glTF, OBJ, PLY, STL or OFF',
  MALFORMED_FILE: 'export the model again',
  UNSUPPORTED_FEATURE: 'export the model without that feature',
  MISSING_RESOURCE:
    'keep the files that the model refers to beside it, and open all of them together',
  LIMIT_EXCEEDED: 'use a smaller model',
  CANCELLED: 'run it again to have the result',
  OUT_OF_MEMORY: 'use a smaller model or fewer threads',
  PROGRAM_NOT_LOADED:
    'reload the page; if it stays, a part of the program is missing on its server or not allowed to be loaded',
  INTERNAL: 'please report this with the model',
} as const;

/** Every failure of the kernel. The code is stable; message and hint are for people. */
export class GirthError extends Error implements GirthErrorFields {
  /** 'AbortError' where the code is CANCELLED, as of all that a signal stops; otherwise 'GirthError'. */
  override readonly name: 'AbortError' | 'GirthError';
  /** A stable code, one of those in `error_codes.def`: 'OPEN_EDGE'. */
  readonly code: string;
  /** The first offending vertex, face, line or byte, as the message states; -1 where there is none. */
  readonly element: number;
  /** The remedy. */
  readonly hint: string;

  /** An error of these fields. The options may carry its cause. */
  constructor(fields: GirthErrorFields, options?: ErrorOptions) {
    super(fields.message, options);
    this.name = fields.code === 'CANCELLED' ? 'AbortError' : 'GirthError';
    this.code = fields.code;
    this.element = fields.element;
    this.hint = fields.hint;
  }
}

/** A failure that arose outside the C++ core. */
export function failure(
  code: keyof typeof hints,
  message: string,
  options?: ErrorOptions & { element?: number; hint?: string },
): GirthError {
  const { element = -1, hint = hints[code] } = options ?? {};
  return new GirthError({ code, element, message, hint }, options);
}

/** The work was stopped. `reason` is that of the AbortSignal, kept as the error's cause. */
export function cancelled(message = 'cancelled', reason?: unknown): GirthError {
  return failure('CANCELLED', message, reason === undefined ? undefined : { cause: reason });
}

/** Whatever was thrown, as fields. JavaScript and WebAssembly have several wordings of 'out of memory'. */
export function fieldsOf(thrown: unknown): GirthErrorFields {
  if (thrown instanceof GirthError) {
    const { code, element, message, hint } = thrown;
    return { code, element, message, hint };
  }
  const text = thrown instanceof Error ? thrown.message : String(thrown);
  const memory =
    /out of memory|allocation failed|could not allocate|memory access|Array buffer alloc/i;
  const code =
    memory.test(text) && !/access out of bounds/.test(text) ? 'OUT_OF_MEMORY' : 'INTERNAL';
  return { code, element: -1, message: text, hint: hints[code] };
}
