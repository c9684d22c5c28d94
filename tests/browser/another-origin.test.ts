// The package on another origin than the page, as on a CDN: what works, and what is said where it is not allowed.

import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import type { GirthError } from '../../web/src/kernel/index.js';
import { dracoDocument } from '../web/kernel/draco-document.js';
import { packed } from '../web/package/packed.js';
import {
  chromiumForTests,
  repository,
  serve,
  type ServeOptions,
  type StaticServer,
  trustedTypes,
} from './support.js';
import { fieldComplete, hover, placeOnSurface } from './viewer-page.js';

const openPage = chromiumForTests();
const opened: { close(): Promise<unknown> }[] = [];
/** Allows all that a page may load. */
let shared: StaticServer;

/** A server with the package, which pages of other origins may read as far as `shared` allows. */
async function packageOn(shared: RegExp, options: ServeOptions = {}): Promise<StaticServer> {
  const server = await serve(packed().folder, { ...options, shared });
  opened.push(server);
  return server;
}

beforeAll(async () => {
  shared = await packageOn(/./);
});
afterAll(async () => {
  for (const one of opened) await one.close();
});

/** A page's use of the kernel of an address: the least girth of a model, or why there is none. */
const script = `
globalThis.leastGirth = async (address) => {
  try {
    const { createKernel } = await import(address + '/dist/girth-kernel.js');
    const kernel = await createKernel({ threads: 2 });
    const mesh = await kernel.load('dumbbell.glb');
    const { range } = await mesh.field('igf');
    kernel.dispose();
    return { mode: kernel.mode, least: range[0] };
  } catch ({ name, code, message, hint }) {
    return { name, code, message, hint };
  }
};`;
/** A glTF whose geometry is packed by Draco, though not validly: only the decoder finds that. */
const packedModel = JSON.stringify({
  ...dracoDocument(4, 3, 3),
  extensionsUsed: ['KHR_draco_mesh_compression'],
  extensionsRequired: ['KHR_draco_mesh_compression'],
  buffers: [{ byteLength: 4, uri: 'data:application/octet-stream;base64,AAAAAA==' }],
  nodes: [{ mesh: 0 }],
  scenes: [{ nodes: [0] }],
  scene: 0,
});
declare const leastGirth: (address: string) => Promise<{ hint?: string }>;

/** A page of an origin of its own, with models beside it. */
async function pageWith(body: string, options: ServeOptions = {}) {
  const head = '<!doctype html><link rel="icon" href="data:,"><script src="script.js"></script>';
  const server = await serve(join(repository, 'web/app/public/examples'), {
    ...options,
    pages: { '/': `${head}${body}`, '/script.js': script, '/packed.gltf': packedModel },
  });
  opened.push(server);
  const { page, context, complaints } = await openPage(`${server.url}/`);
  opened.push(context);
  const least = (address: string) => page.evaluate((address) => leastGirth(address), address);
  return { page, complaints, least };
}

test.each([
  ['threads', true],
  ['pool', false],
] as const)('kernel and element work where CORS allows it: %s', async (mode, isolated) => {
  const { page, complaints, least } = await pageWith(
    `<script type="module" src="${shared.url}/dist/girth-viewer.js"></script>
     <style>girth-viewer { height: 300px }</style>
     <girth-viewer src="dumbbell.glb"></girth-viewer>
     <girth-viewer id="large" src="chair.glb" field="none"></girth-viewer>`,
    { isolated, policy: trustedTypes },
  );
  await fieldComplete(page.locator('girth-viewer').first());
  const answer = await least(shared.url);
  expect(answer).toEqual({ mode, least: expect.closeTo(0.131, 2) as number });
  // Another worker makes a large model ready to be pointed at.
  await expect.poll(() => shared.requests.join()).toContain('generateMeshBVH.worker');
  const large = page.locator('#large');
  const { x, y } = await placeOnSurface(large, 0.5, 0.5);
  expect((await hover(page, large, x, y)).length).toBeGreaterThan(0);
  expect(complaints).toEqual([]);

  // Decoders are fetched for files that need them, and for no others.
  const decoders = () => shared.requests.splice(0).filter((path) => /draco|meshopt/.test(path));
  expect(decoders()).toEqual([]);
  const code = await large.evaluate((element: GirthViewer) =>
    element.load('packed.gltf').then(
      () => '',
      (error: GirthError) => error.code,
    ),
  );
  expect(code).toBe('MALFORMED_FILE');
  const endings = decoders().map((path) => /draco-decoder.*\.(js|wasm)$/.exec(path)?.[1] ?? path);
  expect(endings.sort()).toEqual(['js', 'wasm']);
});

test('where a policy forbids workers of that sort, kernel and element say what to allow', async () => {
  const policy = `default-src 'self'; script-src 'self' ${shared.url} 'wasm-unsafe-eval'; style-src 'unsafe-inline'; connect-src 'self' ${shared.url}; img-src data:`;
  const { page, least } = await pageWith(
    `<script type="module" src="${shared.url}/dist/girth-viewer.js"></script>
     <girth-viewer src="dumbbell.glb"></girth-viewer>`,
    { policy },
  );
  const answer = await least(shared.url);
  expect(answer).toMatchObject({
    name: 'GirthError',
    code: 'PROGRAM_NOT_LOADED',
    hint: expect.stringContaining('worker-src blob:') as string,
  });
  expect(answer.hint).toContain(shared.url);
  expect(answer.hint).toContain('copy the folder dist');
  const message = page.locator('girth-viewer .message');
  await expect.poll(() => message.textContent()).toContain('worker-src blob:');
  // It is not the model's fault.
  expect(await message.textContent()).not.toContain('dumbbell.glb');
  const code = await message.getAttribute('data-code');
  expect(code).toBe('PROGRAM_NOT_LOADED');
});

test('where a page trusts no policy of ours, kernel and element say which to allow', async () => {
  const policy = `require-trusted-types-for 'script'; trusted-types other`;
  const { page, least } = await pageWith(
    `<script type="module" src="${shared.url}/dist/girth-viewer.js"></script>
     <girth-viewer src="dumbbell.glb"></girth-viewer>`,
    { policy },
  );
  const allowed = `trusted-types girth 'allow-duplicates'`;
  const answer = await least(shared.url);
  expect(answer).toMatchObject({ name: 'GirthError', code: 'PROGRAM_NOT_LOADED' });
  expect(answer.hint).toContain(allowed);
  const message = page.locator('girth-viewer .message');
  await expect.poll(() => message.textContent()).toContain(allowed);
});

test.each([
  ['the workers', /girth-(kernel|viewer)\.js$/],
  ['the .wasm files', /\.js$/],
])('without CORS headers for %s, the header is named', async (_, allowed) => {
  const { url } = await packageOn(allowed);
  const { least } = await pageWith('');
  const answer = await least(url);
  expect(answer).toMatchObject({ name: 'GirthError', code: 'PROGRAM_NOT_LOADED' });
  expect(answer.hint).toContain(`let ${url} send the header Access-Control-Allow-Origin`);
  expect(answer.hint).toContain('copy the folder dist');
});
