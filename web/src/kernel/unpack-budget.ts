// How large a model may become while it is unpacked: the same rule as that of the C++ reader
// (`soup_budget.h`), so that both refuse the same files.

export class UnpackBudget {
  // Small files may place a small mesh many times.
  #left = 4_000_000;

  /** Makes room for what so many bytes may describe. */
  allowFor(bytes: number): void {
    this.#left += 4 * bytes;
  }

  /** Whether there is room for `count` more; if so they are taken. */
  take(count: number): boolean {
    if (!(count <= this.#left)) return false;
    this.#left -= count;
    return true;
  }
}
