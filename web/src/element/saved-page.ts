// The program of a saved page: it shows a surface and values that were computed elsewhere, by the
// element alone. It runs no kernel and no worker, and fetches nothing. `pygirth.show` of the Python
// package makes such pages (cpp/python/pygirth/_show.py).

import type { Field, Kernel, Loop } from '../kernel/types/types.js';
import { formatLength } from '../view/index.js';
import './index.js';
import { type Packed, unpacked } from './model/packed.js';
import { useKernel } from './model/shared-kernel.js';
import { type ShownContent, shownMesh } from './model/shown-mesh.js';

/** The content of the page, as JSON. */
interface PageContent extends Pick<ShownContent, 'name' | 'unit' | 'origin' | 'size' | 'area'> {
  positions: Packed;
  indices: Packed;
  boundary: Packed;
  areas: Packed;
  /** The row of the caller's arrays that each vertex is, -1 for none; null where it is the vertex itself. */
  rows: Packed | null;
  field: (Pick<Field, 'name' | 'unit' | 'method'> & { values: Packed; kinds: Packed }) | null;
  loops: (Omit<Loop, 'points' | 'polyline'> & { polyline: Packed })[];
  /** Vertices that are marked by points. */
  points: number[];
}

async function contentOf(page: PageContent): Promise<ShownContent> {
  const { field } = page;
  return {
    ...page,
    positions: new Float32Array(await unpacked(page.positions)),
    indices: new Uint32Array(await unpacked(page.indices)),
    boundary: new Uint32Array(await unpacked(page.boundary)),
    areas: new Float64Array(await unpacked(page.areas)),
    field: field
      ? {
          ...field,
          values: new Float64Array(await unpacked(field.values)),
          kinds: new Uint8Array(await unpacked(field.kinds)),
        }
      : undefined,
    loops: await Promise.all(
      page.loops.map(async (loop) => ({
        ...loop,
        points: [],
        polyline: new Float32Array(await unpacked(loop.polyline)),
      })),
    ),
  };
}

const viewer = document.querySelector('girth-viewer')!;
const caption = document.querySelector('#girth-caption')!;

async function show(): Promise<void> {
  const text = document.querySelector('#girth-content')!.textContent;
  const page = JSON.parse(text) as PageContent;
  const content = await contentOf(page);
  const rows = page.rows === null ? undefined : new Int32Array(await unpacked(page.rows));

  /** 'Vertex 120: 0.3141 m'. */
  const wordsOn = (vertex: number): string => {
    const row = rows ? rows[vertex]! : vertex;
    const which = row < 0 ? 'A vertex that the preparation added' : `Vertex ${row}`;
    if (!content.field) return which;
    const value = content.field.values[vertex]!;
    if (Number.isNaN(value)) return `${which}: no value`;
    return `${which}: ${formatLength(value, viewer.formatOf(content.field.name))}`;
  };

  const kernel: Pick<Kernel, 'load'> = { load: () => Promise.resolve(shownMesh(content)) };
  useKernel(kernel as Kernel);
  viewer.addEventListener('hover', ({ detail: { vertex } }) => {
    caption.textContent = vertex === undefined ? '' : wordsOn(vertex);
  });
  await viewer.load({ positions: content.positions, indices: content.indices });
  viewer.showPoints(page.points);
}

show().catch((error: unknown) => {
  caption.textContent = error instanceof Error ? error.message : String(error);
});
