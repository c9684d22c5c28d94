// How long it takes to colour a surface of 100,000 vertices otherwise: the page's own work, and with a frame
// that is drawn. The drawing is done by the processor where there is no other.

import { join } from 'node:path';
import { afterAll, beforeAll, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { draw, drawnPages, overSquare, square } from '../browser/drawn-page.js';
import {
  chromiumForTests,
  repository,
  requireBuilt,
  serve,
  type StaticServer,
} from '../browser/support.js';
import { figure, printFigures, quantile, type Figure } from './figures.js';

const cells = 316;
/** Milliseconds of a frame. */
const goal = 1000 / 60;

const openPage = chromiumForTests();
const figures: Figure[] = [];
let server: StaticServer;

beforeAll(async () => {
  requireBuilt('dist/girth-viewer.js', 'build:package');
  server = await serve(join(repository, 'dist'), { pages: drawnPages });
});
afterAll(async () => {
  await server?.close();
  printFigures(figures);
});

test('recolouring 100K vertices', async () => {
  const { page, context } = await openPage(`${server.url}/drawn.html`);
  const viewer = await draw(page, {
    ...square(cells),
    fields: { igf: overSquare((x) => 1 + x, cells), sdf: overSquare((_, y) => 1 + y, cells) },
  });
  const times = await viewer.evaluate(async (element: GirthViewer) => {
    const changed = new Promise<void>((done) =>
      element.addEventListener('fieldchange', () => element.thresholds && done()),
    );
    element.setAttribute('field', 'parts');
    await changed;
    const frame = () =>
      new Promise<void>((done) => requestAnimationFrame(() => setTimeout(() => done())));
    const vertexCount = element.info!.vertexCount;
    const half = Uint32Array.from({ length: vertexCount / 2 }, (_, i) => 2 * i);
    const acts: [string, (step: number) => void][] = [
      ['thresholds', (step) => element.setThresholds({ girth: 2 * step, shapeDiameter: 1 + step })],
      ['marking half of them', (step) => element.mark(half.subarray(Math.round(1000 * step)))],
      ['no marks', () => element.mark()],
    ];
    const measured: [string, number[], number[]][] = [];
    for (const [what, act] of acts) {
      const [own, drawn]: number[][] = [[], []];
      for (let i = 0; i < 20; ++i) {
        await frame();
        const begun = performance.now();
        act(i / 20);
        own!.push(performance.now() - begun);
        await frame();
        drawn!.push(performance.now() - begun);
      }
      measured.push([what, own!, drawn!]);
    }
    return measured;
  });
  await context.close();
  for (const [what, own, drawn] of times) {
    figures.push(figure(`${what}, the page's work, median`, 'ms', quantile(own, 0.5), goal));
    figures.push(figure(`${what}, the page's work, 95%`, 'ms', quantile(own, 0.95), goal));
    figures.push(figure(`${what}, to the end of the frame`, 'ms', quantile(drawn, 0.5), goal));
  }
});
