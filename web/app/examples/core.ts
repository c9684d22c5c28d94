// The core in Node.js: the WebAssembly module that the page uses too. Programs that use it are run from
// the top of the repository.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Triangles } from './polygonise.ts';

interface Failed {
  code: string;
  message: string;
}

/** Functions of the module that examples need (`web/src/kernel/workers/wasm-modules.d.ts`). */
interface Module {
  jobSurface(
    positions: Float64Array,
    indices: Uint32Array,
    vertexOfInput: Uint32Array,
    inputOfVertex: Uint32Array,
  ): { surface: { delete(): void } } | Failed;
  remesh(
    surface: { delete(): void },
    faces: number,
    even: boolean,
    onProgress: (fraction: number) => boolean,
  ): { described: { positions: Float64Array; indices: Uint32Array } } | Failed;
}

type CreateModule = (options: { wasmBinary: Uint8Array }) => Promise<Module>;

export interface Core {
  /**
   * A surface remeshed to about `faces` triangles of even size and good shape (`girth/remesh.h`).
   */
  remeshEvenly(
    surface: Triangles,
    faces: number,
  ): { positions: Float64Array; indices: Uint32Array };
}

function checked<Answer>(answer: Answer | Failed): Answer {
  if ('code' in (answer as Failed)) throw new Error((answer as Failed).message);
  return answer as Answer;
}

/** Throws where the module has not been built. */
export async function loadCore(): Promise<Core> {
  const folder = join(process.cwd(), 'web/src/kernel/wasm');
  const script = pathToFileURL(join(folder, 'girth-analysis.mjs')).href;
  const { default: create } = (await import(/* @vite-ignore */ script)) as {
    default: CreateModule;
  };
  // Handed in: the module itself knows only how browsers fetch it.
  const module = await create({ wasmBinary: readFileSync(join(folder, 'girth-analysis.wasm')) });
  return {
    remeshEvenly({ positions, indices }, faces) {
      const own = Uint32Array.from({ length: positions.length / 3 }, (_, vertex) => vertex);
      const { surface } = checked(
        module.jobSurface(Float64Array.from(positions), Uint32Array.from(indices), own, own),
      );
      try {
        return checked(module.remesh(surface, faces, true, () => true)).described;
      } finally {
        surface.delete();
      }
    },
  };
}
