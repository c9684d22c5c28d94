// Tubes of varying radius along smooth curves: legs, arms, handles, vessels.

/** A point of a tube's guide: x, y, z and the radius there. */
export type Station = readonly [number, number, number, number];

/** Segments of the polyline that stands for the curve; a power of two. */
const segments = 128;

/**
 * Beyond this distance, in metres, values are lower bounds only. No blend may be wider, so that none
 * can tell the difference.
 */
export const nearby = 0.05;

/**
 * The solid swept by a ball along a curve through all stations, its radius varying as smoothly as its
 * place. The curve is a natural cubic spline over the chord lengths, drawn as a fine polyline.
 */
export class Tube {
  /** x, y, z, radius per point of the polyline. */
  readonly #points: Float64Array;
  /**
   * Centre and radius of a ball around each part of the tube: a binary tree with the whole at place 1,
   * the halves of part i at 2i and 2i + 1, and single segments at the end.
   */
  readonly #balls: Float64Array;

  constructor(stations: readonly Station[]) {
    this.#points = spline(stations);
    this.#balls = boundingBalls(this.#points);
  }

  /**
   * Signed distance to the tube's surface, exact up to the taper; negative inside. A lower bound only
   * where it is above `nearby`.
   */
  distance(x: number, y: number, z: number): number {
    return this.#smallest(1, this.#leastDistance(1, x, y, z), x, y, z, Infinity);
  }

  /** The smaller of `best` and the distance to part i, which is known to be at least `least`. */
  #smallest(i: number, least: number, x: number, y: number, z: number, best: number): number {
    if (least >= best) return best;
    if (least > nearby) return least;
    if (i >= segments) return Math.min(best, this.#segmentDistance(i - segments, x, y, z));
    const first = this.#leastDistance(2 * i, x, y, z);
    const second = this.#leastDistance(2 * i + 1, x, y, z);
    if (first < second) {
      const value = this.#smallest(2 * i, first, x, y, z, best);
      return this.#smallest(2 * i + 1, second, x, y, z, value);
    }
    const value = this.#smallest(2 * i + 1, second, x, y, z, best);
    return this.#smallest(2 * i, first, x, y, z, value);
  }

  #leastDistance(i: number, x: number, y: number, z: number): number {
    const balls = this.#balls;
    const dx = x - balls[4 * i]!;
    const dy = y - balls[4 * i + 1]!;
    const dz = z - balls[4 * i + 2]!;
    return Math.sqrt(dx * dx + dy * dy + dz * dz) - balls[4 * i + 3]!;
  }

  #segmentDistance(segment: number, x: number, y: number, z: number): number {
    const points = this.#points;
    const i = 4 * segment;
    const ux = points[i + 4]! - points[i]!;
    const uy = points[i + 5]! - points[i + 1]!;
    const uz = points[i + 6]! - points[i + 2]!;
    const px = x - points[i]!;
    const py = y - points[i + 1]!;
    const pz = z - points[i + 2]!;
    const share = (px * ux + py * uy + pz * uz) / (ux * ux + uy * uy + uz * uz);
    const t = share < 0 ? 0 : share > 1 ? 1 : share;
    const dx = px - t * ux;
    const dy = py - t * uy;
    const dz = pz - t * uz;
    const radius = points[i + 3]! + t * (points[i + 7]! - points[i + 3]!);
    return Math.sqrt(dx * dx + dy * dy + dz * dz) - radius;
  }
}

/** Evenly spaced points of the curve, with the radius as fourth coordinate. */
function spline(stations: readonly Station[]): Float64Array {
  const knots = [0];
  for (let i = 0; i + 1 < stations.length; ++i) {
    const [a, b] = [stations[i]!, stations[i + 1]!];
    knots.push(knots[i]! + Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  const points = new Float64Array(4 * (segments + 1));
  for (let k = 0; k < 4; ++k) {
    const values = stations.map((station) => station[k]!);
    const second = secondDerivatives(knots, values);
    for (let j = 0, i = 0; j <= segments; ++j) {
      const place = (j / segments) * knots[knots.length - 1]!;
      while (i + 2 < knots.length && place > knots[i + 1]!) ++i;
      const width = knots[i + 1]! - knots[i]!;
      const b = (place - knots[i]!) / width;
      const a = 1 - b;
      const bend = ((a * a * a - a) * second[i]! + (b * b * b - b) * second[i + 1]!) / 6;
      points[4 * j + k] = a * values[i]! + b * values[i + 1]! + bend * width * width;
    }
  }
  return points;
}

/** Second derivatives of the natural cubic spline through `values` at `knots`: a tridiagonal system. */
function secondDerivatives(knots: number[], values: number[]): number[] {
  const n = knots.length;
  const second = new Array<number>(n).fill(0);
  const carried = new Array<number>(n).fill(0);
  for (let i = 1; i < n - 1; ++i) {
    const before = knots[i]! - knots[i - 1]!;
    const after = knots[i + 1]! - knots[i]!;
    const pivot = 2 * (before + after) - before * carried[i - 1]!;
    const slopes = (values[i + 1]! - values[i]!) / after - (values[i]! - values[i - 1]!) / before;
    carried[i] = after / pivot;
    second[i] = (6 * slopes - before * second[i - 1]!) / pivot;
  }
  for (let i = n - 2; i > 0; --i) second[i] = second[i]! - carried[i]! * second[i + 1]!;
  return second;
}

function boundingBalls(points: Float64Array): Float64Array {
  const balls = new Float64Array(8 * segments);
  for (let i = 2 * segments - 1; i > 0; --i) {
    let [first, last] = [i, i + 1];
    while (first < segments) [first, last] = [2 * first, 2 * last];
    const [from, to] = [4 * (first - segments), 4 * (last - segments)];
    for (let k = 0; k < 3; ++k) balls[4 * i + k] = (points[from + k]! + points[to + k]!) / 2;
    for (let at = from; at <= to; at += 4) {
      const far = Math.hypot(
        points[at]! - balls[4 * i]!,
        points[at + 1]! - balls[4 * i + 1]!,
        points[at + 2]! - balls[4 * i + 2]!,
      );
      balls[4 * i + 3] = Math.max(balls[4 * i + 3]!, far + points[at + 3]!);
    }
  }
  return balls;
}
