// The built-in examples with few faces: most tests need a model, not a large one.

import { execFileSync } from 'node:child_process';
import { cpSync, readdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { command, repository, requireBuilt } from './support.js';

/** Enough for legs, arms and holes. */
const faces = 1200;

/** Where they lie, by the names of the real ones. */
export const smallExamples = join(repository, 'build/small-examples');

/** Makes them of the real ones, by the command, before the first test. */
export function setup(): void {
  const real = join(repository, 'web/app/public/examples');
  requireBuilt('web/app/public/examples/index.json', 'build:examples');
  rmSync(smallExamples, { recursive: true, force: true });
  cpSync(real, smallExamples, { recursive: true });
  for (const name of readdirSync(real).filter((name) => name.endsWith('.glb'))) {
    execFileSync(command, [
      ...['remesh', join(real, name), '--faces', `${faces}`],
      ...['-o', join(smallExamples, name)],
    ]);
  }
}
