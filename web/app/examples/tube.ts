// Tubes of varying radius along smooth curves: legs, arms, handles, vessels.

/** A point of a tube's guide: x, y, z and the radius there. */
export type Station = readonly [number, number, number, number];

/** Of the polyline that stands for the curve. */
const segmentsPerTube = 48;
const segmentsPerChunk = 4;

/**
 * Beyond this distance, in metres, values are lower bounds only. No blend may be wider, so that none
 * can tell the difference.
 */
export const nearby = 0.07;

/**
 * The solid swept by a ball along a curve through all stations, its radius varying as smoothly as its
 * place. The curve is a natural cubic spline over the chord lengths, drawn as a fine polyline.
 */
export class Tube {
  /** x, y, z, radius per point of the polyline. */
  private readonly points: Float64Array;
  /** Centre and radius of a ball around each chunk of segments, the tube's own radius included. */
  private readonly bounds: Float64Array;
  /** The same around the whole tube. */
  private readonly ball: Float64Array;
  private readonly segments: number;

  constructor(stations: readonly Station[]) {
    this.points = spline(stations);
    this.segments = this.points.length / 4 - 1;
    this.bounds = boundingBalls(this.points, this.segments, segmentsPerChunk);
    this.ball = boundingBalls(this.points, this.segments, this.segments);
  }

  /**
   * Signed distance to the tube's surface, exact up to the taper; negative inside. A lower bound only
   * where it is above `nearby`.
   */
  distance(x: number, y: number, z: number): number {
    const { points, bounds, segments } = this;
    const whole = distanceToBall(this.ball, 0, x, y, z);
    if (whole > nearby) return whole;
    let best = Infinity;
    for (let chunk = 0, first = 0; first < segments; chunk += 4, first += segmentsPerChunk) {
      const least = distanceToBall(bounds, chunk, x, y, z);
      if (least >= best) continue;
      if (least > nearby) {
        best = least;
        continue;
      }
      const last = Math.min(first + segmentsPerChunk, segments);
      for (let i = 4 * first; i < 4 * last; i += 4) {
        const ax = points[i]!;
        const ay = points[i + 1]!;
        const az = points[i + 2]!;
        const ux = points[i + 4]! - ax;
        const uy = points[i + 5]! - ay;
        const uz = points[i + 6]! - az;
        const px = x - ax;
        const py = y - ay;
        const pz = z - az;
        let t = (px * ux + py * uy + pz * uz) / (ux * ux + uy * uy + uz * uz);
        t = t < 0 ? 0 : t > 1 ? 1 : t;
        const dx = px - t * ux;
        const dy = py - t * uy;
        const dz = pz - t * uz;
        const radius = points[i + 3]! + t * (points[i + 7]! - points[i + 3]!);
        const value = Math.sqrt(dx * dx + dy * dy + dz * dz) - radius;
        if (value < best) best = value;
      }
    }
    return best;
  }
}

function spline(stations: readonly Station[]): Float64Array {
  const spans = stations.length - 1;
  const segmentsPerSpan = Math.ceil(segmentsPerTube / spans);
  const knots = [0];
  for (let i = 0; i < spans; ++i) {
    const [a, b] = [stations[i]!, stations[i + 1]!];
    knots.push(knots[i]! + Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  const points = new Float64Array(4 * (spans * segmentsPerSpan + 1));
  for (let k = 0; k < 4; ++k) {
    const values = stations.map((station) => station[k]!);
    const second = secondDerivatives(knots, values);
    for (let j = 0; j <= spans * segmentsPerSpan; ++j) {
      const i = Math.min(Math.floor(j / segmentsPerSpan), spans - 1);
      const width = knots[i + 1]! - knots[i]!;
      const b = (j - i * segmentsPerSpan) / segmentsPerSpan;
      const a = 1 - b;
      const bend = ((a * a * a - a) * second[i]! + (b * b * b - b) * second[i + 1]!) / 6;
      points[4 * j + k] = a * values[i]! + b * values[i + 1]! + bend * width * width;
    }
  }
  return points;
}

/** Of the natural cubic spline through `values` at `knots`: the usual tridiagonal system. */
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

/** Centre and radius of a ball around each run of `length` segments. */
function boundingBalls(points: Float64Array, segments: number, length: number): Float64Array {
  const chunks = Math.ceil(segments / length);
  const bounds = new Float64Array(4 * chunks);
  for (let chunk = 0; chunk < chunks; ++chunk) {
    const first = chunk * length;
    const last = Math.min(first + length, segments);
    for (let k = 0; k < 3; ++k) {
      bounds[4 * chunk + k] = (points[4 * first + k]! + points[4 * last + k]!) / 2;
    }
    for (let i = 4 * first; i <= 4 * last; i += 4) {
      const far = Math.hypot(
        points[i]! - bounds[4 * chunk]!,
        points[i + 1]! - bounds[4 * chunk + 1]!,
        points[i + 2]! - bounds[4 * chunk + 2]!,
      );
      bounds[4 * chunk + 3] = Math.max(bounds[4 * chunk + 3]!, far + points[i + 3]!);
    }
  }
  return bounds;
}

/** Negative inside the ball. */
function distanceToBall(balls: Float64Array, at: number, x: number, y: number, z: number): number {
  const dx = x - balls[at]!;
  const dy = y - balls[at + 1]!;
  const dz = z - balls[at + 2]!;
  return Math.sqrt(dx * dx + dy * dy + dz * dz) - balls[at + 3]!;
}
