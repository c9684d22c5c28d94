import {
  interpolateCividis,
  interpolateMagma,
  interpolatePlasma,
  interpolateRdBu,
  interpolateTurbo,
  interpolateViridis,
} from 'd3-scale-chromatic';
import { expect, test } from 'vitest';
import { colormapNames, isColormapName } from '../../../web/src/view/colormap-names.js';
import { colormapSize, colormapTable, colourAt } from '../../../web/src/view/colormaps.js';

test('viridis is the first and ends in its known colours', () => {
  expect(colormapNames[0]).toBe('viridis');
  expect(colourAt('viridis', 0)).toBe('rgb(68 1 84)');
  expect(colourAt('viridis', 1)).toBe('rgb(253 231 37)');
});

test('every map is a full table of opaque colours', () => {
  for (const name of colormapNames) {
    const table = colormapTable(name);
    expect(table).toHaveLength(4 * colormapSize);
    for (let i = 3; i < table.length; i += 4) expect(table[i]).toBe(255);
    expect(new Set([table[0], table[4 * 128], table[4 * 255]]).size, name).toBeGreaterThan(1);
  }
});

test('every colour is that of d3-scale-chromatic', () => {
  const theirs = {
    viridis: interpolateViridis,
    cividis: interpolateCividis,
    plasma: interpolatePlasma,
    magma: interpolateMagma,
    turbo: interpolateTurbo,
    // Blue below the middle, red above.
    rdbu: (place: number) => interpolateRdBu(1 - place),
  };
  for (const name of colormapNames) {
    for (let i = 0; i < colormapSize; ++i) {
      const css = theirs[name](i / (colormapSize - 1));
      const [r, g, b] = css.startsWith('#')
        ? [1, 3, 5].map((at) => Number.parseInt(css.slice(at, at + 2), 16))
        : css.match(/\d+/g)!.map(Number);
      expect(colourAt(name, i / (colormapSize - 1)), `${name} ${i}`).toBe(`rgb(${r} ${g} ${b})`);
    }
  }
});

test('values outside of the map take its ends', () => {
  expect(colourAt('magma', -3)).toBe(colourAt('magma', 0));
  expect(colourAt('magma', 7)).toBe(colourAt('magma', 1));
  expect(colourAt('magma', NaN)).toBe(colourAt('magma', 0));
});

test('only names of the list are names', () => {
  expect(isColormapName('turbo')).toBe(true);
  for (const wrong of ['', 'rainbow', 'toString', null, undefined]) {
    expect(isColormapName(wrong)).toBe(false);
  }
});

test('the diverging map is blue below its light middle and red above', () => {
  const at = (place: number) => (colourAt('rdbu', place).match(/\d+/g) ?? []).map(Number);
  const [low, middle, high] = [at(0.1), at(0.5), at(0.9)];
  expect(low[2]).toBeGreaterThan(low[0]! + 50);
  expect(high[0]).toBeGreaterThan(high[2]! + 50);
  for (const channel of middle) expect(channel).toBeGreaterThan(230);
});
