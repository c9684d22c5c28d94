// The worker's side of surfaces: those that it holds, by the page's numbers.

export class SurfaceStore<S extends { delete(): void }> {
  readonly #surfaces = new Map<number, S>();

  /** Holds a surface of the module. */
  add(number: number, surface: S): void {
    this.drop(number);
    this.#surfaces.set(number, surface);
  }

  /** Throws where the page has not handed the surface over: a fault of the page's side. */
  get(number: number): S {
    const surface = this.#surfaces.get(number);
    if (!surface) throw new Error(`surface ${number} is not known to this worker`);
    return surface;
  }

  /** Frees a surface. An unknown number is no error. */
  drop(number: number): void {
    this.#surfaces.get(number)?.delete();
    this.#surfaces.delete(number);
  }
}
