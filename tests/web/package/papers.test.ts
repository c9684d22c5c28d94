// Papers beside the package's code: hashes, materials, licences, and what editors know of the element.

import { createHash } from 'node:crypto';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { attributeNames } from '../../../web/src/element/attributes/attributes.js';
import { packed } from './packed.js';

const { folder } = packed();
const dist = join(folder, 'dist');
const json = <Content>(name: string): Content =>
  JSON.parse(readFileSync(join(folder, name), 'utf8')) as Content;

test('every script, style and module has its hash', () => {
  const hashes = json<Record<string, string>>('dist/integrity.json');
  const files = readdirSync(dist, { recursive: true, encoding: 'utf8' }).filter((name) =>
    /\.(js|css|wasm)$/.test(name),
  );
  expect(Object.keys(hashes)).toEqual(files.sort());
  expect(Object.keys(hashes)).toContain('girth-viewer.js');
  for (const [name, said] of Object.entries(hashes)) {
    const hash = createHash('sha384').update(readFileSync(join(dist, name)));
    expect(said, name).toBe(`sha384-${hash.digest('base64')}`);
  }
});

interface Bill {
  bomFormat: string;
  metadata: { component: { version: string } };
  components: {
    name: string;
    purl: string;
    version?: string;
    licenses: { license: { id: string } }[];
  }[];
}

test('the list of materials has what is bundled, and the licences have their texts', () => {
  const bill = json<Bill>('dist/sbom.cdx.json');
  expect(bill.bomFormat).toBe('CycloneDX');
  expect(bill.metadata.component.version).toBe(json<{ version: string }>('package.json').version);
  const names = bill.components.map(({ name }) => name);
  const known = ['three', 'three-mesh-bvh', 'uplot', 'fflate', 'd3-scale-chromatic', 'draco3dgltf'];
  expect(names).toEqual(expect.arrayContaining([...known, 'meshoptimizer', 'Eigen', 'tinygltf']));
  const free = ['MIT', 'ISC', 'BSD-3-Clause', 'Apache-2.0', 'MPL-2.0'];
  const licences = readFileSync(join(dist, 'LICENSES.txt'), 'utf8');
  for (const { name, purl, version, licenses } of bill.components) {
    expect(free, name).toContain(licenses[0]!.license.id);
    if (purl.startsWith('pkg:npm/')) expect(purl).toBe(`pkg:npm/${name}@${version}`);
    const title = `${name} ${version ?? ''}`.trim();
    expect(licences).toContain(`${title} (${licenses[0]!.license.id})\n`);
  }
  expect(licences).toContain('Copyright');
  expect(licences).toMatch(/^Girth\n=====\n\nMIT License/);
});

interface Named {
  name: string;
  description?: string;
}
interface Manifest {
  modules: {
    path: string;
    declarations: (Record<'attributes' | 'events' | 'slots' | 'cssParts', Named[]> & {
      tagName: string;
      members: (Named & { kind: string; readonly?: boolean })[];
      cssProperties: Named[];
    })[];
  }[];
}

test('the manifest of the element has all attributes with their meaning, members, events and styles', () => {
  const { customElements, 'web-types': types } = json<Record<string, string>>('package.json');
  const manifest = json<Manifest>(customElements!);
  const [module] = manifest.modules;
  expect(existsSync(join(folder, module!.path))).toBe(true);
  const [element] = module!.declarations;
  expect(element!.tagName).toBe('girth-viewer');
  // An attribute that the comment of the class does not explain would be missing.
  expect(element!.attributes.map(({ name }) => name).sort()).toEqual([...attributeNames].sort());
  for (const { name, description } of [...element!.attributes, ...element!.events]) {
    expect(description, name).toMatch(/\w{3}/);
  }
  const members = new Map(element!.members.map((member) => [member.name, member]));
  expect(members.get('load')?.kind).toBe('method');
  expect(members.get('camera')).toMatchObject({ kind: 'field' });
  expect(members.get('camera')?.readonly).toBeUndefined();
  expect(members.get('info')?.readonly).toBe(true);
  expect([...members.keys()].filter((name) => /^#|core|require|needed/.test(name))).toEqual([]);
  expect(element!.events.map(({ name }) => name)).toEqual(
    expect.arrayContaining(['load', 'field', 'error', 'camera']),
  );
  expect(element!.slots.map(({ name }) => name)).toEqual(['poster', 'caption']);
  expect(element!.cssProperties.map(({ name }) => name)).toEqual(
    expect.arrayContaining(['--girth-paper', '--girth-accent', '--girth-top']),
  );
  interface WebTypes {
    version: string;
    contributions: { html: { elements: { name: string; attributes: Named[] }[] } };
  }
  const [editor] = json<WebTypes>(types!).contributions.html.elements;
  expect(editor!.name).toBe('girth-viewer');
  expect(editor!.attributes).toHaveLength(attributeNames.length);
});
