// Numbers at the axes of plots: as lengths are written, without the zeros that make them all as long.

import { type LengthFormat, formatNumber } from '../../src/element/index.js';

export const axisNumber = (value: number, format: LengthFormat): string =>
  String(Number(formatNumber(value, format).replace('\u2212', '-')));
