// Tasks that block the page. Chromium draws in software here and reads every frame back on the page's own
// thread: tasks of 100 ms and more that no real graphics card causes. So drawing itself is left out.

import type { Page } from 'playwright-core';

/** Lets a page draw nothing; call it before the page is opened. */
export async function withoutDrawing(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    for (const name of ['clear', 'drawArrays', 'drawElements', 'drawElementsInstanced'] as const) {
      prototype[name] = () => undefined;
    }
  });
}
