// The decoders of compressed glTF, copied out of their npm packages to where the kernel loads them from.

import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Complaint, repository } from './run.mjs';

const folder = 'web/src/kernel/wasm';
const packages = {
  draco: 'node_modules/draco3dgltf',
  meshopt: 'node_modules/meshoptimizer',
};

/**
 * A loader by Emscripten without its branch for Node.js. The names that the branch declares stay declared.
 * @param {string} loader
 */
function withoutNode(loader) {
  const branch =
    /if\(\w+\)\{(var \w+=require\("fs"\)[^]*?"\[Emscripten Module object\]"\})\}else if\(/;
  const [whole, content] = branch.exec(loader) ?? [];
  if (!whole || !content) throw new Complaint('draco3dgltf has another branch for Node.js now');
  const names = [...content.matchAll(/(?:\bvar |,)(\w+)=(?:require|function)\b/g)].map(
    ([, name]) => name,
  );
  const rest = loader.replace(whole, () => `var ${names.join()};if(`);
  if (/\brequire\(/.test(rest)) throw new Complaint('draco3dgltf asks for modules of Node.js');
  return rest;
}

export function copyDecoders() {
  const to = (/** @type {string} */ name) => join(repository, folder, name);
  const draco = (/** @type {string} */ name) => join(repository, packages.draco, name);
  mkdirSync(join(repository, folder), { recursive: true });
  // Draco's loader is no ES module, and asks for modules of Node.js, which bundlers for browsers complain
  // about: it gets another export, and loses what is for Node.js. Nothing else of it is changed.
  const licence =
    '// Draco, by the Draco authors (https://github.com/google/draco). Licensed under the Apache\n' +
    '// License, Version 2.0 (https://www.apache.org/licenses/LICENSE-2.0).\n';
  const loader = readFileSync(draco('draco_decoder_gltf_nodejs.js'), 'utf8');
  const end = loader.lastIndexOf('"object"===typeof exports&&"object"===typeof module?');
  if (end < 0) throw new Complaint('draco3dgltf exports its decoder in another way now');
  writeFileSync(
    to('draco-decoder.mjs'),
    `${licence}${withoutNode(loader.slice(0, end))}\nexport default DracoDecoderModule;\n`,
  );
  copyFileSync(draco('draco_decoder_gltf.wasm'), to('draco-decoder.wasm'));
  copyFileSync(
    join(repository, packages.meshopt, 'meshopt_decoder.mjs'),
    to('meshopt-decoder.mjs'),
  );
}
