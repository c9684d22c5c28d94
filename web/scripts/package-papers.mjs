// Papers beside the package's code: hashes for pages that name them, a list of materials (CycloneDX) and the
// licences of all that is in it, and what editors want to know of the element.

import { createHash } from 'node:crypto';
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { bundledLists } from './bundled-packages.mjs';
import { elementManifest, webTypes } from './element-manifest.mjs';
import { repository } from './run.mjs';

/**
 * @typedef {object} Material
 * @property {string} name
 * @property {string} [version]
 * @property {string} licence an SPDX identifier
 * @property {string} purl
 * @property {string} [text] the licence
 */

/** Libraries that are compiled into the WebAssembly modules, by their Debian packages. */
const compiled = [
  { name: 'Eigen', debian: 'libeigen3-dev', licence: 'MPL-2.0' },
  { name: 'Spectra', debian: 'libspectra-dev', licence: 'MPL-2.0' },
  { name: 'JSON for Modern C++', debian: 'nlohmann-json3-dev', licence: 'MIT' },
  { name: 'tinygltf', debian: 'libtinygltf-dev', licence: 'MIT' },
  { name: 'Emscripten', debian: 'emscripten', licence: 'MIT' },
];

/** Whose programs are copied as they are (`decoders.mjs`), and whose colours (`colormap-tables.mjs`). */
const copied = ['d3-scale-chromatic', 'draco3dgltf', 'meshoptimizer'];

/**
 * @param {string} path
 * @returns {Record<string, any>}
 */
const jsonOf = (path) => JSON.parse(readFileSync(path, 'utf8'));

/**
 * @param {string} name
 * @returns {Material}
 */
function npmMaterial(name) {
  const folder = join(repository, 'node_modules', name);
  const { version, license } = jsonOf(join(folder, 'package.json'));
  const file = readdirSync(folder).find((one) => /^licen[cs]e/i.test(one));
  const text = file && readFileSync(join(folder, file), 'utf8');
  return {
    name,
    version,
    licence: license,
    purl: `pkg:npm/${name}@${version}`,
    ...(text && { text }),
  };
}

/**
 * @param {{ name: string, debian: string, licence: string }} library
 * @returns {Material}
 */
function debianMaterial({ name, debian, licence }) {
  const file = `/usr/share/doc/${debian}/copyright`;
  const text = existsSync(file) ? readFileSync(file, 'utf8') : undefined;
  return { name, licence, purl: `pkg:deb/debian/${debian}`, ...(text && { text }) };
}

/** @returns {Material[]} what is in the package besides Girth itself */
function materials() {
  /** @type {string[]} */
  const bundled = readdirSync(bundledLists).flatMap((list) =>
    JSON.parse(readFileSync(join(bundledLists, list), 'utf8')),
  );
  const names = [...new Set([...bundled, ...copied])].sort();
  return [...names.map(npmMaterial), ...compiled.map(debianMaterial)];
}

/**
 * The materials by CycloneDX 1.6.
 * @param {Material[]} all
 */
function billOfMaterials(all) {
  const { name, version } = jsonOf(join(repository, 'package.json'));
  return {
    bomFormat: 'CycloneDX',
    specVersion: '1.6',
    version: 1,
    metadata: {
      component: { type: 'library', name, version, purl: `pkg:npm/${name}@${version}` },
    },
    components: all.map(({ name, version, licence, purl }) => ({
      type: 'library',
      'bom-ref': purl,
      name,
      ...(version && { version }),
      licenses: [{ license: { id: licence } }],
      purl,
    })),
  };
}

/** @param {Material[]} all */
function licences(all) {
  const own = readFileSync(join(repository, 'LICENSE'), 'utf8');
  const parts = all.map(({ name, version = '', licence, text }) => {
    const title = `${name} ${version}`.trim();
    return `${title} (${licence})\n${'='.repeat(title.length)}\n\n${text ?? 'see https://spdx.org/licenses/' + licence}`;
  });
  return [`Girth\n=====\n\n${own}`, ...parts].map((part) => part.trim()).join('\n\n\n') + '\n';
}

/**
 * The hash of each file that a page may name, as its `integrity` has it.
 * @param {string} dist
 */
function integrity(dist) {
  const files = readdirSync(dist, { recursive: true, encoding: 'utf8' })
    .filter((name) => /\.(js|css|wasm)$/.test(name))
    .map((name) => name.replaceAll('\\', '/'))
    .sort();
  return Object.fromEntries(
    files.map((name) => {
      const hash = createHash('sha384').update(readFileSync(join(dist, name)));
      return [name, `sha384-${hash.digest('base64')}`];
    }),
  );
}

/**
 * Writes all of it into the package's folder, which has everything else.
 * @param {string} dist
 */
export function writePackagePapers(dist) {
  const all = materials();
  const manifest = elementManifest();
  /** @param {string} name @param {unknown} content */
  const write = (name, content) =>
    writeFileSync(join(dist, name), `${JSON.stringify(content, null, 2)}\n`);
  write('integrity.json', integrity(dist));
  write('sbom.cdx.json', billOfMaterials(all));
  write('custom-elements.json', manifest);
  write('web-types.json', webTypes(manifest));
  writeFileSync(join(dist, 'LICENSES.txt'), licences(all));
}
