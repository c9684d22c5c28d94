import { expect, test } from 'vitest';
import {
  type PageState,
  preparationOf,
  readState,
  resized,
  writeState,
} from '../../../web/app/state/address-state.js';

const whole: PageState = {
  model: 'octopus',
  closed: true,
  weld: 5.6e-17,
  components: [0, 4],
  faces: 5000,
  handles: 0.25,
  unit: 'mm',
  shown: 'in',
  scale: 1.125,
  field: 'sdf',
  time: 0.01,
  energy: 40,
  component: 3,
  colormap: 'turbo',
  range: '5% 95%',
  isolines: 12,
  method: 'refined',
  edges: true,
  section: '-x 40.5%',
  camera: { polar: 1.1868, azimuth: -0.5, distance: 4.5, target: [0, 0.25, -1] },
  loops: [17, { face: 3, weights: [0.125, 0.25, 0.625] }],
  names: ['neck', 'left, leg & 50%'],
  values: ['83.5 mm', '0.1'],
  girth: 0.75,
  diameter: Infinity,
  smoothing: 1,
  tip: 2,
  jump: 0.01,
  tube: 3,
  wall: 0.8,
  printer: 'sla',
  bottleneck: [4, { face: 9, weights: [0.5, 0.25, 0.25] }],
  profile: [{ face: 0, weights: [1, 0, 0] }, 12],
  axis: 1,
  prominence: 0.5,
  cut: 'neck:2',
  rims: true,
  beside: 'chair',
  besideFile: 'left, lower jaw.ply',
  apart: true,
  oneScale: true,
  panel: 'parts',
};

test('a link reproduces everything', () => {
  expect(readState(`#${writeState(whole)}`)).toEqual(whole);
});

test('two fields in one, and values of a file, are fields too', () => {
  for (const field of ['igf-sdf', 'igf/_heat', '_heat']) {
    expect(readState(writeState({ field }))).toEqual({ field });
  }
  expect(readState('field=igf-angle&section=w%205%25')).toEqual({});
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

test('in another size the lengths of a link grow, and what holds for every size stays', () => {
  const { handles, girth, diameter, jump, range, tube, prominence } = resized(whole, 2);
  expect(prominence).toBe(1);
  // Limits of the print check do not grow with the model.
  expect([girth, diameter, jump, range, tube]).toEqual([1.5, Infinity, 0.02, '5% 95%', 3]);
  expect(handles).toBe(0.5);
  expect(resized(whole, 2).weld).toBe(1.12e-16);
  expect(readState('weld=0').weld).toBeUndefined();
  expect(preparationOf({ weld: 0.5 })).toEqual({ weldDistance: 0.5 });
  expect(readState('handles=-1').handles).toBeUndefined();
  expect(resized({ range: '1 2' }, 2)).toEqual({});
  expect(readState('scale=0').scale).toBeUndefined();
  expect(preparationOf({ closed: true, scale: 2 })).toEqual({ closeHoles: true, scale: 2 });
});

test('what is between two points needs both of them', () => {
  expect(readState('bottleneck=3,9').bottleneck).toEqual([3, 9]);
  for (const points of ['3', '3,', '3,x', '', '-1,2', '3,9:0.9:0.9', '3,9,x']) {
    expect(readState(`bottleneck=${points}&profile=${points}`)).toEqual({});
  }
  // A path may lead through more.
  const drawn = { profile: [3, { face: 9, weights: [0.5, 0.25, 0.25] as const }, 12] };
  expect(readState('bottleneck=3,9:0.5:0.25,12&profile=3,9:0.5:0.25,12')).toEqual(drawn);
  expect(readState(writeState(drawn))).toEqual(drawn);
  const long = Array.from({ length: 201 }, (_, i) => i);
  expect(readState(`profile=${long.slice(1).join(',')}`).profile).toHaveLength(200);
  expect(readState(`profile=${long.join(',')}`)).toEqual({});
});

test('what is shown cut is all necks, one loop, the bottleneck, what is pinned, or a value of the girth', () => {
  for (const cut of ['necks', 'bottleneck', 'neck:1', 'handle:12', 'pin', 'at:0.03'] as const) {
    expect(readState(writeState({ cut }))).toEqual({ cut });
  }
  expect(resized({ cut: 'at:0.03' }, 1000)).toEqual({ cut: 'at:30' });
  expect(resized({ cut: 'pin' }, 1000)).toEqual({ cut: 'pin' });
  for (const cut of [
    'neck',
    'neck:0',
    'handle:-1',
    'all',
    'neck:1.5',
    'necks:2',
    'at:',
    'at:0',
    'at:x',
    'at:inf',
  ]) {
    expect(readState(`cut=${cut}&prominence=-1&rims=0`)).toEqual({});
  }
});

test('names of loops keep their order, and whatever cannot be read is no name', () => {
  expect(readState(writeState({ loops: [1, 2, 3], names: ['', 'a,b', ''] })).names).toEqual([
    '',
    'a,b',
    '',
  ]);
  expect(readState('names=a,%25E0%25A4,b%0Ac').names).toEqual(['a', '', 'bc']);
  expect(readState(`names=${'x'.repeat(100)}`).names![0]).toHaveLength(60);
  expect(readState('values=1 mm,<b>,2').values).toEqual(['1 mm', '2']);
  expect(readState('names=,,').names).toBeUndefined();
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
  // Settings beside it still hold.
  expect(readState(`${fragment}&field=sdf`)).toEqual({ field: 'sdf' });
});

test('no link pins a thousand loops', () => {
  const loops = Array.from({ length: 1000 }, (_, i) => i).join(',');
  expect(readState(`loops=${loops}`).loops).toHaveLength(50);
});
