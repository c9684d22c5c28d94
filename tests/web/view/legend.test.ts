import { expect, test } from 'vitest';
import { girthKinds, partKinds } from '../../../web/src/view/categories.js';
import {
  derivedNames,
  fieldNames,
  fieldTitle,
  fieldUnit,
  isFieldName,
  isShownName,
} from '../../../web/src/view/field-words.js';
import { type ScaleContent, headingOf, linePlaces, ticksOf } from '../../../web/src/view/legend.js';
import { lengthFormat } from '../../../web/src/view/numbers.js';
import { segmentsOf } from '../../../web/src/view/tip-marks.js';

const content: ScaleContent = {
  title: 'Girth',
  colormap: 'viridis',
  range: [0, 4],
  extent: [0, 4],
  format: lengthFormat(4, 'mm'),
  log: false,
  isolines: 3,
  note: '',
  beyond: undefined,
};

test('a scale has its ends and round numbers between, the highest first', () => {
  expect(headingOf(content)).toBe('Girth, mm');
  const ticks = ticksOf(content);
  expect(ticks[0]).toEqual({ place: 1, text: '4.000', inner: false });
  expect(ticks.at(-1)).toEqual({ place: 0, text: '0.000', inner: false });
  expect(ticks.slice(1, -1).map(({ text }) => text)).toEqual(['3.000', '2.000', '1.000']);
});

test('an end says where there is more beyond it', () => {
  const [high, low] = [ticksOf({ ...content, extent: [-1, 9] })].flatMap((t) => [t[0]!, t.at(-1)!]);
  expect(high!.text).toBe('≥\u20094.000');
  expect(low!.text).toBe('≤\u20090.000');
});

test('angles are ticked where they mean something, factors evenly in a logarithmic map', () => {
  const angle = {
    ...content,
    range: [0, Math.PI],
    extent: [0, Math.PI],
    format: lengthFormat(3, 'rad'),
  } as const;
  expect(ticksOf(angle).map(({ text }) => text)).toEqual(['180.0', '120.0', '60.0', '0.0']);
  expect(ticksOf(angle)[1]!.place).toBeCloseTo(2 / 3, 12);
  const log = { ...content, range: [1, 100], log: true } as const;
  const ten = ticksOf(log).find(({ text }) => text.startsWith('10.'));
  expect(ten!.place).toBeCloseTo(0.5, 12);
});

test('lines of equal value lie evenly between the ends', () => {
  expect(linePlaces(3)).toEqual([0.25, 0.5, 0.75]);
  expect(linePlaces(0)).toEqual([]);
});

test('every field has a name in words and a unit', () => {
  for (const name of [...fieldNames, ...derivedNames]) {
    expect(isShownName(name)).toBe(true);
    expect(fieldTitle(name)).not.toBe('');
  }
  expect(fieldUnit('sdf', 'mm')).toBe('mm');
  expect(fieldUnit('angle', 'mm')).toBe('rad');
  expect(fieldUnit('kind', 'mm')).toBe('');
  expect(fieldUnit('hks', 'mm')).toBe('1/mm²');
  expect(fieldUnit('hks', '')).toBe('');
  expect(isFieldName('tips')).toBe(false);
  for (const wrong of ['toString', '', null]) expect(isShownName(wrong)).toBe(false);
});

test('categories are distinguished by lightness or by stripes, and by their names', () => {
  const lightness = (colour: string): number => {
    const [r, g, b] = [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16) / 255);
    return 0.2126 * r! ** 2.2 + 0.7152 * g! ** 2.2 + 0.0722 * b! ** 2.2;
  };
  for (const kinds of [girthKinds, partKinds]) {
    expect(new Set(kinds.map(({ name }) => name)).size).toBe(kinds.length);
    const plain = kinds.filter(({ hatched }) => !hatched).map(({ colour }) => lightness(colour));
    plain.sort((a, b) => a - b);
    for (let i = 1; i < plain.length; ++i) expect(plain[i]! / plain[i - 1]!).toBeGreaterThan(1.3);
  }
});

test('lines are drawn piece by piece, closed ones back to their beginning', () => {
  const polyline = Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0);
  expect([...segmentsOf([{ closed: false, polyline }])]).toEqual([
    0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0,
  ]);
  const closed = segmentsOf([{ closed: true, polyline }]);
  expect([...closed.subarray(12)]).toEqual([1, 1, 0, 0, 0, 0]);
  expect(segmentsOf([{ closed: false, polyline: new Float32Array() }])).toHaveLength(0);
});
