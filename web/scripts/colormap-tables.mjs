// Writes the colour maps of d3-scale-chromatic as tables: `npm run build:colours`. Code that makes them of formulas and
// splines takes five times the bytes, of each page that shows a figure.

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import {
  interpolateCividis,
  interpolateMagma,
  interpolatePlasma,
  interpolateRdBu,
  interpolateTurbo,
  interpolateViridis,
} from 'd3-scale-chromatic';
import { format } from 'oxfmt';
import { repository } from './run.mjs';

/** Blue of `rdbu` lies below the middle, red above. */
const maps = {
  viridis: interpolateViridis,
  cividis: interpolateCividis,
  plasma: interpolatePlasma,
  magma: interpolateMagma,
  turbo: interpolateTurbo,
  rdbu: (/** @type {number} */ place) => interpolateRdBu(1 - place),
};
const size = 256;

/**
 * sRGB bytes of a colour as d3 writes it: `#rrggbb` or `rgb(r, g, b)`.
 * @param {string} css
 */
const bytesOf = (css) =>
  css.startsWith('#')
    ? [1, 3, 5].map((at) => Number.parseInt(css.slice(at, at + 2), 16))
    : (css.match(/\d+/g) ?? []).map(Number);

const entries = Object.entries(maps).map(([name, colourAt]) => {
  const colours = Array.from({ length: size }, (_, i) => bytesOf(colourAt(i / (size - 1))));
  const channels = [0, 1, 2].map((k) => {
    const values = colours.map((colour) => colour[k] ?? 0);
    const steps = values.slice(1).map((value, i) => value - (values[i] ?? 0));
    if (steps.some((step) => Math.abs(step) > 16)) throw new Error(`${name}: a step is too large`);
    const letters = steps.map((step) => String.fromCharCode(109 + step)).join('');
    return `    [${values[0]}, '${letters}'],`;
  });
  return `  ${name}: [\n${channels.join('\n')}\n  ],`;
});

const text = `// Colour maps of d3-scale-chromatic, whose licence holds for them: made by web/scripts/colormap-tables.mjs.

import type { ColormapName } from './colormap-names.js';

/** The first value of a channel, and a sign for each step to the next: m for none, n for one more, l for one less. */
type Channel = readonly [first: number, steps: string];

/** Red, green and blue of 256 colours, lowest value first. */
export const colormapChannels: Record<ColormapName, readonly [Channel, Channel, Channel]> = {
${entries.join('\n')}
};
`;
const style = /** @type {const} */ ({ singleQuote: true, printWidth: 100 });
const { code } = await format('colormap-tables.ts', text, style);
writeFileSync(join(repository, 'web/src/view/colormap-tables.ts'), code);
