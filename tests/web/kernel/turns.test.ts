// The order of turns: urgent wishes go first, what was paused goes on before what has not begun.

import { expect, test } from 'vitest';
import { Turns, type Turn, type Wish } from '../../../web/src/kernel/page/turns.js';

/** Turns whose wishes have names, and the names in the order in which they got theirs. */
function namedTurns() {
  const turns = new Turns();
  const got: string[] = [];
  const held = new Map<string, Turn>();
  const take = (name: string, wish: Partial<Wish> = {}, again = false) =>
    turns.take({ isUrgent: false, canPause: true, ...wish }, again).then((turn) => {
      got.push(name);
      held.set(name, turn);
      return turn;
    });
  const end = async (name: string) => {
    held.get(name)!.end();
    await new Promise((resolve) => setTimeout(resolve));
  };
  return { turns, got, take, end };
}

test('turns come in the order of the wishes, one at a time', async () => {
  const { got, take, end } = namedTurns();
  await take('first');
  void take('second');
  void take('third');
  expect(got).toEqual(['first']);
  await end('first');
  expect(got).toEqual(['first', 'second']);
  await end('second');
  await end('third');
  expect(got).toEqual(['first', 'second', 'third']);
});

test('something urgent asks the present one to pause, which then goes on before others', async () => {
  const { got, take, end } = namedTurns();
  const first = await take('girth');
  void take('later');
  void take('thickness', { isUrgent: true });
  expect(first.pause.aborted).toBe(true);
  void take('diameter', { isUrgent: true });
  await end('girth');
  expect(got).toEqual(['girth', 'thickness']);
  void take('girth again', {}, true);
  await end('thickness');
  await end('diameter');
  await end('girth again');
  expect(got).toEqual(['girth', 'thickness', 'diameter', 'girth again', 'later']);
});

test('what is urgent itself, or cannot pause, is not asked to', async () => {
  const urgent = namedTurns();
  const first = await urgent.take('first', { isUrgent: true });
  void urgent.take('second', { isUrgent: true });
  expect(first.pause.aborted).toBe(false);
  expect(urgent.turns.isHeld).toBe(false);
  const { turns, take, end } = namedTurns();
  const held = await take('refined', { canPause: false });
  expect(turns.isHeld).toBe(true);
  void take('urgent', { isUrgent: true });
  expect(held.pause.aborted).toBe(false);
  await end('refined');
  expect(turns.isHeld).toBe(false);
});

test('a turn that was ended is not ended once more', async () => {
  const { got, take, end } = namedTurns();
  await take('first');
  void take('second');
  void take('third');
  await end('first');
  await end('first');
  expect(got).toEqual(['first', 'second']);
});
