// Opening models on the page, and its tasks meanwhile: its first example, and then another one.

import type { Page } from 'playwright-core';
import type { chromiumForTests } from '../browser/support.js';
import { withoutDrawing } from '../browser/long-tasks.js';
import { type Task, recordTasks } from './tasks.js';

/** The tasks of the page at an address until the chair is computed, and from then on until the octopus is. */
export async function tasksOfOpening(
  openPage: ReturnType<typeof chromiumForTests>,
  address: string,
): Promise<[string, Task[]][]> {
  const { context, page, browser } = await openPage('about:blank');
  await withoutDrawing(page);
  const recorded = await recordTasks(browser, page);
  await page.goto(address);
  const complete = page.locator('html[data-field=complete]');
  await complete.waitFor({ state: 'attached', timeout: 120_000 });
  const from = await page.evaluate(() => {
    delete document.documentElement.dataset['field'];
    document.querySelector<HTMLButtonElement>('[data-example=octopus]')!.click();
    return performance.now();
  });
  await complete.waitFor({ state: 'attached', timeout: 120_000 });
  const tasks = await recorded();
  await context.close();
  return [
    ['opening and the chair', tasks.filter(({ start }) => start < from)],
    ['loading and computing the octopus', tasks.filter(({ start }) => start >= from)],
  ];
}

/** Has a page open a file that its server has; the seconds until it is drawn. */
export function openServed(page: Page, name: string): Promise<number> {
  // As a file that is chosen: that the driver hands over so many megabytes is not the page's work.
  return page.evaluate(async (name) => {
    const content = await (await fetch(`/${name}`)).blob();
    const files = new DataTransfer();
    files.items.add(new File([content], name));
    const chooser = document.querySelector<HTMLInputElement>('#file')!;
    chooser.files = files.files;
    delete document.documentElement.dataset['field'];
    const from = performance.now();
    const loaded = new Promise<number>((done) => {
      document
        .querySelector('girth-viewer')!
        .addEventListener('load', () => done((performance.now() - from) / 1000), { once: true });
    });
    chooser.dispatchEvent(new Event('change'));
    return loaded;
  }, name);
}
