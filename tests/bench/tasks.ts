// How long the tasks of a page's own thread take: by the clock, which stands for what a user feels, and
// in processor time, which does not depend on what else the machine does meanwhile.

import type { Browser, Page } from 'playwright-core';
import { type Figure, figure } from './figures.js';

export interface Task {
  /** Milliseconds since the page was opened. */
  start: number;
  /** Milliseconds by the clock. */
  wall: number;
  /** Milliseconds of processor time. */
  processor: number;
  /** The longest pieces of work inside, with their milliseconds of processor time. */
  inside: string[];
}

/** An event of Chromium's trace; times in microseconds. */
interface TraceEvent {
  name: string;
  ph: string;
  pid: number;
  tid: number;
  ts: number;
  dur?: number;
  tdur?: number;
  args?: { data?: { startTime?: number; functionName?: string; type?: string } };
}

const mark = 'girth-bench';

/** Begins to record; call it before the page is opened. Ends with the tasks in their order. */
export async function recordTasks(browser: Browser, page: Page): Promise<() => Promise<Task[]>> {
  await browser.startTracing(page, {
    categories: [
      'devtools.timeline',
      'disabled-by-default-devtools.timeline',
      'blink.user_timing',
      'v8',
    ],
  });
  return async () => {
    await page.evaluate((name) => performance.mark(name), mark);
    const trace = JSON.parse((await browser.stopTracing()).toString()) as {
      traceEvents: TraceEvent[];
    };
    return tasksOf(trace.traceEvents);
  };
}

/** The longest of some tasks beside a goal in milliseconds; those that come near it are written on the console. */
export function longestTasks(what: string, tasks: readonly Task[], goal: number): Figure[] {
  for (const { start, wall, processor, inside } of tasks) {
    if (Math.max(wall, processor) < 0.6 * goal) continue;
    const sizes = `${wall.toFixed(0)} ms, processor ${processor.toFixed(0)} ms`;
    console.log(`${what}, at ${start.toFixed(0)} ms: ${sizes}: ${inside.join(', ')}`);
  }
  const longest = (key: 'wall' | 'processor') => Math.max(...tasks.map((task) => task[key]));
  return [
    figure(`longest task, ${what}, by the clock`, 'ms', longest('wall'), goal),
    figure(`longest task, ${what}, processor`, 'ms', longest('processor'), goal),
  ];
}

function tasksOf(events: TraceEvent[]): Task[] {
  const marked = events.find(({ name }) => name === mark);
  if (!marked) throw new Error('the trace has no mark of the page');
  const opened = marked.ts - 1000 * (marked.args?.data?.startTime ?? 0);
  const own = events
    .filter(({ pid, tid, ph }) => pid === marked.pid && tid === marked.tid && ph === 'X')
    .sort((a, b) => a.ts - b.ts);
  const milliseconds = (event: TraceEvent) => (event.tdur ?? event.dur ?? 0) / 1000;
  return own
    .filter(({ name, ts }) => name === 'RunTask' && ts >= opened)
    .map((task) => {
      const end = task.ts + (task.dur ?? 0);
      const inside = own
        .filter((event) => event !== task && event.ts >= task.ts && event.ts < end)
        .filter((event) => milliseconds(event) >= 5)
        .map((event) => `${labelOf(event)} ${milliseconds(event).toFixed(0)}`);
      return {
        start: (task.ts - opened) / 1000,
        wall: (task.dur ?? 0) / 1000,
        processor: milliseconds(task),
        inside,
      };
    });
}

function labelOf({ name, args }: TraceEvent): string {
  const detail = args?.data?.functionName || args?.data?.type;
  return detail ? `${name}(${detail})` : name;
}
