// Progress with time left and a cross to cancel; afterwards, what share was computed.

import { formatSeconds } from '../view/index.js';
import { make } from './dom.js';

export interface StatusActions {
  cancel(): void;
  /** Computes the whole field after a cancelled run. */
  restart(): void;
}

/** A share in words: never 100% before everything is there, never 0% once something is. */
function percent(fraction: number): string {
  const rounded = Math.round(100 * fraction);
  return `${fraction < 1 ? Math.min(99, Math.max(fraction > 0 ? 1 : 0, rounded)) : 100}%`;
}

export class StatusBar {
  readonly element = make('div', { class: 'status' });
  private readonly progress: HTMLElement;
  private readonly partial: HTMLElement;
  private readonly reading = make('div', { class: 'partial plate', role: 'status' });
  private readonly track = make('div', {
    class: 'track',
    role: 'progressbar',
    'aria-label': 'Computing the girth',
    'aria-valuemin': '0',
    'aria-valuemax': '100',
  });
  private readonly bar = make('div', { class: 'bar' });
  private readonly share = make('span', { class: 'share' });
  private readonly left = make('span', { class: 'left' });
  private readonly words = make('span');

  constructor(actions: StatusActions) {
    this.track.append(this.bar);
    const cancel = make(
      'button',
      { class: 'cross', type: 'button', 'aria-label': 'Cancel computing', title: 'Cancel' },
      '✕',
    );
    cancel.addEventListener('click', () => actions.cancel());
    this.progress = make(
      'div',
      { class: 'progress plate' },
      this.track,
      this.share,
      this.left,
      cancel,
    );
    const restart = make('button', { type: 'button' }, 'Compute all');
    restart.addEventListener('click', () => actions.restart());
    this.partial = make('div', { class: 'partial plate', role: 'status' }, this.words, restart);
    this.element.append(this.reading, this.progress, this.partial);
    this.clear();
    this.endReading();
  }

  /** Says that a file is being read, until `endReading`. */
  showReading(name: string): void {
    this.reading.hidden = false;
    this.reading.textContent = `Reading ${name || 'the model'} …`;
  }

  endReading(): void {
    this.reading.hidden = true;
  }

  showProgress(fraction: number, secondsLeft: number | undefined): void {
    this.partial.hidden = true;
    this.progress.hidden = false;
    this.bar.style.transform = `scaleX(${fraction.toFixed(4)})`;
    this.track.setAttribute('aria-valuenow', String(Math.round(100 * fraction)));
    this.share.textContent = percent(fraction);
    this.left.textContent = secondsLeft === undefined ? '' : `${formatSeconds(secondsLeft)} left`;
  }

  showPartial(fraction: number): void {
    this.progress.hidden = true;
    this.partial.hidden = false;
    this.words.textContent = `partial: ${percent(fraction)} of vertices`;
  }

  clear(): void {
    this.progress.hidden = true;
    this.partial.hidden = true;
  }
}
