// How fast the page feels, in one table beside its goals: what is fetched before the first picture, when something is
// seen, how soon a pointer's loop is in a frame, what a brush over the histogram costs, and what keeps the page busy.
// Drawing is left out where that is said: see `long-tasks.ts`.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { square } from '../browser/drawn-page.js';
import {
  bytesOf,
  fetchedBeforePicture,
  isProgram,
  mostBeforePicture,
  mostProgramsBeforePicture,
} from '../browser/first-picture.js';
import { glbWith } from '../browser/glb.js';
import { withoutDrawing } from '../browser/long-tasks.js';
import {
  chromiumForTests,
  command,
  repository,
  requireBuilt,
  serve,
  type StaticServer,
} from '../browser/support.js';
import { figure, printFigures, quantile, type Figure } from './figures.js';
import { loopTimes } from './hover.js';
import { tasksOfOpening } from './opening.js';
import { longestTasks } from './tasks.js';

const site = join(repository, 'build/page');
/** Milliseconds of a frame. */
const frame = 1000 / 60;
/** A task in milliseconds. */
const goals = { paintedSeconds: 1, colouredSeconds: 2, task: 50 };
/** Milliseconds until the loop under the pointer is in a frame, by the surface's faces. */
const loopGoals = { 10_000: 16, 50_000: 60 } as const;
const runs = 3;
/** Vertices along a side of the surface that is brushed: 100,000 in all. */
const cells = 316;
const moves = 40;

const chromium = chromiumForTests();
const figures: Figure[] = [];
const models = mkdtempSync(join(tmpdir(), 'girth-fast-'));
let server: StaticServer;

beforeAll(async () => {
  requireBuilt('build/page/index.html', 'build:page');
  requireBuilt('dist/girth-viewer.js', 'build:package');
  const chair = join(repository, 'web/app/public/examples/chair.glb');
  for (const faces of Object.keys(loopGoals)) {
    execFileSync(command, ['remesh', chair, '--faces', faces, '-o', join(models, `${faces}.glb`)]);
  }
  const page = (faces: string) => `<!doctype html><meta charset="utf-8"><title>loops</title>
    <link rel="icon" href="data:,"><script type="module" src="/dist/girth-viewer.js"></script>
    <girth-viewer src="/models/${faces}.glb" field="none"
      style="width: 900px; height: 700px"></girth-viewer>`;
  server = await serve(site, {
    isolated: true,
    folders: { '/dist/': join(repository, 'dist'), '/models/': models },
    pages: Object.fromEntries(
      Object.keys(loopGoals).map((faces) => [`/loops-${faces}.html`, page(faces)]),
    ),
  });
});
afterAll(async () => {
  await server?.close();
  rmSync(models, { recursive: true });
  printFigures(figures);
});

test('bytes before the first picture', async () => {
  const files = await fetchedBeforePicture(chromium, site);
  const programs = files.filter(isProgram);
  for (const [what, some, most] of [
    ['scripts and styles before the first surface, by gzip', programs, mostProgramsBeforePicture],
    ['the same with WebAssembly and the model', files, mostBeforePicture],
  ] as const) {
    figures.push(figure(what, 'MB', bytesOf(some) / 1e6, most / 1e6));
  }
});

test('first paint, first colours', async () => {
  const [painted, coloured]: number[][] = [[], []];
  for (let run = 0; run < runs; ++run) {
    const { context, page } = await chromium(server.url, {}, (page) =>
      page.addInitScript(() => {
        document.addEventListener(
          'progress',
          ({ target }) => {
            const isFirst = !('coloured' in globalThis) && (target as Element).id === 'viewer';
            if (!isFirst) return;
            Object.assign(globalThis, { coloured: NaN });
            // After the frame that has them.
            requestAnimationFrame(() =>
              setTimeout(() => Object.assign(globalThis, { coloured: performance.now() })),
            );
          },
          true,
        );
      }),
    );
    await page.waitForFunction(
      () => (globalThis as unknown as { coloured?: number }).coloured! > 0,
    );
    const times = await page.evaluate(() => ({
      painted: performance.getEntriesByName('first-contentful-paint')[0]!.startTime,
      coloured: (globalThis as unknown as { coloured: number }).coloured,
    }));
    painted!.push(times.painted / 1000);
    coloured!.push(times.coloured / 1000);
    await context.close();
  }
  figures.push(
    figure('first paint, with drawing', 's', quantile(painted!, 0.5), goals.paintedSeconds),
  );
  figures.push(
    figure(
      'first colours on the chair, with drawing',
      's',
      quantile(coloured!, 0.5),
      goals.colouredSeconds,
    ),
  );
});

test.each(Object.entries(loopGoals))(
  'the loop under the pointer: %s faces',
  async (faces, goal) => {
    const { context, page } = await chromium('about:blank');
    await withoutDrawing(page);
    await page.goto(`${server.url}/loops-${faces}.html`);
    const viewer = page.locator('girth-viewer');
    await page.waitForFunction(() => !!document.querySelector<GirthViewer>('girth-viewer')?.info);
    const shown = await loopTimes(viewer, moves);
    await context.close();
    for (const share of [0.5, 0.95]) {
      const what = `pointer to the frame with its loop, ${faces} faces, ${100 * share}% of ${shown.length}`;
      figures.push(figure(what, 'ms', quantile(shown, share), goal));
    }
  },
);

/** A sheet of 100,000 vertices with a value at each, as its file has them. */
function sheet(): Uint8Array {
  const { positions, indices } = square(cells);
  const lines: string[] = [];
  for (let i = 0; i < positions.length; i += 3) {
    lines.push(`v ${positions[i]} ${positions[i + 1]} ${positions[i + 2]}`);
  }
  for (let i = 0; i < indices.length; i += 3) {
    lines.push(`f ${indices[i]! + 1} ${indices[i + 1]! + 1} ${indices[i + 2]! + 1}`);
  }
  return glbWith(lines.join('\n'), { _HEAT: (vertex) => Math.sqrt(vertex) });
}

/** Shows the sheet on the page by its values, and computes nothing. */
async function showSheet(page: Page): Promise<void> {
  writeFileSync(join(models, 'sheet.glb'), sheet());
  await page.goto(server.url);
  await page.locator('html[data-field=complete]').waitFor({ state: 'attached', timeout: 120_000 });
  await page.evaluate(async () => {
    const viewer = document.querySelector<GirthViewer>('#viewer')!;
    const loaded = new Promise((done) => viewer.addEventListener('load', done, { once: true }));
    const files = new DataTransfer();
    const content = await (await fetch('/models/sheet.glb')).blob();
    files.items.add(new File([content], 'sheet.glb'));
    const chooser = document.querySelector<HTMLInputElement>('#file')!;
    chooser.files = files.files;
    chooser.dispatchEvent(new Event('change'));
    await loaded;
    viewer.cancel();
  });
  await page.locator('#field-name').selectOption('_heat');
  await page.waitForFunction(
    () => document.querySelector<GirthViewer>('#viewer')!.shown?.name === '_heat',
  );
}

test('brushing the histogram of 100K vertices', async () => {
  const { context, page } = await chromium('about:blank');
  await withoutDrawing(page);
  await showSheet(page);
  const box = (await page.locator('#distribution').boundingBox())!;
  await page.mouse.move(box.x + 0.2 * box.width, box.y + box.height / 2);
  await page.mouse.down();
  const [work, elapsed] = await page.evaluate(
    async ({ left, width, y, moves }) => {
      const over = document.elementFromPoint(left + 0.2 * width, y)!;
      const frame = () =>
        new Promise<number>((done) => requestAnimationFrame(() => done(performance.now())));
      const [work, elapsed]: [number[], number[]] = [[], []];
      for (let i = 0; i < moves; ++i) {
        await frame();
        const clientX = left + (0.3 + (0.6 * i) / moves) * width;
        const event = new PointerEvent('pointermove', { clientX, clientY: y, bubbles: true });
        // A frame that is asked for first is called first.
        const first = frame();
        const begun = performance.now();
        over.dispatchEvent(event);
        const handled = performance.now() - begun;
        const last = await frame();
        work.push(handled + last - (await first));
        elapsed.push(last - begun);
      }
      return [work, elapsed] as const;
    },
    { left: box.x, width: box.width, y: box.y + box.height / 2, moves },
  );
  await page.mouse.up();
  const marked = await page.locator('.caption').textContent();
  if (!/% of the area/.test(marked ?? '')) throw new Error(`nothing was brushed: ${marked}`);
  await context.close();
  for (const share of [0.5, 0.95]) {
    const what = `a brush moved over 100K vertices, ${100 * share}%`;
    figures.push(figure(`${what}: the page's work`, 'ms', quantile(work, share), frame));
    figures.push(
      figure(`${what}: to the end of the next frame`, 'ms', quantile(elapsed, share), 2 * frame),
    );
  }
});

test('tasks on load and while computing', async () => {
  for (const [phase, tasks] of await tasksOfOpening(chromium, server.url)) {
    figures.push(...longestTasks(phase, tasks, goals.task));
  }
});
