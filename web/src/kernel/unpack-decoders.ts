// The decoders of compressed glTF. The build copies them into the folder `wasm`, as nothing but a
// bundler would find them in their npm packages.

import createDraco, { type DracoModule } from './wasm/draco-decoder.mjs';
import { MeshoptDecoder } from './wasm/meshopt-decoder.mjs';

let module: Promise<DracoModule> | undefined;

/** Draco, loaded when it is first asked for. */
export function draco(): Promise<DracoModule> {
  module ??= fetch(new URL('./wasm/draco-decoder.wasm', import.meta.url))
    .then((response) => {
      if (!response.ok) throw new Error(`the Draco decoder cannot be fetched: ${response.status}`);
      return response.arrayBuffer();
    })
    .then((wasmBinary) => createDraco({ wasmBinary }))
    .catch((cause: unknown) => {
      module = undefined;
      throw cause;
    });
  return module;
}

/** meshoptimizer, which carries its module in itself. */
export async function meshopt(): Promise<typeof MeshoptDecoder> {
  await MeshoptDecoder.ready;
  return MeshoptDecoder;
}
