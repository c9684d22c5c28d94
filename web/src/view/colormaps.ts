// Colour maps for scalar fields, as tables of sRGB bytes.

import {
  interpolateCividis,
  interpolateMagma,
  interpolatePlasma,
  interpolateRdBu,
  interpolateTurbo,
  interpolateViridis,
} from 'd3-scale-chromatic';
import type { ColormapName } from './colormap-names.js';

/** Entries of a colour table. */
export const colormapSize = 256;

const interpolators: Record<ColormapName, (place: number) => string> = {
  viridis: interpolateViridis,
  cividis: interpolateCividis,
  plasma: interpolatePlasma,
  magma: interpolateMagma,
  turbo: interpolateTurbo,
  // Blue below the middle, red above.
  rdbu: (place) => interpolateRdBu(1 - place),
};

/** sRGB bytes of a CSS colour as d3 writes it: `#rrggbb` or `rgb(r, g, b)`. */
function parseColour(css: string): [number, number, number] {
  if (css.startsWith('#')) {
    const code = Number.parseInt(css.slice(1), 16);
    return [code >> 16, (code >> 8) & 255, code & 255];
  }
  const [r = 0, g = 0, b = 0] = (css.match(/\d+/g) ?? []).map(Number);
  return [r, g, b];
}

const tables = new Map<ColormapName, Uint8Array>();

/** `colormapSize` colours as r, g, b, a bytes (a = 255), lowest value first. Do not modify. */
export function colormapTable(name: ColormapName): Uint8Array {
  let table = tables.get(name);
  if (!table) {
    table = new Uint8Array(4 * colormapSize);
    for (let i = 0; i < colormapSize; ++i) {
      table.set([...parseColour(interpolators[name](i / (colormapSize - 1))), 255], 4 * i);
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
