// Long work on the main thread, in slices short enough for a frame.

/** Milliseconds of work between two looks at the event queue. */
const slice = 8;

/** Lets the page breathe. */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(undefined);
  });
}

/** Runs a generator to its end, letting the page breathe in between; throws when aborted. */
export async function inSlices<Result>(
  work: Generator<void, Result>,
  signal?: AbortSignal,
): Promise<Result> {
  for (;;) {
    const end = performance.now() + slice;
    do {
      const step = work.next();
      if (step.done) {
        await nextTask(); // work that comes of it is a task of its own
        signal?.throwIfAborted();
        return step.value;
      }
    } while (performance.now() < end);
    await nextTask();
    signal?.throwIfAborted();
  }
}
