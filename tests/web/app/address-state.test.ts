import { expect, test } from 'vitest';
import { type PageState, readState, writeState } from '../../../web/app/address-state.js';

const whole: PageState = {
  model: 'octopus',
  closed: true,
  components: [0, 4],
  faces: 5000,
  unit: 'mm',
  field: 'sdf',
  time: 0.01,
  energy: 40,
  component: 3,
  colormap: 'turbo',
  range: '5% 95%',
  isolines: 12,
  edges: true,
  camera: { polar: 1.1868, azimuth: -0.5, distance: 4.5, target: [0, 0.25, -1] },
  loops: [17, { face: 3, weights: [0.125, 0.25, 0.625] }],
  girth: 0.75,
  diameter: Infinity,
  smoothing: 1,
  tip: 2,
  jump: 0.01,
  panel: 'parts',
};

test('a link reproduces everything', () => {
  expect(readState(`#${writeState(whole)}`)).toEqual(whole);
});

test('the address of a model and a file’s name survive, whatever letters they have', () => {
  for (const state of [
    { model: 'https://example.org/a model.glb?x=1&y=2' },
    { file: 'Röhre & 50% = #1+2.obj' },
  ]) {
    const read = readState(writeState(state));
    expect(read.model && new URL(read.model).href).toBe(state.model && new URL(state.model).href);
    expect(read.file).toBe(state.file);
  }
});

test('written, it can be read by people', () => {
  expect(writeState({ model: 'chair', field: 'igf', loops: [12, 40] })).toBe(
    'model=chair&field=igf&loops=12,40',
  );
  expect(writeState({})).toBe('');
  expect(writeState({ closed: false, loops: [] })).toBe('');
});

test.each([
  'nonsense',
  'model=javascript:alert(1)',
  'model=data:text/plain,hello',
  'model=../secret.glb',
  'model=%E0%A4%A',
  'range=2 1',
  'range=5% 1',
  'range=-5% 50%',
  'range=a b',
  'camera=1,2,3',
  'camera=1,2,0,0,0,0',
  'camera=1,2,NaN,0,0,0',
  'loops=x',
  'loops=3:2:2',
  'loops=3:0.5',
  'loops=-1',
  'girth=-1',
  'girth=NaN',
  'smoothing=1e999',
  'panel=__proto__',
  '__proto__=1',
  'constructor=1',
  'tip=1.5',
  'isolines=',
  'closed=yes',
  'field=<b>',
  '=&==&&',
])('what is not understood is left out: %s', (fragment) => {
  expect(readState(fragment)).toEqual({});
  // What stands beside it still holds.
  expect(readState(`${fragment}&field=sdf`)).toEqual({ field: 'sdf' });
});

test('no link pins a thousand loops', () => {
  const loops = Array.from({ length: 1000 }, (_, i) => i).join(',');
  expect(readState(`loops=${loops}`).loops).toHaveLength(50);
});
