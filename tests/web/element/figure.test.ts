// Content of a figure beside the surface.

import { expect, test } from 'vitest';
import { withDensity } from '../../../web/src/element/figure/png-density.js';
import {
  isTransparent,
  scaleBarLength,
  scaleBarWords,
  sizeOf,
} from '../../../web/src/element/figure/snapshot.js';
import { crcOf } from '../../../web/src/kernel/unpack/crc.js';
import { formatLength, lengthFormat } from '../../../web/src/view/numbers.js';

test('a scale bar is the greatest round length that fits, in the unit that is written', () => {
  const metres = lengthFormat(3, 'm');
  expect(scaleBarLength(160, 100, metres)).toBe(1);
  expect(scaleBarLength(160, 70, metres)).toBe(2);
  expect(scaleBarLength(160, 20, metres)).toBe(5);
  // 160 pixels are 16 mm, and written in millimetres.
  expect(scaleBarLength(160, 10_000, lengthFormat(0.05, 'm'))).toBeCloseTo(0.01, 12);
});

test('a width on paper is one in pixels at a density, 300 where none is asked for', () => {
  expect(sizeOf({ millimetres: 85 })).toEqual({ width: 1004, dotsPerInch: 300 });
  expect(sizeOf({ millimetres: 25.4, dotsPerInch: 600 })).toEqual({ width: 600, dotsPerInch: 600 });
  expect(sizeOf({ width: 500 })).toEqual({ width: 500, dotsPerInch: undefined });
});

test('a PNG states its density in pixels for each metre', async () => {
  const head = new Uint8Array(33).fill(7);
  const made = await withDensity(new Blob([head, Uint8Array.of(9, 9)]), 300);
  const bytes = new Uint8Array(await made.arrayBuffer());
  const numbers = new DataView(bytes.buffer);
  expect(bytes.length).toBe(33 + 21 + 2);
  expect(numbers.getUint32(33)).toBe(9);
  expect(String.fromCharCode(...bytes.subarray(37, 41))).toBe('pHYs');
  expect([numbers.getUint32(41), numbers.getUint32(45), bytes[49]]).toEqual([11811, 11811, 1]);
  expect(numbers.getUint32(50)).toBe(crcOf(bytes.subarray(37, 50)));
  expect([...bytes.subarray(54)]).toEqual([9, 9]);
});

test('the checksum is that of the specification', () => {
  expect(crcOf(new TextEncoder().encode('123456789'))).toBe(0xcbf43926);
});

test('a scale bar says whose unit it has', () => {
  const words = (length: number, unit: string) =>
    scaleBarWords(length, lengthFormat(1, unit), formatLength).replace(/\s/g, ' ');
  expect(words(0.5, 'm')).toBe('0.5 m');
  expect(words(1, '')).toBe('1 unit of the file');
  expect(words(0.2, '')).toBe('0.2 units of the file');
});

test('a picture is transparent where that is chosen, or where it has no legend', () => {
  expect(isTransparent({})).toBe(true);
  expect(isTransparent({ legend: true })).toBe(false);
  expect(isTransparent({ legend: true, transparent: true })).toBe(true);
});
