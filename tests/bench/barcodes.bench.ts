// How long it takes to read the persistent girth of 50,000 vertices off their barcodes, as the slider of the page does
// at each of its steps. How many bars vertices have is as on a horse of 10,000 faces, up to a persistence of 5%: three
// quarters have one, the others up to sixteen.

import { afterAll, test } from 'vitest';
import { BarcodeRun } from '../../web/src/kernel/page/barcodes.js';
import { figure, printFigures, quantile, type Figure } from './figures.js';

const vertexCount = 50_000;
const mostBars = 16;
/** Milliseconds of a frame. */
const goal = 1000 / 60;
const figures: Figure[] = [];

afterAll(() => printFigures(figures));

test('the persistent girth of 50K vertices off barcodes', () => {
  const counts = Uint32Array.from({ length: vertexCount }, (_, v) =>
    v % 4 ? 1 : 1 + ((v / 4) % mostBars),
  );
  const bars: number[] = [];
  for (const count of counts) {
    for (let i = 0; i < count; ++i)
      bars.push(1 + i, i + 1 < count ? 1 + i + (i + 1) / mostBars : Infinity);
  }
  const run = new BarcodeRun(vertexCount, {});
  run.add({
    vertices: Uint32Array.from({ length: vertexCount }, (_, v) => v),
    values: new Float64Array(vertexCount),
    kinds: new Uint8Array(vertexCount),
    counts,
    bars: Float64Array.from(bars),
  });
  const barcodes = run.barcodes(1, '');
  const times: number[] = [];
  for (let step = 1; step <= 100; ++step) {
    const begun = performance.now();
    barcodes.girth(step / 100);
    times.push(performance.now() - begun);
  }
  figures.push(
    figure('a step of the slider, 50K vertices: median', 'ms', quantile(times, 0.5), goal),
    figure('of 95% of the steps at most', 'ms', quantile(times, 0.95), goal),
  );
});
