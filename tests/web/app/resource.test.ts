// Results by their keys: what comes late, for another key, or after it was ended, is never shown.

import { expect, test } from 'vitest';
import { type Key, Resource, type Status, type Watch } from '../../../web/app/results/resource.js';
import { randomFrom } from './random-state.js';

/** A computation that is under way until a test ends it. */
interface Job {
  key: Key;
  watch: Watch;
  resolve(found: string): void;
  reject(error: unknown): void;
}

/** A kernel that computes nothing by itself. */
function fakeKernel() {
  const jobs: Job[] = [];
  let key: Key = [];
  const told: Status<string>[] = [];
  const resource = new Resource<string>({
    find: (watch) =>
      new Promise((resolve, reject) => void jobs.push({ key, watch, resolve, reject })),
    changed: (status) => void told.push(status),
  });
  const want = (wanted: Key): void => {
    key = wanted;
    resource.want(wanted);
  };
  return { jobs, told, resource, want };
}

const answers = () => new Promise<void>((done) => setImmediate(done));

test('a result is pending with its progress, and then there', async () => {
  const { jobs, told, resource, want } = fakeKernel();
  want(['cup', '1%']);
  const { onProgress, signal } = jobs[0]!.watch('Looking');
  onProgress(0.5);
  jobs[0]!.resolve('two');
  await answers();
  expect(told).toEqual([
    { is: 'pending', words: undefined, share: undefined },
    { is: 'pending', words: 'Looking', share: undefined },
    { is: 'pending', words: 'Looking', share: 0.5 },
    { is: 'done', found: 'two' },
  ]);
  expect(signal.aborted).toBe(false);
  // Asked again, it is there already.
  want(['cup', '1%']);
  expect([jobs.length, resource.found]).toEqual([1, 'two']);
  want(['cup', '2%']);
  expect([jobs.length, resource.found]).toEqual([2, undefined]);
});

test('what was stopped or has failed is computed when it is asked for again', async () => {
  const { jobs, resource, want } = fakeKernel();
  want(['cup']);
  const { signal } = jobs[0]!.watch('Looking');
  resource.stop();
  expect(signal.aborted).toBe(true);
  jobs[0]!.reject(signal.reason);
  await answers();
  expect(resource.status).toEqual({ is: 'stopped' });
  want(['cup']);
  jobs[1]!.reject(new Error('no room'));
  await answers();
  expect(resource.status).toEqual({ is: 'failed', error: new Error('no room') });
  want(['cup']);
  expect(resource.status.is).toBe('pending');
});

test('10,000 random steps: no result is shown but that of the wanted key', async () => {
  for (const seed of [3, 49, 2026, 71]) {
    const random = randomFrom(seed);
    const { jobs, told, resource, want } = fakeKernel();
    /** The wanted key, in the words of a plain model. */
    let wanted: Key | undefined;
    let expected: Status<string>['is'] = 'unwanted';
    const isSame = (key: Key): boolean => JSON.stringify(key) === JSON.stringify(wanted);
    for (let step = 0; step < 2_500; ++step) {
      const about = `seed ${seed}, step ${step}`;
      const act = random.below(8);
      if (act < 3) {
        const key = [random.of(['cup', 'octopus']), random.of([undefined, '1%'])];
        const count = jobs.length;
        want(key);
        const isThere = isSame(key) && (expected === 'done' || expected === 'pending');
        expect(jobs.length - count, about).toBe(isThere ? 0 : 1);
        if (!isThere) expected = 'pending';
        wanted = key;
      } else if (act === 3) {
        resource.drop();
        [wanted, expected] = [undefined, 'unwanted'];
      } else if (act === 4) {
        resource.stop();
        const job = jobs.at(-1);
        if (expected === 'pending' && job) {
          job.reject(new Error('cancelled'));
          expected = 'stopped';
        }
        await answers();
      } else if (jobs.length > 0) {
        // Any of all jobs says something: most are of keys that are not wanted any more.
        const at = Math.max(0, jobs.length - 1 - random.below(4));
        const job = jobs[at]!;
        const isPresent = at === jobs.length - 1 && expected === 'pending';
        const { onProgress, signal } = job.watch('Looking');
        const shown = told.at(-1);
        expect(signal.aborted, about).toBe(!isPresent && signal.aborted);
        if (act === 5) {
          onProgress(0.5);
          if (!isPresent) expect(told.at(-1), about).toBe(shown);
        } else if (act === 6) job.resolve(JSON.stringify(job.key));
        else job.reject(new Error('no room'));
        if (isPresent && act !== 5) expected = act === 6 ? 'done' : 'failed';
        await answers();
      }
      expect(resource.status.is, about).toBe(expected);
      if (resource.found !== undefined)
        expect(isSame(JSON.parse(resource.found) as Key), about).toBe(true);
      expect(told.at(-1) ?? resource.status, about).toEqual(resource.status);
    }
  }
});
