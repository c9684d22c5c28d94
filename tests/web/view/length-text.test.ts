// Lengths as people type them: the cases that the command's parser is held to as well.

import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { readLength, readLengthOrShare } from '../../../web/src/view/length-text.js';

interface Case {
  text: string;
  unit: string;
  length?: number;
  fault?: string;
}

const cases = JSON.parse(
  readFileSync(new URL('../../data/lengths.json', import.meta.url), 'utf8'),
) as Case[];

test.each(cases)('"$text" where lengths are in "$unit"', ({ text, unit, length, fault }) => {
  const read = readLength(text, unit);
  if (fault === undefined) expect(read).toEqual({ length });
  else expect('fault' in read && read.fault).toContain(fault);
});

const shares = JSON.parse(
  readFileSync(new URL('../../data/shares.json', import.meta.url), 'utf8'),
) as (Omit<Case, 'unit'> & { whole: number })[];

test.each(shares)('"$text" of $whole mm', ({ text, whole, length, fault }) => {
  const read = readLengthOrShare(text, 'mm', whole);
  if (fault === undefined) expect(read).toEqual({ length });
  else expect('fault' in read && read.fault).toContain(fault);
});
