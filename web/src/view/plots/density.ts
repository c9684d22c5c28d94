// Points of the plane counted in a raster, so that a hundred thousand of them are drawn as one image.

import type { Weights } from './distribution.js';

/** An axis of a plot: the values at its two ends, and how they lie between. */
export interface Scale {
  low: number;
  high: number;
  /** Values lie by their logarithms: both ends above 0. */
  log: boolean;
}

/** Where a value lies between the ends: 0 and 1 there. NaN for what a logarithmic axis cannot show. */
export function placeOn({ low, high, log }: Scale, value: number): number {
  if (!log) return (value - low) / (high - low);
  return value > 0 ? Math.log(value / low) / Math.log(high / low) : NaN;
}

/** The value at a place between the ends. */
export function valueAt({ low, high, log }: Scale, place: number): number {
  return log ? low * (high / low) ** place : low + (high - low) * place;
}

/**
 * An axis for the values, with a little room at its ends. On a logarithmic one values that are not
 * above 0 are left out. Undefined where there are none.
 */
export function scaleFor(values: ArrayLike<number>, log: boolean): Scale | undefined {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < values.length; ++i) {
    const value = values[i]!;
    if (!Number.isFinite(value) || (log && value <= 0)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (low > high) return undefined;
  const room = 0.04;
  if (log) {
    const factor = Math.max((high / low) ** room, 1.02);
    return { low: low / factor, high: high * factor, log };
  }
  const margin = Math.max(room * (high - low), 0.02 * Math.abs(high), Number.MIN_VALUE * 2 ** 10);
  return { low: low >= 0 ? Math.max(0, low - margin) : low - margin, high: high + margin, log };
}

/** 1, 2 and 5 times the powers of ten on a logarithmic axis; fewer where they would be crowded. */
export function logTicks({ low, high }: Scale, most: number): number[] {
  for (const steps of [[1, 2, 5], [1, 3], [1]]) {
    const ticks: number[] = [];
    for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power) {
      for (const step of steps) {
        const tick = Number(`${step}e${power}`);
        if (tick >= low && tick <= high) ticks.push(tick);
      }
    }
    if (ticks.length <= most) return ticks;
  }
  const powers = Math.log10(high / low);
  const every = Math.ceil(powers / most);
  const ticks: number[] = [];
  for (let power = Math.ceil(Math.log10(low)); 10 ** power <= high; power += every) {
    ticks.push(Number(`1e${power}`));
  }
  return ticks;
}

/** The weight of points in each cell of a raster; rows from top to bottom. */
export interface Density {
  width: number;
  height: number;
  cells: Float32Array;
  peak: number;
}

/** Points outside of the axes and those with a coordinate that is no number are left out. */
export function density(
  x: ArrayLike<number>,
  y: ArrayLike<number>,
  weights: Weights,
  axes: { x: Scale; y: Scale },
  width: number,
  height: number,
): Density {
  const cells = new Float32Array(width * height);
  let peak = 0;
  for (let i = 0; i < x.length; ++i) {
    const right = placeOn(axes.x, x[i]!);
    const up = placeOn(axes.y, y[i]!);
    if (!(right >= 0 && right <= 1 && up >= 0 && up <= 1)) continue;
    const column = Math.min(width - 1, Math.floor(right * width));
    const row = Math.min(height - 1, Math.floor((1 - up) * height));
    const cell = row * width + column;
    const sum = cells[cell]! + (weights ? weights[i]! : 1);
    cells[cell] = sum;
    if (sum > peak) peak = sum;
  }
  return { width, height, cells, peak };
}

/** The raster as an image of one colour, opaque where most points are; a single point can be seen. */
export function densityImage(
  { cells, peak }: Density,
  [r, g, b]: readonly number[],
): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * cells.length);
  const least = 0.28;
  for (let i = 0; i < cells.length; ++i) {
    if (!(cells[i]! > 0)) continue;
    const share = (cells[i]! / peak) ** 0.35;
    pixels.set([r!, g!, b!, 255 * (least + (1 - least) * share)], 4 * i);
  }
  return pixels;
}
