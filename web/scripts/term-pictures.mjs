// `npm run build:terms`: makes the small pictures that explain the page's terms, with the page itself and its
// examples, into web/app/help/terms. They are committed, as making them needs a browser.

// Half of it runs in the page, half in Node.js: no one set of types has both.
// @ts-nocheck

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { launchChromium } from './chromium.mjs';
import { preview } from 'vite';
import { buildPage } from './build.mjs';
import { repository, script } from './run.mjs';
import { setUp } from './setup.mjs';

/** Pixels on a dense screen. */
const width = 224;
const height = 168;

/**
 * @typedef {object} Subject
 * @property {string} model the example's name
 * @property {string} field what colours it
 * @property {(viewer: HTMLElement) => Promise<object | undefined>} show runs on the page; undefined:
 *   what the element shows then
 */

/** @type {Record<string, Subject>} */
const subjects = {
  girth: {
    model: 'chair',
    field: 'igf',
    show: async (viewer) => ({ vertices: viewer.values('igf').map((_, vertex) => vertex) }),
  },
  loop: {
    model: 'dumbbell',
    field: 'igf',
    show: async (viewer) => {
      const values = viewer.values('igf');
      await viewer.pin(values.indexOf(Math.min(...values)));
      const { camera } = viewer;
      if (camera) viewer.camera = { ...camera, distance: 0.36 * camera.distance };
      return undefined;
    },
  },
  tip: {
    model: 'octopus',
    field: 'igf',
    show: async (viewer) => {
      await viewer.showTips({ shown: true, selected: 0 });
      viewer.flyTo({ vertices: (await viewer.tips()).tips[0]?.vertices ?? [] });
      const { camera } = viewer;
      if (camera) viewer.camera = { ...camera, distance: 0.9 * camera.distance };
      return undefined;
    },
  },
  tube: {
    model: 'chair',
    field: 'parts',
    show: async (viewer) => {
      viewer.setThresholds({ girth: 0.3, diameter: 0.06 });
      const { parts } = await viewer.parts({ girth: 0.3, diameter: 0.06 });
      const tubes = parts.filter(({ kind }) => kind === 'tube');
      return { vertices: tubes.flatMap(({ vertices }) => [...vertices]) };
    },
  },
  plate: {
    model: 'chair',
    field: 'parts',
    show: async (viewer) => {
      viewer.setThresholds({ girth: 0.3, diameter: 0.06 });
      const { parts } = await viewer.parts({ girth: 0.3, diameter: 0.06 });
      const plates = parts.filter(({ kind }) => kind === 'plate');
      return { vertices: plates.flatMap(({ vertices }) => [...vertices]) };
    },
  },
  sdf: {
    model: 'cup',
    field: 'sdf',
    show: async (viewer) => ({ vertices: viewer.values('sdf').map((_, vertex) => vertex) }),
  },
};

/**
 * A picture of a place on the page, drawn larger and made smaller, so that it has no steps; in base 64.
 * @param {Element} element
 * @param {{ place: object | undefined, width: number, height: number }} wish
 */
async function pictureOf(viewer, { place, width, height }) {
  const large = await createImageBitmap(
    place
      ? await viewer.snapshotOf({ ...place, width: 4 * width, height: 4 * height })
      : await viewer.snapshot(),
  );
  const scale = Math.max(width / large.width, height / large.height);
  const [drawnWidth, drawnHeight] = [scale * large.width, scale * large.height];
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d');
  if (!context) throw new Error('there is no canvas');
  context.imageSmoothingQuality = 'high';
  context.drawImage(
    large,
    (width - drawnWidth) / 2,
    (height - drawnHeight) / 2,
    drawnWidth,
    drawnHeight,
  );
  const blob = await canvas.convertToBlob({ type: 'image/webp', quality: 0.86 });
  return btoa(String.fromCharCode(...new Uint8Array(await blob.arrayBuffer())));
}

/**
 * The area between the cumulative curves of two girths, as if both surfaces had the area 1.
 * @param {{ value: number, share: number }[][]} curves by rising value
 */
function betweenCurves(curves) {
  const most = Math.max(...curves.map((curve) => curve.at(-1)?.value ?? 0));
  const place = ({ value, share }) =>
    `${(6 + (100 * value) / most).toFixed(1)},${(78 - 72 * share).toFixed(1)}`;
  const [one = '', other = ''] = curves.map((curve) =>
    ['6,78', ...curve.map(place), '106,6'].join(' '),
  );
  const area = `${one} ${other.split(' ').reverse().join(' ')}`;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 112 84" fill="none">
  <style>
    .axis { stroke: #888; }
    .area { fill: #c2410c; opacity: 0.22; }
    .one { stroke: #c2410c; stroke-width: 2; }
    .other { stroke: #0072b2; stroke-width: 2; stroke-dasharray: 4 2; }
  </style>
  <path class="axis" d="M6 4V78H108" />
  <polygon class="area" fill-rule="evenodd" points="${area}" />
  <polyline class="one" points="${one}" />
  <polyline class="other" points="${other}" />
</svg>
`;
}

await script(async () => {
  setUp();
  await buildPage();
  const server = await preview({ configFile: join(repository, 'web/vite.app.config.ts') });
  const address = server.resolvedUrls?.local[0] ?? '';
  const browser = await launchChromium();
  const folder = join(repository, 'web/app/help/terms');
  try {
    const page = await browser.newPage({ reducedMotion: 'reduce' });
    const open = async (model, field) => {
      await page.goto('about:blank');
      await page.goto(`${address}#model=${model}&field=${field}`);
      await page.locator('#model b', { hasText: `${model}.glb` }).waitFor();
      const viewer = page.locator('girth-viewer');
      // Colours are shown a little later than they are computed.
      await viewer.evaluate((viewer) => viewer.fieldOf('sdf'));
      await viewer.evaluate((viewer) => viewer.fieldOf('igf'));
      await page.waitForTimeout(1000);
      return viewer;
    };
    for (const [name, { model, field, show }] of Object.entries(subjects)) {
      const viewer = await open(model, field);
      const place = await viewer.evaluateHandle(show);
      const base64 = await viewer.evaluate(pictureOf, { place, width, height });
      const bytes = Buffer.from(base64, 'base64');
      writeFileSync(join(folder, `${name}.webp`), bytes);
      console.log(`${name}: ${bytes.length} bytes`);
    }
    const curves = [];
    for (const model of ['octopus', 'cup']) {
      const viewer = await open(model, 'igf');
      const curve = await viewer.evaluate(async (viewer) => {
        const [{ values }, areas] = [await viewer.fieldOf('igf'), await viewer.areas()];
        const whole = areas.reduce((sum, area) => sum + area, 0);
        const order = [...values.keys()].sort((a, b) => (values[a] ?? 0) - (values[b] ?? 0));
        const points = [];
        let below = 0;
        for (const [i, vertex] of order.entries()) {
          below += areas[vertex] ?? 0;
          if (i % Math.ceil(order.length / 40) === 0 || i + 1 === order.length) {
            points.push({ value: (values[vertex] ?? 0) / Math.sqrt(whole), share: below / whole });
          }
        }
        return points;
      });
      curves.push(curve);
    }
    writeFileSync(join(folder, 'emd.svg'), betweenCurves(curves));
  } finally {
    await browser.close();
    await server.close();
  }
});
