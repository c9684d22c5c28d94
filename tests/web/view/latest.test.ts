import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { Latest } from '../../../web/src/view/latest.js';

interface Asked {
  key: number;
  signal: AbortSignal;
  answer(): void;
}

function setup() {
  const asked: Asked[] = [];
  const answered: number[] = [];
  const failed: number[] = [];
  const latest = new Latest<number, string>(
    (key, signal) =>
      new Promise((resolve, reject) => {
        asked.push({ key, signal, answer: () => resolve('answer') });
        signal.addEventListener('abort', () => reject(new Error('aborted')));
      }),
    (key) => answered.push(key),
    (key) => failed.push(key),
  );
  return { latest, asked, answered, failed };
}

const settle = () => vi.advanceTimersByTimeAsync(0);

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test('one request runs, only the newest waits', async () => {
  const { latest, asked, answered } = setup();
  for (const key of [1, 2, 3, 4]) latest.request(key);
  expect(asked.map(({ key }) => key)).toEqual([1]);
  asked[0]!.answer();
  await settle();
  expect(asked.map(({ key }) => key)).toEqual([1, 4]);
  asked[1]!.answer();
  await settle();
  expect(answered).toEqual([1, 4]);
});

test('a slow request is aborted for a newer one, without a complaint', async () => {
  const { latest, asked, answered, failed } = setup();
  latest.request(1);
  await vi.advanceTimersByTimeAsync(500);
  expect(asked[0]!.signal.aborted).toBe(false);
  latest.request(2);
  await vi.advanceTimersByTimeAsync(500);
  expect(asked[0]!.signal.aborted).toBe(true);
  expect(asked.map(({ key }) => key)).toEqual([1, 2]);
  asked[1]!.answer();
  await settle();
  expect(answered).toEqual([2]);
  expect(failed).toEqual([]);
});

test('asking again for what runs drops what waits', async () => {
  const { latest, asked, answered } = setup();
  latest.request(1);
  latest.request(2);
  latest.request(1);
  asked[0]!.answer();
  await settle();
  expect(asked).toHaveLength(1);
  expect(answered).toEqual([1]);
});

test('after clear nothing is answered, and new requests run at once', async () => {
  const { latest, asked, answered, failed } = setup();
  latest.request(1);
  latest.request(2);
  latest.clear();
  expect(asked[0]!.signal.aborted).toBe(true);
  latest.request(3);
  expect(asked.map(({ key }) => key)).toEqual([1, 3]);
  asked[1]!.answer();
  await settle();
  expect(answered).toEqual([3]);
  expect(failed).toEqual([]);
});

test('a failure is told and the next request runs', async () => {
  const failed: unknown[] = [];
  const latest = new Latest<number, number>(
    (key) => (key === 1 ? Promise.reject(new Error('no')) : Promise.resolve(key)),
    (key) => failed.push(key),
    (_key, error) => failed.push(error),
  );
  latest.request(1);
  latest.request(2);
  await settle();
  expect(failed).toEqual([new Error('no'), 2]);
});
