// Each computation's progress, with the time left and a cross to cancel it; afterwards, what share was computed.

import { formatSeconds } from '../../view/index.js';
import { make } from './dom.js';

export interface StatusActions {
  /** Ends what `showProgress` shows under a key. */
  cancel(key: string): void;
  /** Ends what `showWork` shows. */
  cancelWork(): void;
  /** Computes the whole field after a cancelled run. */
  restart(): void;
}

/** A share in words: never 100% before everything is there, never 0% once something is. */
function percent(fraction: number): string {
  const rounded = Math.round(100 * fraction);
  return `${fraction < 1 ? Math.min(99, Math.max(fraction > 0 ? 1 : 0, rounded)) : 100}%`;
}

function cross(label: string): HTMLButtonElement {
  const title = 'Cancel';
  return make('button', { class: 'cross', type: 'button', 'aria-label': label, title }, '✕');
}

/** One computation in work. */
class Run {
  readonly #track = make('div', {
    class: 'track',
    role: 'progressbar',
    'aria-valuemin': '0',
    'aria-valuemax': '100',
  });
  readonly #bar = make('div', { class: 'bar' });
  readonly #share = make('span', { class: 'share' });
  readonly #left = make('span', { class: 'left' });
  readonly element: HTMLElement;

  constructor(title: string, cancel: () => void) {
    this.#track.append(this.#bar);
    this.#track.setAttribute('aria-label', `Computing: ${title}`);
    const what = make('span', { class: 'what' }, title);
    const stop = cross(`Cancel computing: ${title}`);
    stop.addEventListener('click', cancel);
    const parts = [what, this.#track, this.#share, this.#left, stop];
    this.element = make('div', { class: 'progress plate' }, ...parts);
  }

  show(fraction: number, secondsLeft: number | undefined): void {
    this.#bar.style.transform = `scaleX(${fraction.toFixed(4)})`;
    this.#track.setAttribute('aria-valuenow', String(Math.round(100 * fraction)));
    this.#share.textContent = percent(fraction);
    this.#left.textContent = secondsLeft === undefined ? '' : `${formatSeconds(secondsLeft)} left`;
  }

  /** Another one begins, for which it may have to wait. */
  forgetTime(): void {
    this.#left.textContent = '';
  }
}

export class StatusBar {
  readonly element = make('div', { class: 'status' });
  readonly #runs = new Map<string, Run>();
  readonly #runList = make('div', { class: 'runs' });
  readonly #partial: HTMLElement;
  readonly #work: HTMLElement;
  readonly #workWords = make('span', { role: 'status' });
  readonly #workShare = make('progress', { max: '1', 'aria-label': 'Preparing the model' });
  readonly #words = make('span');
  readonly #actions: StatusActions;

  constructor(actions: StatusActions) {
    this.#actions = actions;
    const restart = make('button', { type: 'button' }, 'Compute all');
    restart.addEventListener('click', () => actions.restart());
    this.#partial = make('div', { class: 'partial plate', role: 'status' }, this.#words, restart);
    const stop = cross('Cancel reading');
    stop.addEventListener('click', () => actions.cancelWork());
    const [workWords, workShare] = [this.#workWords, this.#workShare];
    this.#work = make('div', { class: 'work plate' }, workWords, workShare, stop);
    this.#runList.append(new Run('', () => undefined).element);
    this.element.append(this.#work, this.#runList, this.#partial);
    this.clear();
    this.endWork();
  }

  /** The plates that lie on the surface. */
  get plates(): HTMLElement[] {
    return [this.#work, ...[...this.#runs.values()].map(({ element }) => element), this.#partial];
  }

  /** Says what is being done to a model, and how much of it, until `endWork`. */
  showWork(words: string, fraction: number): void {
    this.#work.hidden = false;
    if (this.#workWords.textContent !== words) this.#workWords.textContent = words;
    this.#workShare.value = fraction;
  }

  endWork(): void {
    this.#work.hidden = true;
  }

  /** Shows a computation in work, until `end` with its key. */
  showProgress(
    key: string,
    title: string,
    fraction: number,
    secondsLeft: number | undefined,
  ): void {
    this.#partial.hidden = true;
    let run = this.#runs.get(key);
    if (!run) {
      for (const other of this.#runs.values()) other.forgetTime();
      run = new Run(title, () => this.#actions.cancel(key));
      if (this.#runs.size === 0) this.#runList.replaceChildren();
      this.#runs.set(key, run);
      this.#runList.append(run.element);
    }
    run.show(fraction, secondsLeft);
    this.#runList.hidden = false;
  }

  /** A computation is over, whatever came of it. */
  end(key: string): void {
    const run = this.#runs.get(key);
    this.#runs.delete(key);
    this.#runList.hidden = this.#runs.size === 0;
    // The last one stays, unseen: pages may look whether a bar is visible.
    if (this.#runs.size > 0) run?.element.remove();
  }

  showPartial(title: string, fraction: number): void {
    this.#partial.hidden = false;
    this.#words.textContent = `${title}, partial: ${percent(fraction)} of vertices`;
  }

  clear(): void {
    for (const key of this.#runs.keys()) this.end(key);
    this.#runList.hidden = true;
    this.#partial.hidden = true;
  }
}
