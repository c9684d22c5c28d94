// Colour maps for scalar fields, as tables of sRGB bytes.

import type { ColormapName } from './colormap-names.js';
import { colormapChannels } from './colormap-tables.js';

/** Entries of a colour table. */
export const colormapSize = 256;

/** The letter that stands for no step. */
const level = 'm'.charCodeAt(0);

const tables = new Map<ColormapName, Uint8Array>();

/** `colormapSize` colours as r, g, b, a bytes (a = 255), lowest value first. Do not modify. */
export function colormapTable(name: ColormapName): Uint8Array {
  let table = tables.get(name);
  if (!table) {
    table = new Uint8Array(4 * colormapSize);
    table.fill(255);
    for (const [k, [first, steps]] of colormapChannels[name].entries()) {
      table[k] = first;
      for (let i = 1; i < colormapSize; ++i) {
        table[4 * i + k] = table[4 * (i - 1) + k]! + steps.charCodeAt(i - 1) - level;
      }
    }
    tables.set(name, table);
  }
  return table;
}

/** The CSS colour at a fraction of the map; fractions outside [0, 1] take the nearest end. */
export function colourAt(name: ColormapName, fraction: number): string {
  const clamped = Math.min(1, Math.max(0, Number.isNaN(fraction) ? 0 : fraction));
  const i = 4 * Math.round(clamped * (colormapSize - 1));
  const table = colormapTable(name);
  return `rgb(${table[i]} ${table[i + 1]} ${table[i + 2]})`;
}

/** The whole map as evenly spaced stops of a CSS gradient, lowest value first. */
export function colormapStops(name: ColormapName): string {
  const stops = 32;
  return Array.from({ length: stops + 1 }, (_, i) => colourAt(name, i / stops)).join(', ');
}
