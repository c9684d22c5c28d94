// `npm run test:long`: the tests of the core that take the better part of an hour, on all cores: random
// surfaces by the thousand, values proven on real models (GIRTH_DATA names their folder), exact against
// naive. `npm run test:long -- 'RandomMeshes/*/1017'` runs those that match.

import { spawn } from 'node:child_process';
import { availableParallelism } from 'node:os';
import { buildNative } from './build.mjs';
import { Complaint, repository, script } from './run.mjs';
import { setUp } from './setup.mjs';

/**
 * One share of the tests; true if they pass.
 * @param {string[]} args
 * @param {number} index
 * @param {number} count
 * @returns {Promise<boolean>}
 */
function share(args, index, count) {
  const env = { ...process.env, GTEST_TOTAL_SHARDS: `${count}`, GTEST_SHARD_INDEX: `${index}` };
  return new Promise((done, fail) => {
    const child = spawn('build/native/tests/cpp/long_tests', args, {
      cwd: repository,
      env,
      stdio: 'inherit',
    });
    child.on('error', fail);
    child.on('close', (code) => done(code === 0));
  });
}

await script(async () => {
  setUp();
  buildNative(['long_tests']);
  const filter = process.argv.slice(2).join(':');
  const args = ['--gtest_brief=1', ...(filter ? [`--gtest_filter=${filter}`] : [])];
  const count = availableParallelism();
  const passed = await Promise.all(Array.from({ length: count }, (_, i) => share(args, i, count)));
  if (passed.includes(false)) throw new Complaint('test:long: failed');
});
