// Frames are drawn only after something has changed, and while something moves.

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { FrameScheduler, type Motion } from '../../../web/src/view/frame-scheduler.js';

/** The requests to the browser: at most one frame at a time. */
let requested: ((now: number) => void)[] = [];
let now = 0;
let drawn = 0;
let motion: Motion = 'none';
let isTurning = false;
let again = false;
let scheduler: FrameScheduler;

/** Lets frames come until none is asked for, at most so many; returns how many came. */
function frames(most: number, interval = 16): number {
  for (let count = 0; count < most; ++count) {
    const [frame] = requested.splice(0);
    if (!frame) return count;
    now += interval;
    frame(now);
  }
  return most;
}

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] });
  [requested, now, drawn, motion, isTurning, again] = [[], 1000, 0, 'none', false, false];
  vi.stubGlobal('requestAnimationFrame', (frame: (now: number) => void) => requested.push(frame));
  vi.stubGlobal('cancelAnimationFrame', () => (requested = []));
  scheduler = new FrameScheduler({
    begin: () => again,
    isUnhurried: () => isTurning,
    advance: () => motion,
    draw: () => ++drawn,
  });
});
afterEach(() => {
  scheduler.stop();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test('it rests until it is in view, and then draws once', () => {
  scheduler.invalidate();
  expect(frames(9)).toBe(0);
  scheduler.rest(false);
  expect(frames(9)).toBe(1);
  expect(drawn).toBe(1);
  scheduler.invalidate();
  scheduler.invalidate();
  expect(frames(9)).toBe(1);
  expect(drawn).toBe(2);
  scheduler.rest(true);
  scheduler.invalidate();
  expect(frames(9)).toBe(0);
});

test('a frame that is only looked at draws nothing unless something moves', () => {
  scheduler.rest(false);
  frames(9);
  scheduler.look();
  expect(frames(9)).toBe(1);
  expect(drawn).toBe(1);
  motion = 'more';
  scheduler.look();
  expect(frames(5)).toBe(5);
  expect(drawn).toBe(6);
  motion = 'last';
  expect(frames(9)).toBe(1);
  expect(drawn).toBe(7);
});

test('a slow turning is drawn at every other frame', () => {
  scheduler.rest(false);
  frames(9);
  [isTurning, motion] = [true, 'more'];
  scheduler.look();
  frames(20);
  expect(drawn).toBe(1 + 10);
});

test('what begins a frame may change what is drawn, without asking for another frame', () => {
  const changing = new FrameScheduler({
    begin: () => {
      changing.invalidate();
      return false;
    },
    isUnhurried: () => false,
    advance: () => 'none',
    draw: () => ++drawn,
  });
  changing.rest(false);
  expect(frames(9)).toBe(1);
  expect(drawn).toBe(1);
  changing.invalidate();
  expect(frames(9)).toBe(1);
  expect(drawn).toBe(2);
});

test('what is still to come asks for the next frame', () => {
  scheduler.rest(false);
  again = true;
  expect(frames(3)).toBe(3);
  again = false;
  expect(frames(9)).toBe(1);
  expect(drawn).toBe(4);
});

test('requests that are not urgent share one frame; none comes after the end', () => {
  scheduler.rest(false);
  frames(9);
  for (let i = 0; i < 5; ++i) scheduler.invalidateSoon();
  expect(frames(9)).toBe(0);
  vi.advanceTimersByTime(100);
  expect(frames(9)).toBe(1);
  expect(drawn).toBe(2);
  scheduler.invalidateSoon();
  scheduler.stop();
  vi.advanceTimersByTime(5000);
  scheduler.invalidate();
  expect(frames(9)).toBe(0);
});

test('what one moves in another is noticed and drawn in the same frame, whoever comes first', () => {
  const log: string[] = [];
  /** Where each of two is; the one that is led goes where the other is. */
  const places = { leader: 0, led: 0 };
  const make = (name: keyof typeof places, advance: () => void): FrameScheduler =>
    new FrameScheduler({
      begin: () => false,
      isUnhurried: () => false,
      advance: () => {
        advance();
        if (told[name] === places[name]) return 'none';
        log.push(`${name} at ${(told[name] = places[name])}`);
        return 'last';
      },
      draw: () => log.push(`${name} ${places[name]}`),
    });
  /** Where each has last noticed that it is. */
  const told = { leader: 0, led: 0 };
  const led = make('led', () => undefined);
  const leader = make('leader', () => {
    ++places.leader;
    places.led = places.leader;
    led.invalidate();
  });
  led.rest(false);
  leader.rest(false);
  // Both were asked for, first the one that is led: it has advanced already when it is moved.
  frames(1);
  expect(log.splice(0)).toEqual(['leader at 1', 'led at 1', 'led 1', 'leader 1']);
  expect(frames(9)).toBe(0);
  expect(log.splice(0)).toEqual([]);
  // Nothing was asked of the one that is led.
  leader.look();
  frames(1);
  expect(log.splice(0)).toEqual(['leader at 2', 'led at 2', 'leader 2', 'led 2']);
  leader.stop();
  led.stop();
});

test('two that move each other advance twice in a frame, and no more', () => {
  const turns = [0, 0];
  const schedulers = [0, 1].map(
    (i) =>
      new FrameScheduler({
        begin: () => false,
        isUnhurried: () => false,
        advance: () => {
          ++turns[i]!;
          schedulers[1 - i]!.invalidate();
          return 'none';
        },
        draw: () => ++drawn,
      }),
  );
  for (const one of schedulers) one.rest(false);
  frames(1);
  expect(turns).toEqual([2, 2]);
  expect(drawn).toBe(2);
  for (const one of schedulers) one.stop();
  expect(frames(9)).toBe(0);
});
