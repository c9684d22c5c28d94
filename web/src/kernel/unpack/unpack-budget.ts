// How large a model may become when it is unpacked: the rule of the C++ reader (`soup_budget.h`), so that
// both refuse the same files.

export class UnpackBudget {
  // Small files may hold much that is not written down.
  #left = 4_000_000;

  /** Allows as much as so many bytes may describe. */
  allowFor(bytes: number): void {
    this.#left += 4 * bytes;
  }

  /** Reserves `count` more; false where they exceed the budget. */
  take(count: number): boolean {
    if (!(count <= this.#left)) return false;
    this.#left -= count;
    return true;
  }
}
