// Reading and preparing a surface of a million faces in the page: time, and the most memory that the
// renderer's process held above what it held before, as a multiple of the decoded geometry (positions
// of 8 bytes, triangles of 4). The kernel alone: what drawing needs comes on top.

import { afterAll, beforeAll, test } from 'vitest';
import type { KernelPage } from '../browser/kernel-page.js';
import { kernelSite, setup as buildKernelSite } from '../browser/build-kernel-site.js';
import { kernelHtml } from '../browser/kernel-site.js';
import { chromiumForTests, serve } from '../browser/support.js';
import { watchMemory } from './renderer-memory.js';
import { figure, printFigures, type Figure } from './figures.js';

/** Inside `page.evaluate` only. */
declare const girth: KernelPage;

const rows = 500;
const columns = 1000;
const timeGoal = 6;
const memoryGoal = 20;

const openPage = chromiumForTests();
const figures: Figure[] = [];

beforeAll(buildKernelSite);
afterAll(() => printFigures(figures));

/** A torus of 2 · rows · columns triangles. */
function torus(): { positions: Float32Array; indices: Uint32Array } {
  const positions: number[] = [];
  const indices: number[] = [];
  for (let j = 0; j < rows; ++j) {
    for (let i = 0; i < columns; ++i) {
      const [u, v] = [(2 * Math.PI * i) / columns, (2 * Math.PI * j) / rows];
      const radius = 3 + Math.cos(v);
      positions.push(radius * Math.cos(u), radius * Math.sin(u), Math.sin(v));
      const at = (dj: number, di: number) => ((j + dj) % rows) * columns + ((i + di) % columns);
      indices.push(at(0, 0), at(0, 1), at(1, 1), at(0, 0), at(1, 1), at(1, 0));
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

function glb({ positions, indices }: ReturnType<typeof torus>): Uint8Array {
  const views = [positions, indices].map((array) => new Uint8Array(array.buffer));
  const json = JSON.stringify({
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    buffers: [{ byteLength: views[0]!.length + views[1]!.length }],
    bufferViews: [
      { buffer: 0, byteLength: views[0]!.length },
      { buffer: 0, byteOffset: views[0]!.length, byteLength: views[1]!.length },
    ],
    accessors: [
      {
        ...{ bufferView: 0, componentType: 5126, count: positions.length / 3, type: 'VEC3' },
        ...{ min: [-4, -4, -1], max: [4, 4, 1] },
      },
      { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
  });
  const text = Buffer.from(json.padEnd(4 * Math.ceil(json.length / 4)));
  const binary = Buffer.concat(views);
  const head = (...words: number[]) => Buffer.from(Uint32Array.from(words).buffer);
  return Buffer.concat([
    head(0x46546c67, 2, 28 + text.length + binary.length),
    ...[head(text.length, 0x4e4f534a), text, head(binary.length, 0x004e4942), binary],
  ]);
}

function stl({ positions, indices }: ReturnType<typeof torus>): Uint8Array {
  const bytes = Buffer.alloc(84 + (50 * indices.length) / 3);
  bytes.writeUInt32LE(indices.length / 3, 80);
  indices.forEach((vertex, corner) => {
    const at = 84 + 50 * Math.floor(corner / 3) + 12 + 12 * (corner % 3);
    for (let k = 0; k < 3; ++k) bytes.writeFloatLE(positions[3 * vertex + k]!, at + 4 * k);
  });
  return bytes;
}

function obj({ positions, indices }: ReturnType<typeof torus>): Uint8Array {
  const lines: string[] = [];
  for (let i = 0; i < positions.length; i += 3) {
    lines.push(`v ${positions[i]} ${positions[i + 1]} ${positions[i + 2]}`);
  }
  for (let i = 0; i < indices.length; i += 3) {
    lines.push(`f ${indices[i]! + 1} ${indices[i + 1]! + 1} ${indices[i + 2]! + 1}`);
  }
  return Buffer.from(lines.join('\n'));
}

test.each([
  { name: 'GLB', write: glb, corners: false },
  { name: 'OBJ', write: obj, corners: false },
  // Every corner by itself, as the file has them.
  { name: 'STL', write: stl, corners: true },
])('$name', async ({ name, write, corners }) => {
  const bytes = write(torus());
  const faces = 2 * rows * columns;
  const geometry = 24 * (corners ? 3 * faces : rows * columns) + 12 * faces;
  const server = await serve(kernelSite, { isolated: true, pages: { '/': kernelHtml } });
  const { page, browser, context } = await openPage(server.url);
  await page.waitForFunction('globalThis.girth');
  await page.route('**/model', (route) => route.fulfill({ body: Buffer.from(bytes) }));
  await page.evaluate(async () => {
    const blob = await (await fetch('/model')).blob();
    const kernel = await girth.createKernel({ threads: 2 });
    Object.assign(globalThis, { file: new File([blob], 'model'), kernel });
  });
  const held = await watchMemory(browser);
  const seconds = await page.evaluate(async () => {
    const { file, kernel } = globalThis as unknown as {
      file: File;
      kernel: Awaited<ReturnType<KernelPage['createKernel']>>;
    };
    const from = performance.now();
    await kernel.load(file);
    return (performance.now() - from) / 1000;
  });
  figures.push(figure(`${name}: read and prepared`, 's', seconds, timeGoal));
  const ratio = held() / geometry;
  figures.push(figure(`${name}: memory`, 'times the geometry', ratio, memoryGoal));
  await context.close();
  await server.close();
});
