// Makes pages slow in the way that a busy machine does: answers of workers and of servers arrive late.

import type { BrowserContext } from 'playwright-core';

/** The longest that anything is held back, in milliseconds; 0: nothing is. */
const longest = Number(process.env['GIRTH_TEST_DELAY'] ?? 0);

/** Waits as long as a script may take from a busy server. */
export async function delayScript(): Promise<void> {
  if (longest > 0) await new Promise((done) => setTimeout(done, longest * Math.random()));
}

/** Holds back what workers say to the pages of a context, as `npm run test:repeat -- --delay` asks for. */
export async function delayAnswers(context: BrowserContext): Promise<void> {
  if (longest > 0) await context.addInitScript(holdBack, longest);
}

/** Runs in the page, before its scripts. Messages of a worker keep their order. */
function holdBack(longest: number): void {
  const late = new WeakSet<Event>();
  const wait = (): number => longest * Math.random();
  const hold = (target: Worker): void => {
    const held: MessageEvent[] = [];
    let due = 0;
    target.addEventListener('message', (event) => {
      if (late.has(event)) return;
      event.stopImmediatePropagation();
      const again = new MessageEvent('message', { data: event.data as unknown });
      late.add(again);
      held.push(again);
      due = Math.max(due, performance.now() + wait());
      // Timers are precise to a millisecond: each lets go of the message that has waited longest.
      setTimeout(() => target.dispatchEvent(held.shift()!), due - performance.now());
    });
  };
  globalThis.Worker = class extends Worker {
    constructor(...given: ConstructorParameters<typeof Worker>) {
      super(...given);
      hold(this);
    }
  };
}
