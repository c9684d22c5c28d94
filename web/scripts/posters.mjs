// `npm run build:posters [NAME...]`: the element makes the pictures of the documentation's figures, all or those named, in
// web/docs/images/live, and README's moving picture (`moving`). They are committed, as making them needs a browser.

// Half of it runs in the page, half in Node.js: no one set of types has both.
// @ts-nocheck

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { launchChromium } from './chromium.mjs';
import { preview } from 'vite';
import { figures, posterSize } from '../docs/site/figures.mjs';
import { animatedWebp } from './animated-webp.mjs';
import { buildDocs } from './build.mjs';
import { repository, script } from './run.mjs';
import { setUp } from './setup.mjs';

const { width, height } = posterSize;

/** A picture of the element with its legend, drawn larger and made smaller, so that it has no steps; in base 64. */
async function pictureOf(viewer, { width, height, quality = 0.86 }) {
  const large = await createImageBitmap(
    await viewer.snapshot({ legend: true, transparent: false, width: 2 * width }),
  );
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d', { alpha: false });
  context.imageSmoothingQuality = 'high';
  context.drawImage(large, 0, 0, width, height);
  const blob = await canvas.convertToBlob({ type: 'image/webp', quality });
  return btoa(String.fromCharCode(...new Uint8Array(await blob.arrayBuffer())));
}

/** README's moving picture: a loop slides along an octopus, from the end of one arm to the end of another. */
const moving = {
  name: 'moving',
  model: 'octopus',
  attributes: { field: 'igf', loop: 'none' },
  size: { width: 480, height: 360 },
  frames: 36,
  milliseconds: 120,
};

/** Opens the element with a model in the page; its field is computed. */
async function open(page, address, { model, attributes }) {
  await page.goto(`${address}errors.html`);
  await page.setContent(
    `<style>girth-viewer { position: fixed; inset: 0; --girth-paper: #fbfbfa }</style><girth-viewer></girth-viewer>`,
  );
  const viewer = page.locator('girth-viewer');
  await viewer.evaluate(
    async (viewer, { source, script, attributes }) => {
      for (const [key, value] of Object.entries(attributes)) viewer.setAttribute(key, value);
      await import(script);
      await customElements.whenDefined('girth-viewer');
      await viewer.load(source);
      const { field } = attributes;
      await viewer.fieldOf('igf');
      if (field === 'tips') await viewer.tips();
      else if (field === 'parts') await viewer.parts(await viewer.suggestedThresholds());
      else await viewer.fieldOf(field);
    },
    {
      source: `${address}models/${model}.glb`,
      script: `${address}girth/dist/girth-viewer.js`,
      attributes,
    },
  );
  // Drawing follows a little later than computing.
  await page.waitForTimeout(1500);
  return viewer;
}

async function makeMoving(page, address) {
  const { size, frames, milliseconds } = moving;
  const viewer = await open(page, address, moving);
  const way = await viewer.evaluate((viewer) => viewer.longWay());
  const pictures = [];
  for (let frame = 0; frame < frames; ++frame) {
    // The very ends have loops far longer than those beside them.
    const share = 0.03 + (0.94 * frame) / (frames - 1);
    const vertex = way[Math.round(share * (way.length - 1))];
    await viewer.evaluate(async (viewer, vertex) => {
      for (const { id } of viewer.pinned) viewer.unpin(id);
      const { id } = await viewer.pin(vertex);
      viewer.nameLoop(id, 'girth');
    }, vertex);
    await page.waitForTimeout(100);
    pictures.push(
      Buffer.from(await viewer.evaluate(pictureOf, { ...size, quality: 0.7 }), 'base64'),
    );
  }
  return animatedWebp(pictures, { ...size, milliseconds });
}

await script(async () => {
  setUp();
  await buildDocs();
  const wanted = process.argv.slice(2);
  const server = await preview({ configFile: join(repository, 'web/vite.app.config.ts') });
  const address = `${server.resolvedUrls?.local[0] ?? ''}docs/`;
  const browser = await launchChromium();
  const folder = join(repository, 'web/docs/images/live');
  mkdirSync(folder, { recursive: true });
  try {
    const page = await browser.newPage({
      reducedMotion: 'reduce',
      colorScheme: 'light',
      viewport: { width, height },
    });
    for (const [name, figure] of Object.entries(figures)) {
      if (wanted.length > 0 && !wanted.includes(name)) continue;
      const viewer = await open(page, address, figure);
      const base64 = await viewer.evaluate(pictureOf, { width, height });
      const bytes = Buffer.from(base64, 'base64');
      writeFileSync(join(folder, `${name}.webp`), bytes);
      console.log(`${name}: ${bytes.length} bytes`);
    }
    if (wanted.length === 0 || wanted.includes(moving.name)) {
      const bytes = await makeMoving(page, address);
      writeFileSync(join(repository, 'web/docs/images', `${moving.name}.webp`), bytes);
      console.log(`${moving.name}: ${bytes.length} bytes`);
    }
  } finally {
    await browser.close();
    await server.close();
  }
});
