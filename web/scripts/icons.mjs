// `npm run build:icons`: makes the pictures of the installed page from its icon, into web/app/public/icons. They are
// committed, as making them needs a browser.

// Half of it runs in the page, half in Node.js: no one set of types has both.
// @ts-nocheck

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { launchChromium } from './chromium.mjs';
import { repository, script } from './run.mjs';

const app = join(repository, 'web/app');
const paper = '#fbfbfa';
/** Name, pixels, the share of them that the icon takes, what is behind it. A maskable icon shows 80% at least. */
const pictures = [
  ['icon-192', 192, 1, 'transparent'],
  ['icon-512', 512, 1, 'transparent'],
  ['maskable-512', 512, 0.7, paper],
  ['touch-180', 180, 0.8, paper],
];

await script(async () => {
  const icon = readFileSync(join(app, 'icon.svg')).toString('base64');
  const browser = await launchChromium();
  for (const [name, size, share, behind] of pictures) {
    const page = await browser.newPage({ viewport: { width: size, height: size } });
    await page.setContent(
      `<body style="margin:0;display:grid;place-items:center;height:100vh;background:${behind}">` +
        `<img width="${share * size}" src="data:image/svg+xml;base64,${icon}">`,
    );
    await page.locator('img').evaluate((image) => image.decode());
    await page.screenshot({
      path: join(app, `public/icons/${name}.png`),
      omitBackground: behind === 'transparent',
    });
    await page.close();
  }
  await browser.close();
});
