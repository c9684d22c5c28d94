// Running other programs from the top of the repository.

import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

/** The top of the repository. */
export const repository = fileURLToPath(new URL('../..', import.meta.url));

/** Something that the user can understand and mend; shown without a stack. */
export class Complaint extends Error {}

/**
 * Runs a program, its output going where ours goes.
 * @param {string} program
 * @param {string[]} args
 * @param {{ env?: NodeJS.ProcessEnv, quiet?: boolean }} [options] quiet: output only where it fails
 */
export function run(program, args, { env = process.env, quiet = false } = {}) {
  const result = spawnSync(program, args, {
    cwd: repository,
    env,
    encoding: 'utf8',
    stdio: quiet ? 'pipe' : 'inherit',
    maxBuffer: 1 << 28,
  });
  if (result.error) throw new Complaint(`${program}: ${result.error.message}`);
  if (result.status !== 0) {
    if (quiet) process.stderr.write(result.stdout + result.stderr);
    throw new Complaint(`${[program, ...args].join(' ')}: failed`);
  }
}

/**
 * Runs a program of an npm package.
 * @param {string} name
 * @param {string[]} args
 * @param {{ env?: NodeJS.ProcessEnv, quiet?: boolean }} [options]
 */
export function runTool(name, args, options = {}) {
  run(`${repository}/node_modules/.bin/${name}`, args, options);
}

/**
 * The output of a program, or nothing where it cannot be run.
 * @param {string} program
 * @param {string[]} args
 */
export function outputOf(program, args) {
  const result = spawnSync(program, args, { cwd: repository, encoding: 'utf8' });
  return result.status === 0 ? result.stdout : undefined;
}

/**
 * The main program of a script: a complaint is shown in one line, and the exit code is 1.
 * @param {() => void | Promise<void>} main
 */
export async function script(main) {
  try {
    await main();
  } catch (error) {
    if (!(error instanceof Complaint)) throw error;
    console.error(`girth: ${error.message}`);
    process.exitCode = 1;
  }
}
