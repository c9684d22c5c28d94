// The decoders of compressed glTF, each loaded when it is first needed. The build copies them into the
// folder `wasm`, since only a bundler would find them in their npm packages.

import type { DracoModule } from '../wasm/draco-decoder.mjs';
import type { MeshoptDecoder } from '../wasm/meshopt-decoder.mjs';
import { loadedModule } from '../workers/loading-failure.js';

/** A new instance. One that has run out of memory cannot be used again. */
export function draco(): Promise<DracoModule> {
  return loadedModule(
    async () => {
      const [{ default: createDraco }, response] = await Promise.all([
        import('../wasm/draco-decoder.mjs'),
        fetch(new URL('../wasm/draco-decoder.wasm', import.meta.url)),
      ]);
      if (!response.ok) throw new Error(`the Draco decoder cannot be fetched: ${response.status}`);
      return createDraco({ wasmBinary: await response.arrayBuffer() });
    },
    import.meta.url,
  );
}

/** Its script contains the WebAssembly module. */
export function meshopt(): Promise<typeof MeshoptDecoder> {
  return loadedModule(
    async () => {
      const decoder = (await import('../wasm/meshopt-decoder.mjs')).MeshoptDecoder;
      await decoder.ready;
      return decoder;
    },
    import.meta.url,
  );
}
