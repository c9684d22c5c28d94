// What the tests of the page share: opening it, dropping files on it, and waiting for models.

import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { repository } from './support.js';

/** The page as `npm run build:page` puts it. */
export const site = join(repository, 'build/page');
export const examples = join(repository, 'web/app/public/examples');
export const pictures = join(repository, 'build/pictures');

/** Drops files onto the window, as from the desktop. */
export async function drop(page: Page, ...files: { name: string; bytes: Buffer }[]): Promise<void> {
  await page.evaluate(
    (files) => {
      const dataTransfer = new DataTransfer();
      for (const { name, base64 } of files) {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        dataTransfer.items.add(new File([bytes], name));
      }
      for (const type of ['dragenter', 'dragover', 'drop']) {
        document.body.dispatchEvent(
          new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }),
        );
      }
    },
    files.map(({ name, bytes }) => ({ name, base64: bytes.toString('base64') })),
  );
}

/** Waits for the model of that name in the line on top. */
export const modelIs = (page: Page, name: string): Promise<void> =>
  page.locator('#model b', { hasText: name }).waitFor({ timeout: 30_000 });

/** Opens a panel of the side. */
export async function openPanel(page: Page, name: string): Promise<Locator> {
  const panel = page.locator(`#${name}-panel`);
  if (!(await panel.evaluate((element: HTMLDetailsElement) => element.open))) {
    await panel.locator('summary').click();
  }
  return panel;
}

/** What is behind the '#' of the address. */
export function fragment(page: Page): string {
  return decodeURIComponent(new URL(page.url()).hash.slice(1));
}
