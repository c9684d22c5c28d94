// Scripts that run in a fresh clone, before anything is installed, need nothing but Node.js.

import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { expect, test } from 'vitest';
import { repository } from '../../../web/scripts/run.mjs';

/** The packages that a script imports as it starts, itself or by another script. */
function packagesOf(script: string, seen = new Set<string>()): string[] {
  if (seen.has(script)) return [];
  seen.add(script);
  const text = readFileSync(script, 'utf8');
  return [...text.matchAll(/^(?:import|export)\s(?:[^;]*?from\s+)?'([^']+)';/gms)].flatMap(
    ([, name = '']) => {
      if (name.startsWith('node:')) return [];
      if (name.startsWith('.')) return packagesOf(join(dirname(script), name), seen);
      return [`${script.slice(repository.length)}: ${name}`];
    },
  );
}

test.each(['start', 'test', 'setup', 'build', 'lint', 'test-parts', 'test-repeat', 'version'])(
  '%s.mjs',
  (name) => {
    expect(packagesOf(join(repository, `web/scripts/${name}.mjs`))).toEqual([]);
  },
);
