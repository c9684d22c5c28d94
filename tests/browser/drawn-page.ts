// The element with a kernel that is no kernel: it hands out a drawn surface and drawn values, so that a
// test knows what each pixel must be.

import type { Locator, Page } from 'playwright-core';
import { expect } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import type {
  Field,
  FieldName,
  FieldOptions,
  Kernel,
  Mesh,
  Parts,
  Tips,
} from '../../web/src/kernel/index.js';

/** Files to serve beside the built element; the page is '/drawn.html'. */
export const drawnPages = {
  '/drawn.html': `<!doctype html><meta charset="utf-8"><title>drawn</title>
    <link rel="icon" href="data:,">
    <style>body { margin: 0 } girth-viewer { width: 600px; height: 600px }</style>
    <script type="module" src="/drawn.js"></script><girth-viewer></girth-viewer>`,
  '/drawn.js': `import { useKernel } from '/girth-viewer.js';
    globalThis.useKernel = useKernel;`,
};

/** A surface and what a kernel would say of it. */
export interface Drawing {
  positions: number[];
  indices: number[];
  unit?: string;
  /** null: no value. */
  fields: Partial<Record<FieldName, (number | null)[]>>;
  /** Fields that are never done: only the values of these vertices come. */
  begun?: Partial<Record<FieldName, number[]>>;
  /** Fields that are done once; asked for again they never are. */
  once?: FieldName[];
  kinds?: number[];
  /** A remark on the fields. */
  note?: string;
  tips?: {
    vertices: number[];
    contour: number[];
    apex: number;
    jump: number;
  }[];
  arcs?: { polyline: number[]; jump: number }[];
  /** The part of each vertex in a smoothed division. */
  smoothed?: number[];
}

/** Cells on each side of the square, unless said otherwise. */
const usualCells = 40;

/** A square in the plane z = 0, x and y from -1 to 1, its front towards +z; vertex by row and column. */
export function square(cells = usualCells): Pick<Drawing, 'positions' | 'indices'> {
  const positions: number[] = [];
  const indices: number[] = [];
  for (let row = 0; row <= cells; ++row) {
    for (let column = 0; column <= cells; ++column) {
      positions.push((2 * column) / cells - 1, (2 * row) / cells - 1, 0);
      if (row === cells || column === cells) continue;
      const a = row * (cells + 1) + column;
      const [b, c, d] = [a + 1, a + cells + 2, a + cells + 1];
      indices.push(a, b, c, a, c, d);
    }
  }
  return { positions, indices };
}

/** A number for each vertex of the square. */
export function overSquare<Value>(
  value: (x: number, y: number) => Value,
  cells = usualCells,
): Value[] {
  const { positions } = square(cells);
  return Array.from({ length: positions.length / 3 }, (_, v) =>
    value(positions[3 * v]!, positions[3 * v + 1]!),
  );
}

/** The vertex of the square nearest to a place. */
export function vertexAt(x: number, y: number): number {
  const place = (coordinate: number): number => Math.round(((coordinate + 1) * usualCells) / 2);
  return place(y) * (usualCells + 1) + place(x);
}

/** Shows a drawing in the page's element, seen from straight in front; how often the kernel was asked. */
export async function draw(page: Page, drawing: Drawing): Promise<Locator> {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  const viewer = page.locator('girth-viewer');
  await viewer.evaluate(async (element: GirthViewer, drawing) => {
    const { useKernel } = globalThis as unknown as { useKernel: (kernel: Kernel) => void };
    const vertexCount = drawing.positions.length / 3;
    const asked: Record<string, number> = {};
    Object.assign(globalThis, { asked });
    const count = <Answer>(name: string, answer: Answer): Promise<Answer> => {
      asked[name] = (asked[name] ?? 0) + 1;
      return Promise.resolve(answer);
    };
    const line = (polyline: number[], closed: boolean) => ({
      closed,
      polyline: Float32Array.from(polyline),
    });
    const mesh = {
      info: {
        name: 'drawing',
        unreadable: [],
        vertexCount,
        unit: drawing.unit ?? '',
        area: 4,
        size: [2, 2, 2],
      },
      geometry: {
        positions: Float32Array.from(drawing.positions),
        indices: Uint32Array.from(drawing.indices),
        boundary: new Uint32Array(),
        origin: [0, 0, 0],
      },
      field(name: FieldName, { onPartial }: FieldOptions = {}): Promise<Field> {
        const values = Float64Array.from(drawing.fields[name] ?? [], (value) => value ?? NaN);
        const begun = drawing.begun?.[name];
        if (begun) {
          const vertices = Uint32Array.from(begun);
          const kinds = new Uint8Array(begun.length);
          const known = Float64Array.from(begun, (vertex) => values[vertex]!);
          setTimeout(() => onPartial?.({ vertices, values: known, kinds }));
          return new Promise(() => undefined);
        }
        if (drawing.once?.includes(name) && asked[name]) return new Promise(() => undefined);
        const numbers = values.filter((value) => !Number.isNaN(value));
        return count(name, {
          name,
          values,
          kinds: Uint8Array.from(drawing.kinds ?? values.map(() => 0)),
          range: numbers.length > 0 ? [Math.min(...numbers), Math.max(...numbers)] : [NaN, NaN],
          unit: drawing.unit ?? '',
          method: 'drawn',
          withoutValue: vertexCount - numbers.length,
          note: drawing.note ?? '',
        });
      },
      vertexAreas: () => count('areas', new Float64Array(vertexCount).fill(4 / vertexCount)),
      suggestedThresholds: () => count('thresholds', { girth: 1, shapeDiameter: 1 }),
      parts: () =>
        count('parts', {
          kinds: Uint8Array.from(drawing.smoothed ?? []),
          partOf: new Uint32Array(vertexCount),
          parts: [],
        } satisfies Parts),
      tips: () =>
        count('tips', {
          tips: (drawing.tips ?? []).map(({ vertices, contour, apex, jump }) => ({
            vertices: Uint32Array.from(vertices),
            contour: [line(contour, true)],
            area: 1,
            boundaryLength: 1,
            apex,
            apexDistance: 1,
            jump,
          })),
          arcs: (drawing.arcs ?? []).map(({ polyline, jump }) => ({
            line: line(polyline, false),
            length: 1,
            jump,
          })),
          crossedEdges: 1,
        } satisfies Tips),
      loop: () => new Promise(() => undefined),
      dispose: () => undefined,
    } as unknown as Mesh;
    useKernel({ load: () => Promise.resolve(mesh) } as unknown as Kernel);
    await element.load({ positions: new Float32Array(), indices: new Uint32Array() });
    element.camera = { polar: Math.PI / 2, azimuth: 0, distance: 4.6, target: [0, 0, 0] };
  }, drawing);
  return viewer;
}

/** How often a part of the drawn kernel was asked for. */
export function timesAsked(page: Page, what: string): Promise<number> {
  return page.evaluate(
    (what) => (globalThis as unknown as { asked: Record<string, number> }).asked[what] ?? 0,
    what,
  );
}

export interface Pixel {
  r: number;
  g: number;
  b: number;
  alpha: number;
}

/** The pixels of what the element shows now, at places of the drawn plane. */
export function pixelsAt(
  viewer: Locator,
  places: readonly (readonly [number, number])[],
): Promise<Pixel[]> {
  return viewer.evaluate(async (element: GirthViewer, places) => {
    const bitmap = await createImageBitmap(await element.snapshot());
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const pen = canvas.getContext('2d')!;
    pen.drawImage(bitmap, 0, 0);
    const scale = bitmap.width / element.clientWidth;
    // The drawn square's corners are its first and its last vertex.
    const last = element.info!.vertexCount - 1;
    const [low, high] = [element.screenPosition(0), element.screenPosition(last)];
    return places.map(([x, y]) => {
      const right = low.x + ((high.x - low.x) * (x + 1)) / 2;
      const down = low.y + ((high.y - low.y) * (y + 1)) / 2;
      const [r, g, b, alpha] = pen.getImageData(
        Math.round(scale * right - 0.5),
        Math.round(scale * down - 0.5),
        1,
        1,
      ).data;
      return { r: r!, g: g!, b: b!, alpha: alpha! };
    });
  }, places);
}

/** Expects a colour but for its brightness, which the light decides. */
export function expectHue({ r, g, b }: Pixel, css: string): void {
  const wanted = (
    /^#/.test(css)
      ? [1, 3, 5].map((at) => Number.parseInt(css.slice(at, at + 2), 16))
      : (css.match(/\d+/g) ?? []).map(Number)
  ) as [number, number, number];
  const scale = (r + g + b) / (wanted[0] + wanted[1] + wanted[2]);
  for (const [k, channel] of [r, g, b].entries()) {
    expect(Math.abs(channel - scale * wanted[k]!), `${r} ${g} ${b} as ${css}`).toBeLessThan(9);
  }
  expect(scale).toBeGreaterThan(0.65);
  expect(scale).toBeLessThan(1.1);
}
