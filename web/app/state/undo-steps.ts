// Steps of what was shown before, to go back and forth. States are only text here.

/** Steps further back than this are forgotten. */
const mostSteps = 200;

export class UndoSteps {
  #past: string[] = [];
  #future: string[] = [];
  #present: string | undefined;
  readonly #changed: () => void;

  /** `changed`: whether one can go back or forth may be another now. */
  constructor(changed: () => void = () => undefined) {
    this.#changed = changed;
  }

  /** The state that is shown. */
  get present(): string | undefined {
    return this.#present;
  }

  /** The state to go back to; undefined where there is none. */
  get before(): string | undefined {
    return this.#past.at(-1);
  }

  /** The state of a step that was undone; undefined where there is none. */
  get after(): string | undefined {
    return this.#future.at(-1);
  }

  /** Another state has come about: undone steps are forgotten. */
  take(state: string): void {
    if (state === this.#present) return;
    if (this.#present !== undefined) this.#past = [...this.#past, this.#present].slice(-mostSteps);
    this.#present = state;
    this.#future = [];
    this.#changed();
  }

  /** The present state turns out to be written like this: no step. */
  correct(state: string): void {
    this.#present = state;
  }

  /** Goes back a step; the state there, undefined where there is none. */
  undo(): string | undefined {
    return this.#move(this.#past, this.#future);
  }

  /** Goes forth again. */
  redo(): string | undefined {
    return this.#move(this.#future, this.#past);
  }

  #move(from: string[], to: string[]): string | undefined {
    const state = from.pop();
    if (state === undefined) return undefined;
    if (this.#present !== undefined) to.push(this.#present);
    this.#present = state;
    this.#changed();
    return state;
  }
}
