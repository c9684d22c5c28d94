import { expect, test } from 'vitest';
import {
  nameOf,
  parseRange,
  parseVertices,
  parseSpectral,
} from '../../../web/src/element/attributes/parse.js';

test('a range is two ascending numbers or percentages', () => {
  expect(parseRange('1 2.5')).toEqual({ by: 'values', ends: [1, 2.5] });
  expect(parseRange(' -1e-3,4 ')).toEqual({ by: 'values', ends: [-1e-3, 4] });
  expect(parseRange('5% 95%')).toEqual({ by: 'shares', ends: [0.05, 0.95] });
  expect(parseRange('0% 100%')).toEqual({ by: 'shares', ends: [0, 1] });
  const wrong = [
    'auto',
    '',
    '1',
    '2 1',
    '1 1',
    '1 2 3',
    '1 NaN',
    '5% 3',
    '-1% 5%',
    '5% 101%',
    '% 5%',
  ];
  for (const text of [...wrong, '0 Infinity', null])
    expect(parseRange(text), text ?? '').toBeUndefined();
});

test('vertices are the whole numbers of a list', () => {
  expect(parseVertices('12 4031')).toEqual([12, 4031]);
  expect(parseVertices('hover, 3,x 4.5 -1')).toEqual([3]);
  expect(parseVertices(null)).toEqual([]);
});

test('a source’s name is that of the model in it', () => {
  expect(nameOf('a/b%20c.glb?x=1#y')).toBe('b c.glb');
  const file = (path: string) => ({ path, content: new Blob() });
  expect(nameOf([file('m/tex.png'), file('m/a.gltf')])).toBe('a.gltf');
  expect(nameOf({ positions: new Float32Array(), indices: new Uint32Array() })).toBe('');
});

test('which number of a signature: any number, and nothing for anything else', () => {
  const attributes: Record<string, string> = { time: ' 0.05 ', energy: '40', component: '-2' };
  const of = (attribute: string) => attributes[attribute] ?? null;
  expect(parseSpectral('hks', of)).toEqual({ time: 0.05 });
  expect(parseSpectral('wks', of)).toEqual({ component: 40 });
  // The kernel is to say that there is no such number.
  expect(parseSpectral('sihks', of)).toEqual({ component: -2 });
  expect(parseSpectral('igf', of)).toBeUndefined();
  for (const wrong of ['', ' ', 'soon', 'Infinity', '1e999']) {
    expect(parseSpectral('hks', () => wrong)).toBeUndefined();
  }
  expect(parseSpectral('hks', () => null)).toBeUndefined();
});
