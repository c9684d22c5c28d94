import { expect, test } from 'vitest';
import { formatArea } from '../../../web/app/widgets/area-words.js';

test.each([
  [20.5, { unit: 'mm', scale: 1, decimals: 2 }, '20.5\u202fmm²'],
  [2.5e-5, { unit: 'mm', scale: 1000, decimals: 2 }, '25.0\u202fmm²'],
  [0.5, { unit: 'm', scale: 1, decimals: 2 }, '0.500\u202fm²'],
  [0.0123, { unit: 'm', scale: 1, decimals: 2 }, '123\u202fcm²'],
  [0.0000123, { unit: 'm', scale: 1, decimals: 2 }, '12.3\u202fmm²'],
  [0, { unit: '', scale: 1, decimals: 2 }, '0.00'],
  [1.5e-9, { unit: '', scale: 1, decimals: 2 }, '0.00000000150'],
  [12345678, { unit: '', scale: 1, decimals: 2 }, '12,300,000'],
  [0.0391, { unit: 'm', scale: 1, decimals: 2 }, '391\u202fcm²'],
  [39_100, { unit: 'mm', scale: 1, decimals: 2 }, '391\u202fcm²'],
  [2.5e22, { unit: '', scale: 1, decimals: 2 }, '25,000,000,000,000,000,000,000'],
  [999.6, { unit: '', scale: 1, decimals: 2 }, '1,000'],
  [3e6, { unit: 'm', scale: 1, decimals: 2 }, '3.00\u202fkm²'],
  [200_000, { unit: 'in', scale: 1, decimals: 2 }, '1,390\u202fft²'],
])('%s %o is %s', (area, format, words) => {
  expect(formatArea(area, format)).toBe(words);
});
