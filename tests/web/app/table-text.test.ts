import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { csvOf, plainNumber, tsvOf } from '../../../web/app/widgets/table-text.js';

test('numbers have the digits that they need, and no exponent', () => {
  expect(
    [83.52, 83.52000000000001, 0, -1.5, 1e-9, 123456789012, 0.1 + 0.2].map((value) =>
      plainNumber(value),
    ),
  ).toEqual(['83.52', '83.52', '0', '-1.5', '0.000000001', '123456789012', '0.3']);
  expect(plainNumber(NaN)).toBe('');
  expect([0.00001234, 0.25, 20, 1234].map((value) => plainNumber(value, 2))).toEqual([
    '0.000012',
    '0.25',
    '20',
    '1234',
  ]);
  expect(plainNumber(1.23456e-15)).toBe('0.00000000000000123456');
});

test('cells are separated by tabs, or by commas with quotes', () => {
  const table = [
    ['name', 'girth (mm)'],
    ['left, "leg"', 1.5],
    ['two\nlines\tand a tab', 100],
  ];
  expect(tsvOf(table)).toBe('name\tgirth (mm)\nleft, "leg"\t1.5\ntwo lines and a tab\t100\n');
  expect(csvOf(table)).toBe('name,girth (mm)\n"left, ""leg""",1.5\n"two\nlines\tand a tab",100\n');
});

test('a name from a link is not computed by the spreadsheet; a negative number stays one', () => {
  expect(csvOf([['=1+1', -2]])).toBe("'=1+1,-2\n");
  expect(tsvOf([['@x'], ['-x'], ['+x']])).toBe("'@x\n'-x\n'+x\n");
});

test('numbers for people are those of the command', () => {
  const file = new URL('../../data/numbers.json', import.meta.url);
  const cases = JSON.parse(readFileSync(file, 'utf8')) as { value: number; text: string }[];
  expect(cases.length).toBeGreaterThan(10);
  for (const { value, text } of cases) expect(plainNumber(value, 6)).toBe(text);
});
