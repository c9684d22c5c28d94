// Points of a surface, and from where it is seen, as words of attributes and addresses.

import type { SurfacePoint } from '../../kernel/types/types.js';
import type { CameraView } from '../../view/camera-view.js';

/** A finite number in decimal digits; undefined for anything else. */
export function readNumber(text: string): number | undefined {
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text)) return undefined;
  const number = Number(text);
  return Number.isFinite(number) ? number : undefined;
}

/** A number of a vertex or of a face; undefined for anything else. */
export function readCount(text: string): number | undefined {
  return /^\d{1,9}$/.test(text) ? Number(text) : undefined;
}

/** A vertex as in '12', or a point of a face as in '4031:0.2:0.3': the face and two of the three weights. */
export function writePoint(point: SurfacePoint): string {
  if (typeof point === 'number') return String(point);
  // Exactly as they are: the loop is then the same to the last digit.
  return `${point.face}:${point.weights[0]}:${point.weights[1]}`;
}

/** The point that `writePoint` has written; undefined for any other text. */
export function readPoint(text: string): SurfacePoint | undefined {
  const [first = '', ...rest] = text.split(':');
  const number = readCount(first);
  if (number === undefined) return undefined;
  if (rest.length === 0) return number;
  const [a = NaN, b = NaN] = rest.map(readNumber).map((share) => share ?? NaN);
  const c = Math.max(0, 1 - a - b);
  if (rest.length !== 2 || !(a >= 0 && b >= 0 && a + b <= 1 + 1e-9)) return undefined;
  return { face: number, weights: [a, b, c] };
}

/** Six numbers with commas: polar angle and azimuth in radians, distance and x, y, z of the target in radii. */
export function writeCamera(view: CameraView, write: (number: number) => string = String): string {
  const { polar, azimuth, distance, target } = view;
  return [polar, azimuth, distance, ...target].map(write).join(',');
}

/** Six numbers with commas or spaces between them, as `writeCamera` writes them; undefined for anything else. */
export function readCamera(text: string): CameraView | undefined {
  const numbers = text
    .trim()
    .split(/\s*,\s*|\s+/)
    .map(readNumber);
  if (numbers.length !== 6 || numbers.some((number) => number === undefined)) return undefined;
  const [polar, azimuth, distance, x, y, z] = numbers as number[];
  if (!(distance! > 0)) return undefined;
  return { polar: polar!, azimuth: azimuth!, distance: distance!, target: [x!, y!, z!] };
}
