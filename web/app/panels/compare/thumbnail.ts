// A small picture of a surface that is not on the stage, coloured by a field.

import type { Field, Mesh } from '../../../src/kernel/index.js';
import {
  type ColormapName,
  rotationUp,
  upAxisOf,
  uprightPositions,
} from '../../../src/element/index.js';
import { colourAt } from '../../../src/element/plots.js';

const width = 72;
const height = 54;
/** Faces that a picture of this size can show; of more, every so manieth is drawn larger. */
const mostFaces = 40_000;
/** The view is from the front, a little from the right and from above. */
const [right, up] = [0.55, 0.4];

/** The place of a point as it is seen: right, up, towards the eye. */
function seen(x: number, y: number, z: number): [number, number, number] {
  const across = Math.cos(right) * x - Math.sin(right) * z;
  const towards = Math.sin(right) * x + Math.cos(right) * z;
  return [
    across,
    Math.cos(up) * y - Math.sin(up) * towards,
    Math.sin(up) * y + Math.cos(up) * towards,
  ];
}

/** Draws the faces from back to front. */
export function thumbnail(
  { geometry, info }: Pick<Mesh, 'geometry' | 'info'>,
  field: Pick<Field, 'values' | 'range'> | undefined,
  colormap: ColormapName,
): HTMLCanvasElement {
  const { indices } = geometry;
  const { direction } = upAxisOf(null, info.format, geometry.positions, indices);
  const positions = uprightPositions(geometry.positions, rotationUp(direction));
  const canvas = document.createElement('canvas');
  const ratio = Math.min(2, devicePixelRatio);
  canvas.width = ratio * width;
  canvas.height = ratio * height;
  const context = canvas.getContext('2d')!;
  const points = new Float64Array(positions.length);
  const [low, high] = [
    [Infinity, Infinity],
    [-Infinity, -Infinity],
  ];
  for (let i = 0; i < positions.length; i += 3) {
    const point = seen(positions[i]!, positions[i + 1]!, positions[i + 2]!);
    points.set(point, i);
    for (const k of [0, 1]) {
      low[k] = Math.min(low[k]!, point[k]!);
      high[k] = Math.max(high[k]!, point[k]!);
    }
  }
  const scale = 0.94 * Math.min(width / (high[0]! - low[0]!), height / (high[1]! - low[1]!));
  if (!Number.isFinite(scale)) return canvas;
  const x = (vertex: number): number =>
    width / 2 + scale * (points[3 * vertex]! - (low[0]! + high[0]!) / 2);
  const y = (vertex: number): number =>
    height / 2 - scale * (points[3 * vertex + 1]! - (low[1]! + high[1]!) / 2);
  const depth = (face: number): number =>
    points[3 * indices[face]! + 2]! +
    points[3 * indices[face + 1]! + 2]! +
    points[3 * indices[face + 2]! + 2]!;
  const every = Math.max(1, Math.ceil(indices.length / 3 / mostFaces));
  const faces = Array.from(
    { length: Math.floor(indices.length / 3 / every) },
    (_, i) => 3 * every * i,
  );
  const depths = new Map(faces.map((face) => [face, depth(face)]));
  faces.sort((a, b) => depths.get(a)! - depths.get(b)!);
  context.scale(ratio, ratio);
  context.lineWidth = 0.6 * Math.sqrt(every);
  for (const face of faces) {
    const [a, b, c] = [indices[face]!, indices[face + 1]!, indices[face + 2]!];
    const value = field ? (field.values[a]! + field.values[b]! + field.values[c]!) / 3 : NaN;
    const colour =
      field && Number.isFinite(value)
        ? colourAt(colormap, (value - field.range[0]) / (field.range[1] - field.range[0]))
        : 'rgb(150 151 156)';
    context.fillStyle = context.strokeStyle = colour;
    context.beginPath();
    context.moveTo(x(a), y(a));
    context.lineTo(x(b), y(b));
    context.lineTo(x(c), y(c));
    context.closePath();
    context.fill();
    // Closes the seams between neighbours.
    context.stroke();
  }
  return canvas;
}
