// Progress with time left and a cross to cancel; afterwards, what share was computed.

import { formatSeconds } from '../../view/index.js';
import { make } from './dom.js';

export interface StatusActions {
  cancel(): void;
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

export class StatusBar {
  readonly element = make('div', { class: 'status' });
  readonly #progress: HTMLElement;
  readonly #partial: HTMLElement;
  readonly #work: HTMLElement;
  readonly #workWords = make('span', { role: 'status' });
  readonly #workShare = make('progress', { max: '1', 'aria-label': 'Preparing the model' });
  readonly #track = make('div', {
    class: 'track',
    role: 'progressbar',
    'aria-valuemin': '0',
    'aria-valuemax': '100',
  });
  readonly #bar = make('div', { class: 'bar' });
  readonly #what = make('span', { class: 'what' });
  readonly #share = make('span', { class: 'share' });
  readonly #left = make('span', { class: 'left' });
  readonly #words = make('span');

  constructor(actions: StatusActions) {
    this.#track.append(this.#bar);
    const cancel = cross('Cancel computing');
    cancel.addEventListener('click', () => actions.cancel());
    this.#progress = make(
      'div',
      { class: 'progress plate' },
      this.#what,
      this.#track,
      this.#share,
      this.#left,
      cancel,
    );
    const restart = make('button', { type: 'button' }, 'Compute all');
    restart.addEventListener('click', () => actions.restart());
    this.#partial = make('div', { class: 'partial plate', role: 'status' }, this.#words, restart);
    const stop = cross('Cancel reading');
    stop.addEventListener('click', () => actions.cancelWork());
    const [workWords, workShare] = [this.#workWords, this.#workShare];
    this.#work = make('div', { class: 'work plate' }, workWords, workShare, stop);
    this.element.append(this.#work, this.#progress, this.#partial);
    this.clear();
    this.endWork();
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

  /** `title` is what is computed. */
  showProgress(title: string, fraction: number, secondsLeft: number | undefined): void {
    this.#partial.hidden = true;
    this.#progress.hidden = false;
    this.#what.textContent = title;
    this.#track.setAttribute('aria-label', `Computing: ${title}`);
    this.#bar.style.transform = `scaleX(${fraction.toFixed(4)})`;
    this.#track.setAttribute('aria-valuenow', String(Math.round(100 * fraction)));
    this.#share.textContent = percent(fraction);
    this.#left.textContent = secondsLeft === undefined ? '' : `${formatSeconds(secondsLeft)} left`;
  }

  showPartial(title: string, fraction: number): void {
    this.#progress.hidden = true;
    this.#partial.hidden = false;
    this.#words.textContent = `${title}, partial: ${percent(fraction)} of vertices`;
  }

  clear(): void {
    this.#progress.hidden = true;
    this.#partial.hidden = true;
  }
}
