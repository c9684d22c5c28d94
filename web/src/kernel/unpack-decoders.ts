// The decoders of compressed glTF, each loaded when it is first asked for. The build copies them into
// the folder `wasm`, as nothing but a bundler would find them in their npm packages.

import type { DracoModule } from './wasm/draco-decoder.mjs';
import type { MeshoptDecoder } from './wasm/meshopt-decoder.mjs';

/** A new instance, as one that has met the end of its memory is of no more use. */
export async function draco(): Promise<DracoModule> {
  const [{ default: createDraco }, response] = await Promise.all([
    import('./wasm/draco-decoder.mjs'),
    fetch(new URL('./wasm/draco-decoder.wasm', import.meta.url)),
  ]);
  if (!response.ok) throw new Error(`the Draco decoder cannot be fetched: ${response.status}`);
  return createDraco({ wasmBinary: await response.arrayBuffer() });
}

/** It carries its WebAssembly module in itself. */
export async function meshopt(): Promise<typeof MeshoptDecoder> {
  const decoder = (await import('./wasm/meshopt-decoder.mjs')).MeshoptDecoder;
  await decoder.ready;
  return decoder;
}
