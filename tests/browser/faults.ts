// Faults that are done to the page in Chromium and in other browsers to see how it ends.

/** A script before which memory of WebAssembly modules ends there, in bytes. */
export const endsAt = (bytes: number): string =>
  `{ const grow = WebAssembly.Memory.prototype.grow;
     WebAssembly.Memory.prototype.grow = function (pages) {
       if (this.buffer.byteLength + 65536 * pages > ${bytes}) throw new RangeError('no more');
       return grow.call(this, pages);
     }; }\n`;

/** On the page: its surface, which was hidden, gets one size after the other, and at last its own. */
export async function stormOfSizes(): Promise<void> {
  const surface = document.querySelector<HTMLElement>('.surface')!;
  surface.style.display = '';
  for (let i = 0; i < 60; ++i) {
    surface.style.maxWidth = `${(i * 67) % 500}px`;
    surface.style.maxHeight = `${(i * 31) % 400}px`;
    await new Promise((resolve) => setTimeout(resolve));
  }
  surface.style.maxWidth = surface.style.maxHeight = '';
}

export interface NamedBox {
  name: string;
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** Which of them lie over each other, by more than a pixel. */
export const overlapsOf = (boxes: readonly NamedBox[]): string[] =>
  boxes.flatMap((a, i) =>
    boxes
      .slice(i + 1)
      .filter(
        (b) =>
          Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
          Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1,
      )
      .map((b) => `${a.name} over ${b.name}`),
  );
