// How many clicks a task takes: what a hand does, the choices of lists included.

import type { Page } from 'playwright-core';

/** Counts from now on; the answer is asked for later. Typing is free, choosing from a list costs one. */
export async function clicksOn(page: Page): Promise<() => Promise<number>> {
  await page.evaluate(() => {
    const counter = { count: 0 };
    Object.assign(window, { clickCounter: counter });
    const count = (): void => {
      ++counter.count;
    };
    addEventListener('pointerdown', (event) => event.isTrusted && count(), { capture: true });
    // Choices that a test makes come without a pointer.
    addEventListener('change', (event) => event.target instanceof HTMLSelectElement && count(), {
      capture: true,
    });
  });
  return () =>
    page.evaluate(
      () => (window as unknown as { clickCounter: { count: number } }).clickCounter.count,
    );
}
