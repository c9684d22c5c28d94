// Files that are made of the tables in C++, and defaults that documents state.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { repository } from '../../../web/scripts/run.mjs';
import { membersOf } from '../../../web/scripts/headers.mjs';
import { results } from '../../../web/scripts/results.mjs';
import { defaultOf, tables } from '../../../web/scripts/tables.mjs';

const read = (path: string) => readFileSync(join(repository, path), 'utf8');

describe('tables', () => {
  test('files are those that `npm run build:tables` makes', async () => {
    for (const [path, text] of Object.entries(await tables())) {
      expect(read(path) === text, `${path} is stale: npm run build:tables`).toBe(true);
    }
  });

  test('a member of a result that is not described is named, with where it is listed', () => {
    const area = 'member("area", &CurveSide::area)';
    const volume = 'member("volume", &CurveSide::volume)';
    const listed = (body: string) => membersOf('CurveSide', body, 'describe/cut_surface.h');
    expect(listed(`${area}, ${volume}`).map(({ name }) => name)).toEqual(['area', 'volume']);
    expect(() => listed(area)).toThrow(
      'CurveSide::volume is not described: list it in describe/cut_surface.h',
    );
    expect(() => listed(`${area}, ${volume}, member("mass", &CurveSide::mass)`)).toThrow(
      'describe/cut_surface.h: CurveSide has no member mass',
    );
  });

  test('numbers of results have their unit in their comments', () => {
    const unit = /\b(model units|radians|shares?|scale of the shape|its unit|field's unit)\b/;
    const without = results().flatMap(({ name, members }) =>
      members
        .filter(({ type, comment }) => type === 'double' && !unit.test(comment))
        .map((member) => `${name}.${member.name}`),
    );
    expect(without).toEqual([]);
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
