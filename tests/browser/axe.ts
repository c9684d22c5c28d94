// Complaints of axe about a page.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type Axe from 'axe-core';
import type { Page } from 'playwright-core';

const script = readFileSync(createRequire(import.meta.url).resolve('axe-core'), 'utf8');

const everyRule = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];

/**
 * A line for each rule that is broken, with the first element that breaks it.
 * @param rules their names, or tags that they have; default: everything that the page shall obey
 * @param within the part of the page that is looked at: a selector. Axe takes time for every element. Default: all of it
 */
export async function complaintsOfAxe(
  page: Page,
  rules = everyRule,
  within = 'html',
): Promise<string[]> {
  if (await page.evaluate(() => !('axe' in globalThis))) await page.evaluate(script);
  return page.evaluate(
    async ([within, runOnly]) => {
      const { axe } = globalThis as unknown as { axe: typeof Axe };
      const { violations } = await axe.run(within, { runOnly, elementRef: true });
      /** Items that a list has scrolled out of its view in part count as small, for as long as they are there. */
      const isCutOff = (element: Element | null | undefined): boolean => {
        const list = element?.closest('aside')?.getBoundingClientRect();
        const box = element?.getBoundingClientRect();
        return !!list && !!box && (box.bottom > list.bottom || box.top < list.top);
      };
      return violations.flatMap(({ id, help, nodes }) => {
        const [first] = nodes.filter(
          ({ element }) => id !== 'target-size' || !isCutOff(element as Element | undefined),
        );
        return first ? [`${id}: ${help}: ${first.html}`] : [];
      });
    },
    [within, rules] as const,
  );
}

/** Complaints in light; in dark about colours alone, as nothing else differs. */
export const complaintsIn = (
  colorScheme: 'light' | 'dark',
  page: Page,
  within?: string,
): Promise<string[]> =>
  complaintsOfAxe(page, colorScheme === 'dark' ? ['color-contrast'] : undefined, within);
