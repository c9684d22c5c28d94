// The tasks of the page while it opens and computes: its first example, and then another one.

import type { chromiumForTests } from '../browser/support.js';
import { withoutDrawing } from '../browser/long-tasks.js';
import { type Task, recordTasks } from './tasks.js';

/** What the page at an address does until the chair is computed, and from then on until the octopus is. */
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
