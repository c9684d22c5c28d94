// The moment when the page is there as a whole.

let parsed: Promise<void> | undefined;

/** Resolves when the page's own scripts have run, so that they listen to what happens. */
export function pageParsed(): Promise<void> {
  parsed ??= new Promise((resolve) => {
    if (document.readyState === 'complete') {
      resolve();
      return;
    }
    // The first is over already where this is asked for in between.
    document.addEventListener('DOMContentLoaded', () => resolve(), { once: true });
    window.addEventListener('load', () => resolve(), { once: true });
  });
  return parsed;
}
