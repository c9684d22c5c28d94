// Files that are made of the tables in C++, and defaults that documents state.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { repository } from '../../../web/scripts/run.mjs';
import { defaultOf, tables } from '../../../web/scripts/tables.mjs';

const read = (path: string) => readFileSync(join(repository, path), 'utf8');

describe('tables', () => {
  test('files are those that `npm run build:tables` makes', async () => {
    for (const [path, text] of Object.entries(await tables())) {
      expect(read(path) === text, `${path} is stale: npm run build:tables`).toBe(true);
    }
  });

  /** Interfaces of types.ts, their members, and the structs of C++ that have the defaults. */
  test.each([
    ['SpectralOptions', 'pairs', 'SpectrumOptions', 'pairs'],
    ['RefinedOptions', 'coarseFaces', 'RefinedOptions', 'coarseFaces'],
    ['RefinedOptions', 'audit', 'RefinedOptions', 'audit'],
    ['RefinedOptions', 'seed', 'RefinedOptions', 'seed'],
    ['HandleOptions', 'basePoints', 'HandleOptions', 'basePoints'],
    ['LimbOptions', 'stations', 'LimbOptions', 'stations'],
    ['ProfileOptions', 'samples', 'PathProfileOptions', 'samples'],
    ['NeckOptions', 'minProminence', 'NeckOptions', 'minProminence'],
    ['PartOptions', 'smoothing', 'PartOptions', 'smoothing'],
  ])('%s.%s has the default of C++', (type, member, struct, ofStruct) => {
    const body = new RegExp(`export interface ${type}\\b[^]*?\\n}`).exec(
      read('web/src/kernel/types/types.ts'),
    )?.[0];
    const comment = new RegExp(`/\\*\\*((?:(?!\\*/)[^])*)\\*/\\s*${member}\\?:`).exec(body ?? '');
    const stated = /Default: ([\d.,]+?)[.,]?(?:\s|$)/.exec(comment?.[1] ?? '')?.[1];
    expect(stated?.replaceAll(',', '')).toBe(defaultOf(struct, ofStruct));
  });
});
