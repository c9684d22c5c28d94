// Options that many calls have.

/** Options of every call. */
export interface CallOptions {
  /** Aborting stops the work: the promise is rejected with CANCELLED, an 'AbortError' with the signal's reason as its cause. */
  signal?: AbortSignal;
}

/** Options of calls that report their progress. */
export interface WatchedOptions extends CallOptions {
  /** Receives the finished share, in [0, 1]. It never falls and ends with 1. */
  onProgress?: (fraction: number) => void;
}
