import { expect, test } from 'vitest';
import {
  allowedInstead,
  attributeNames,
  attributeOf,
  isOn,
  type AttributeName,
} from '../../../web/src/element/attributes/attributes.js';

const values: Partial<Record<AttributeName, { right: string[]; wrong: string[] }>> = {
  unit: { right: ['mm', 'inch'], wrong: ['furlong', 'MM'] },
  field: {
    right: ['igf', 'kind', 'none', '_HEAT', 'igf-sdf', 'igf/angle', '_HEAT-igf'],
    wrong: ['foo', 'IGF', 'toString', 'igf-angle', 'igf-kind', 'IGF-sdf'],
  },
  colormap: { right: ['viridis', 'rdbu'], wrong: ['rainbow'] },
  range: { right: ['auto', '1 2', '5% 95%'], wrong: ['zz', '2 1', '-1% 5%'] },
  isolines: { right: ['0', '12', '100'], wrong: ['many', '-3', '7.6', '1e9', '101'] },
  persistence: { right: ['0', '0.5', '3 mm', '2%'], wrong: ['-1', '-2%', 'some', '2 parsec', '%'] },
  time: { right: ['0.002', '1e-3'], wrong: ['soon', '0', '-1', '1e999', ' '] },
  energy: { right: ['1', '100'], wrong: ['0', '101', '2.5'] },
  component: { right: ['1', '19'], wrong: ['20', 'x'] },
  loop: {
    right: ['hover', 'none', '12', ' 12, 4031 '],
    wrong: ['click', '1.5', '3 -1', 'hover 3'],
  },
  edges: { right: ['true', 'edges'], wrong: ['false', 'zz'] },
  shading: { right: ['smooth', 'transparent'], wrong: ['gouraud'] },
  pins: {
    right: ['none', '12', ' 12 left leg , 40:0.2:0.3 seat,7', '3 %2C', '3 %312'],
    wrong: ['12 4031', 'waist', '-1', '1.5', '12,', '3:0.9:0.9', '3:1', '3 %', ','],
  },
  tips: {
    right: ['none', 'all', '5mm', '0.05', '#2', '5mm #2'],
    wrong: ['-1', '#0', 'some', '#x'],
  },
  parts: { right: ['0.2 0.05', 'inf 5cm', '1 2 0.1'], wrong: ['1', '1 2 3 4', '1 -2', '1 2 x'] },
  bottleneck: {
    right: ['12, 4031', '7:0.2:0.3,12'],
    wrong: ['12', '12 4031', '1,2,3', '1,x', 'none'],
  },
  profile: { right: ['0,1'], wrong: ['0,-1'] },
  camera: {
    right: ['front', '1.2,0.5,4.5,0,0,0', ' 1.2 -0.5, 4.5 0 0 0 '],
    wrong: ['back', '1,2', '1,2,3,4,5,6,7', '1,2,0,0,0,0', '1,2,x,0,0,0', '1,,3,4,5,6'],
  },
  controls: { right: ['none', 'legend', 'full', 'true'], wrong: ['zz', 'all'] },
  section: {
    right: ['x 40%', ' -z 0.5% ', '0.5,-0.2,1e-1 100%'],
    wrong: [
      'x',
      '40%',
      'x 40',
      'w 40%',
      'x 101%',
      'x -1%',
      '0,0,0 5%',
      '1,2 5%',
      '1,2,x 5%',
      'x %',
    ],
  },
  up: { right: ['-z'], wrong: ['up', '+z'] },
};

/** As much of an element as is looked at. */
const elementWith = (value: string | null) => ({ getAttribute: () => value }) as unknown as Element;

test.each(Object.entries(values))('%s: what is allowed, and what is not', (key, lists) => {
  const name = key as AttributeName;
  const isFlag = name === 'edges';
  for (const text of lists.right) {
    expect(allowedInstead(name, text), text).toBeUndefined();
    expect(attributeOf(elementWith(text), name)).toBe(text);
    expect(isOn(elementWith(text), name)).toBe(true);
  }
  for (const text of lists.wrong) {
    expect(allowedInstead(name, text), text).toMatch(isFlag ? /leave it out/ : /\w/);
    expect(attributeOf(elementWith(text), name)).toBeNull();
    expect(isOn(elementWith(text), name)).toBe(false);
  }
});

test.each(attributeNames)('%s: empty is not wrong', (name) => {
  expect(allowedInstead(name, '')).toBeUndefined();
  expect(attributeOf(elementWith(''), name)).toBeNull();
  expect(isOn(elementWith(''), name)).toBe(true);
  expect(isOn(elementWith(null), name)).toBe(false);
});
