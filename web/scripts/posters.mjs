// `npm run build:posters [NAME...]`: makes the pictures of the documentation's figures, all or those named, with the element
// itself, into web/docs/images/live. They are committed, as making them needs a browser.

// Half of it runs in the page, half in Node.js: no one set of types has both.
// @ts-nocheck

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { launchChromium } from './chromium.mjs';
import { preview } from 'vite';
import { figures, posterSize } from '../docs/site/figures.mjs';
import { buildDocs } from './build.mjs';
import { repository, script } from './run.mjs';
import { setUp } from './setup.mjs';

const { width, height } = posterSize;

/** A picture of the element with its legend, drawn larger and made smaller, so that it has no steps; in base 64. */
async function pictureOf(viewer, { width, height }) {
  const large = await createImageBitmap(
    await viewer.snapshot({ legend: true, transparent: false, width: 2 * width }),
  );
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d');
  context.imageSmoothingQuality = 'high';
  context.drawImage(large, 0, 0, width, height);
  const blob = await canvas.convertToBlob({ type: 'image/webp', quality: 0.86 });
  return btoa(String.fromCharCode(...new Uint8Array(await blob.arrayBuffer())));
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
    for (const [name, { model, attributes }] of Object.entries(figures)) {
      if (wanted.length > 0 && !wanted.includes(name)) continue;
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
      // What is shown comes a little later than what is computed.
      await page.waitForTimeout(1500);
      const base64 = await viewer.evaluate(pictureOf, { width, height });
      const bytes = Buffer.from(base64, 'base64');
      writeFileSync(join(folder, `${name}.webp`), bytes);
      console.log(`${name}: ${bytes.length} bytes`);
    }
  } finally {
    await browser.close();
    await server.close();
  }
});
