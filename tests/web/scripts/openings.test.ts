// The lint on how comments open.

import { expect, test } from 'vitest';
import { openingsIn } from '../../../web/scripts/openings.mjs';

const linesOf = (path: string, text: string) => openingsIn(path, text).map(({ line }) => line);

test('a comment that opens without its subject is found, in every form of comment', () => {
  const text = [
    '// What is meant.',
    `int a;  //${' '}Of the other one.`,
    '/// Those below.',
    '/** The same, twice. */',
    '/**',
    ' * Who asks.',
    ' */',
    '// And of that, the rest.',
    'int c;',
    '/// That it is so.',
    `int b;  ///<${' '}of the vertices`,
  ];
  expect(linesOf('a.h', text.join('\n'))).toEqual([1, 2, 3, 4, 6, 8, 10, 11]);
  expect(linesOf('a.cmake', '# What is meant.\nset(a b)  # Of it\n')).toEqual([1, 2]);
});

test('a docstring that opens so is found, and what it says of parameters and results', () => {
  const text = [
    'def unit(of: Mesh) -> str:',
    '    """What lengths are in.',
    '',
    '    Parameters',
    '    ----------',
    '    of : Mesh',
    '        Of which the unit is.',
    '',
    '    Returns',
    '    -------',
    '    str',
    '        That of the mesh.',
    '        Of others nothing.',
    '    """',
    '    return of.unit',
  ];
  expect(linesOf('a.py', text.join('\n'))).toEqual([2, 7, 12]);
});

test('a later sentence of a comment that opens so is found, within a line and where a line begins', () => {
  const text = [
    `// The area of a face.${' '}What is left is nothing.`,
    '// The first is read.',
    '// Those beside it are not.',
    `const a = 1; // One of two.${' '}The same as b.`,
    '// All of them, e.g. what is there, count.',
  ];
  expect(linesOf('a.ts', text.join('\n'))).toEqual([1, 3, 4]);
});

test('later lines of a comment, other words and code are left alone', () => {
  const text = [
    '// The area of a face, and of each',
    '// Of its sides nothing.',
    'const What = Of(Those);',
    '// Whatever is there, Offsets included.',
    'say("// What");',
  ];
  expect(linesOf('a.ts', text.join('\n'))).toEqual([]);
});
