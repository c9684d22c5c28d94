// The public C++ headers: what girth.h includes, and what shared libraries show of them.

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
  expect(included('girth.h')).toEqual(core.sort());
  const studies = headers('study').filter((name) => name !== 'study/study.h');
  expect(included('study/study.h')).toEqual(studies.sort());
});

/** A declaration at the top level of a header that shared libraries would hide, where users need it. */
function hidden(header: string, content = text(header)): string[] {
  const code = content.replace(/\/\/.*|^#.*(\\\n.*)*/gm, '').replace(/^\}?\s*namespace .*$/gm, '');
  const found: string[] = [];
  // Top-level declarations begin in the first column and end with a semicolon or a body.
  for (const [declaration] of code.matchAll(
    /^(?:(?:struct|class) [^;{]*\{[^]*?^\};|[A-Za-z[][^;{]*\{$[^]*?^\}|[A-Za-z[][^]*?;\s*?$)/gm,
  )) {
    const [head = ''] = declaration.split('\n');
    if (
      /GIRTH_EXPORT|^(template|inline|constexpr|using|enum|static_assert)\b|= delete;\s*$/.test(
        declaration,
      )
    )
      continue;
    const isClass = /^(struct|class) /.test(head);
    const members = /^ {2}[^ ;{}=][^;{}]*\)( const)?( noexcept)?( override)?;$/m;
    const isStored = /^ {2}std::function<[^;]*> \w+(\{\})?;$/gm;
    if (isClass ? members.test(declaration.replace(isStored, '')) : declaration.includes('('))
      found.push(`${header}: ${head}`);
  }
  return found;
}

test('what is not defined in a header is marked with GIRTH_EXPORT', () => {
  expect(
    [...headers(), ...headers('io'), ...headers('study')].flatMap((header) => hidden(header)),
  ).toEqual([]);
});

test.each(['tips.h', 'surface_mesh.h', 'girth_solver.h', 'io/read_mesh.h', 'study/measures.h'])(
  'what is not marked is found in %s',
  (header) => {
    const marks = text(header).match(/GIRTH_EXPORT /g)!.length;
    expect(hidden(header, text(header).replaceAll('GIRTH_EXPORT ', ''))).toHaveLength(marks);
  },
);
