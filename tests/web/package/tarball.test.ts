// The npm package as a stranger gets it: packed, put into a fresh folder, type-checked by the strictest project,
// imported on a server and looked at by the tools that find faults of packages.

import { checkPackage, createPackageFromTarballData } from '@arethetypeswrong/core';
import { spawn, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { once } from 'node:events';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { publint } from 'publint';
import { formatMessage } from 'publint/utils';
import { build, type Rolldown } from 'vite';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { withAddress } from '../../../web/scripts/address.mjs';
import { install, packed, type Manifest } from './packed.js';

const repository = fileURLToPath(new URL('../../..', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'girth-tarball-'));
const packageFolder = join(folder, 'node_modules/girth');

let manifest: Manifest;

/** A page's own code: the kernel with all its types. */
const kernelCode = `
import { createKernel, GirthError, type Kernel, type Mesh } from 'girth';
import { createKernel as createBundled } from 'girth/girth-kernel.js';

export async function measure(file: File): Promise<number> {
  const kernel: Kernel = await createKernel({ threads: 'auto' });
  try {
    const mesh: Mesh = await kernel.load(file);
    const field = await mesh.field('igf', { onProgress: (fraction: number) => console.log(fraction) });
    const values: Float64Array = field.values;
    const loop = await mesh.loop({ face: 0, weights: [0.2, 0.3, 0.5] });
    const points: Float32Array = loop.polyline;
    mesh.dispose();
    return loop.length + points.length + (values[0] ?? 0);
  } catch (error) {
    if (error instanceof GirthError) console.error(error.code, error.message);
    throw error;
  } finally {
    kernel.dispose();
  }
}

export async function facesOf(address: string): Promise<number> {
  using kernel = await createKernel();
  using mesh = await kernel.load(address);
  return mesh.info.faceCount;
}

export const bundled: () => Promise<Kernel> = createBundled;

// @ts-expect-error There is no such field.
export const wrong = (mesh: Mesh) => mesh.field('no field');
`;

/** A page with the element and with plots. */
const elementCode = `
import 'girth/element';
import 'girth/girth-viewer.js';
import type { Kernel } from 'girth';
import { type GirthViewerEventMap, GirthViewer, useKernel } from 'girth/element';
import { histogram } from 'girth/plots';

export async function show(source: string, kernel: Kernel): Promise<void> {
  useKernel(kernel);
  const viewer: GirthViewer = document.createElement('girth-viewer');
  document.body.append(viewer);
  viewer.addEventListener('load', (event) => {
    const faces: number = event.detail.info.faceCount;
    console.log(faces);
  });
  viewer.addEventListener('progress', ({ detail }) => console.log(detail.fraction.toFixed()));
  viewer.addEventListener('field', ({ detail }) => console.log(detail.range[0].toFixed()));
  viewer.addEventListener('fieldchange', ({ detail }) => console.log(detail.shown?.colormap));
  viewer.addEventListener('hover', ({ detail }) => console.log(detail.values.igf?.toFixed()));
  viewer.addEventListener('pick', ({ detail }) => console.log(detail.loop.length.toFixed()));
  viewer.addEventListener('error', ({ detail }) => console.log(detail.code, detail.attribute));
  viewer.addEventListener('camera', { handleEvent: ({ detail }) => console.log(detail) }, { once: true });
  // Events of every element have the types that they always have.
  viewer.addEventListener('keydown', ({ key }) => console.log(key));
  viewer.addEventListener('of my own', (event: Event) => console.log(event.type));
  const heard = ({ detail }: GirthViewerEventMap['error']) => console.log(detail.hint);
  viewer.addEventListener('error', heard);
  viewer.removeEventListener('error', heard);
  // @ts-expect-error It carries what the model is.
  viewer.addEventListener('load', ({ detail }) => detail.nothing);
  await viewer.load(source);
  document.querySelector('girth-viewer')?.cancel();
}

export const plotted = histogram;
`;

/** As much of React's and Vue's own types as the element adds to. */
const frameworks = {
  react: `
export interface HTMLAttributes<T> { id?: string; onLoad?: (event: { currentTarget: T }) => void }
export type DetailedHTMLProps<E, T> = { ref?: (element: T | null) => void; key?: string } & E;
export namespace JSX { interface Element { type: string } interface IntrinsicElements { p: { id?: string } } }`,
  'react/jsx-runtime': `
export { JSX } from 'react';
export function jsx(type: unknown, props: unknown): import('react').JSX.Element;
export const jsxs: typeof jsx;`,
  vue: `
export interface HTMLAttributes { id?: string; hidden?: boolean }
export interface GlobalComponents {}`,
};

const reactCode = `
import type {} from 'girth/react';

export const figure = (
  <girth-viewer
    id="figure"
    src="chair.glb"
    field="sdf"
    isolines={8}
    controls="legend"
    tips
    pins="12 waist"
    ref={(viewer) => console.log(viewer?.info?.faceCount)}
    onfield={({ detail }) => console.log(detail.range[0].toFixed())}
  />
);
// @ts-expect-error No such field.
export const wrong = <girth-viewer field="nothing" />;
`;

const vueCode = `
import type { GlobalComponents } from 'vue';
import type {} from 'girth/vue';

type Props = InstanceType<GlobalComponents['girth-viewer']>['$props'];
export const props: Props = {
  ...{ id: 'figure', src: 'chair.glb', log: true, 'shown-unit': 'mm' },
  onPick: ({ detail }) => console.log(detail.loop.length),
};
// @ts-expect-error No such way to draw.
export const wrong: Props = { shading: 'gouraud' };
`;

/** Checks the types of a project that uses the package, as strictly as can be. */
async function typeCheck(compiler: string, module: string, moduleResolution: string) {
  const compilerOptions = {
    ...{ target: 'ES2022', lib: ['ES2022', 'DOM', 'DOM.Iterable'], types: [], noEmit: true },
    ...{ strict: true, exactOptionalPropertyTypes: true, noUncheckedIndexedAccess: true },
    ...{ noPropertyAccessFromIndexSignature: true, skipLibCheck: false },
    ...{ verbatimModuleSyntax: true, isolatedModules: true },
    ...{ module, moduleResolution, jsx: 'react-jsx' },
  };
  const files = ['kernel.ts', 'element.ts', 'react.tsx', 'vue.ts'];
  const project = join(folder, `${compiler}.${module}.json`);
  writeFileSync(project, JSON.stringify({ compilerOptions, files }));
  const program = join(repository, 'node_modules/.bin', compiler);
  const child = spawn(program, ['--project', project], { cwd: folder });
  let words = '';
  child.stdout.on('data', (data) => (words += String(data)));
  const [status] = (await once(child, 'close')) as [number];
  return { status, words };
}

beforeAll(() => {
  // Nobody has the types of three.js.
  manifest = install(folder);
  writeFileSync(join(folder, 'kernel.ts'), kernelCode);
  writeFileSync(join(folder, 'element.ts'), elementCode);
  writeFileSync(join(folder, 'react.tsx'), reactCode);
  writeFileSync(join(folder, 'vue.ts'), vueCode);
  for (const [name, types] of Object.entries(frameworks)) {
    const [top = ''] = name.split('/');
    const module = join(folder, 'node_modules', top);
    mkdirSync(module, { recursive: true });
    const { length } = name.split('/');
    writeFileSync(join(module, length === 1 ? 'index.d.ts' : 'jsx-runtime.d.ts'), types);
    const exports = { '.': './index.d.ts', './jsx-runtime': './jsx-runtime.d.ts' };
    writeFileSync(
      join(module, 'package.json'),
      JSON.stringify({ name: top, type: 'module', exports }),
    );
  }
}, 120_000);

afterAll(() => {
  rmSync(folder, { recursive: true });
});

/** All files of the package with that ending. */
const filesOf = (ending: string) =>
  readdirSync(packageFolder, { recursive: true, encoding: 'utf8' }).filter((name) =>
    name.endsWith(ending),
  );

test('everything that the package exports is in it, with licence, readme and change log', () => {
  const files = Object.values(manifest.exports).flatMap((entry) =>
    typeof entry === 'string' ? [entry] : [entry.types, entry.default],
  );
  for (const file of [...files, 'LICENSE', 'README.md', 'CHANGELOG.md']) {
    expect(existsSync(join(packageFolder, file)), file).toBe(true);
  }
  expect(existsSync(join(packageFolder, 'dist/kernel/wasm'))).toBe(true);
});

test('it has each WebAssembly module once', () => {
  const digests = filesOf('.wasm').map((file) =>
    createHash('sha256')
      .update(readFileSync(join(packageFolder, file)))
      .digest('hex'),
  );
  expect(digests.length).toBeGreaterThan(7);
  expect(new Set(digests).size).toBe(digests.length);
});

test('links and pictures of the readme lead to files that are in it, or to the web', () => {
  const readme = readFileSync(join(packageFolder, 'README.md'), 'utf8');
  const links = [...readme.matchAll(/\]\(<?([^)<>\s]+)/g)].map(([, link]) => link!);
  expect(links.length).toBeGreaterThan(10);
  const broken = links.filter(
    (link) => !/^(https:|#)/.test(link) && !existsSync(join(packageFolder, link.split('#')[0]!)),
  );
  expect(broken).toEqual([]);
});

test('package and citation name the same address of the project, or neither names one', () => {
  const citation = readFileSync(join(packageFolder, 'CITATION.cff'), 'utf8');
  expect(manifest).toEqual(withAddress({ ...manifest }, citation));
});

test('its types name no package but those that it depends on', () => {
  const known = Object.keys({ ...manifest.dependencies, ...manifest.peerDependencies });
  const foreign = filesOf('.d.ts').flatMap((file) =>
    [...readFileSync(join(packageFolder, file), 'utf8').matchAll(/(?:from|import\()\s*'([^']+)'/g)]
      .map(([, name]) => name!)
      // Not even three.js, which has no types of its own.
      .filter((name) => !name.startsWith('.') && (name === 'three' || !known.includes(name)))
      .map((name) => `${file}: ${name}`),
  );
  // Examples in comments.
  const examples = ['kernel/index.d.ts: girth', 'react.d.ts: girth/react', 'vue.d.ts: girth/vue'];
  expect(foreign.sort()).toEqual(examples.map((example) => `dist/${example}`));
});

// By the compilers of two generations.
test.concurrent.each([
  ['tsc', 'NodeNext', 'NodeNext'],
  ['tsc', 'ESNext', 'Bundler'],
  ['tsc6', 'NodeNext', 'NodeNext'],
])('a strict project compiles against its types: %s, %s, %s', async (...how) => {
  expect(await typeCheck(...how)).toEqual({ status: 0, words: '' });
});

test('on a server it can be imported, and does nothing; what is for pages refuses a kernel with a code', () => {
  const entries = Object.entries(manifest.exports).flatMap(([name, entry]) =>
    typeof entry === 'string' ? [] : [name.replace('.', 'girth')],
  );
  expect(entries).toHaveLength(7);
  const code = `
    const before = Object.getOwnPropertyNames(globalThis);
    ${entries.map((entry) => `await import('${entry}');`).join('\n')}
    const added = Object.getOwnPropertyNames(globalThis).filter((name) => !before.includes(name));
    const { createKernel, GirthError } = await import('girth/girth-kernel.js');
    const { default: manifest } = await import('girth/package.json', { with: { type: 'json' } });
    const error = await createKernel().catch((error) => error);
    console.log(JSON.stringify({
      added, isOurs: error instanceof GirthError, code: error.code, hint: error.hint, version: manifest.version,
    }));
  `;
  const { stdout, stderr } = spawnSync(
    process.execPath,
    ['--no-warnings', '--input-type=module', '--eval', code],
    { cwd: folder, encoding: 'utf8' },
  );
  expect(stderr).toBe('');
  const { added, ...rest } = JSON.parse(stdout) as { added: string[] };
  // Three.js leaves its version.
  expect(added.filter((name) => !/THREE/.test(name))).toEqual([]);
  expect(rest).toEqual({
    isOurs: true,
    code: 'PROGRAM_NOT_LOADED',
    hint: expect.stringContaining("in Node.js, import 'girth'") as string,
    version: manifest.version,
  });
});

test('a bundler keeps what an import brings about, and drops what is not used', async () => {
  const bundle = async (code: string) => {
    writeFileSync(join(folder, 'entry.js'), code);
    const output = await build({
      configFile: false,
      root: folder,
      logLevel: 'error',
      build: {
        write: false,
        minify: false,
        rolldownOptions: { input: 'entry.js', external: /^three/ },
      },
    });
    const { output: chunks } = (
      Array.isArray(output) ? output[0] : output
    ) as Rolldown.RolldownOutput;
    return chunks.map((chunk) => ('code' in chunk ? chunk.code : '')).join('');
  };
  expect(await bundle(`import 'girth/element';`)).toContain('girth-viewer');
  expect((await bundle(`import { createKernel } from 'girth';`)).trim()).toBe('');
});

test('publint finds nothing', async () => {
  const { messages, pkg } = await publint({ pkgDir: packageFolder, strict: true, pack: false });
  expect(messages.map((message) => formatMessage(message, pkg))).toEqual([]);
});

test('arethetypeswrong finds nothing', async () => {
  const data = new Uint8Array(readFileSync(packed().tarball));
  // Styles have no types.
  const excludeEntrypoints = ['./plots.css'];
  const analysis = await checkPackage(createPackageFromTarballData(data), { excludeEntrypoints });
  // The package is for modules only, as browsers have them: not for require(), nor for Node.js before 12.
  const problems = 'problems' in analysis ? analysis.problems : ['it has no types'];
  const ours = problems.filter(
    (problem) =>
      typeof problem === 'string' ||
      !('resolutionKind' in problem) ||
      /^(node16-esm|bundler)$/.test(problem.resolutionKind),
  );
  expect(ours).toEqual([]);
});
