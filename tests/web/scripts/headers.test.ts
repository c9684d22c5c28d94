// The public C++ headers that girth.h and study.h include.

import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { repository } from '../../../web/scripts/run.mjs';

const folder = join(repository, 'cpp/include/girth');
const headers = (below = '') =>
  readdirSync(join(folder, below))
    .filter((name) => name.endsWith('.h'))
    .map((name) => join(below, name));
const text = (header: string) => readFileSync(join(folder, header), 'utf8');
const included = (header: string) =>
  [...text(header).matchAll(/^#include "girth\/([^"]+)"/gm)].map(([, name]) => name!);

test('girth.h includes all of the core, study.h all of the studies', () => {
  const core = headers().filter((name) => name !== 'girth.h');
  // Headers of fields and of analyses are included by their tables.
  const analyses = included('analyses.def').map((name) => name.replace('describe/', ''));
  const all = [...included('girth.h'), ...included('fields.def'), ...analyses];
  expect(all.filter((name) => name.endsWith('.h')).sort()).toEqual(core.sort());
  const studies = headers('study').filter((name) => name !== 'study/study.h');
  expect(included('study/study.h')).toEqual(studies.sort());
});

test("the front page of the reference names all of the core's headers", () => {
  const page = readFileSync(join(repository, 'web/docs/reference/pages.dox'), 'utf8');
  const missing = headers()
    .filter((name) => name !== 'girth.h')
    .filter((name) => !new RegExp(`(?<![\\w/])${name}`).test(page));
  expect(missing).toEqual([]);
});
