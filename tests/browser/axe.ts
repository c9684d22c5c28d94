// What axe objects to on a page.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type Axe from 'axe-core';
import type { Page } from 'playwright-core';

const script = readFileSync(createRequire(import.meta.url).resolve('axe-core'), 'utf8');

const everyRule = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];

/**
 * A line for each rule that is broken, with the first element that breaks it.
 * @param rules their names, or tags that they have; default: everything that the page shall obey
 */
export async function complaintsOfAxe(page: Page, rules = everyRule): Promise<string[]> {
  if (await page.evaluate(() => !('axe' in globalThis))) await page.evaluate(script);
  return page.evaluate(async (runOnly) => {
    const { axe } = globalThis as unknown as { axe: typeof Axe };
    const { violations } = await axe.run(document, { runOnly });
    return violations.map(({ id, help, nodes }) => `${id}: ${help}: ${nodes[0]!.html}`);
  }, rules);
}
