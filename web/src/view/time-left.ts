// How long a computation will still take.

/**
 * Estimates the seconds left from reports of the finished share. Says nothing until it has seen
 * enough to be believed.
 */
export class TimeLeft {
  readonly #start: number;
  #smoothed: number | undefined;

  /** `now` and all later times are in milliseconds. */
  constructor(now: number) {
    this.#start = now;
  }

  /** Seconds left at a finished share in [0, 1]; undefined while it is too early to estimate. */
  update(fraction: number, now: number): number | undefined {
    const elapsed = (now - this.#start) / 1000;
    if (fraction >= 1) return 0;
    if (fraction < 0.02 || elapsed < 0.4) return undefined;
    const left = (elapsed / fraction) * (1 - fraction);
    this.#smoothed = this.#smoothed === undefined ? left : 0.7 * this.#smoothed + 0.3 * left;
    return Math.min(this.#smoothed, 2 * left);
  }
}

/** 'under 1 s', '12 s', '3 min'. */
export function formatSeconds(seconds: number): string {
  if (seconds < 1) return 'under 1\u202fs';
  if (seconds < 90) return `${Math.round(seconds)}\u202fs`;
  return `${Math.round(seconds / 60)}\u202fmin`;
}
