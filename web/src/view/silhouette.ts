// Where on the canvas the surface is, coarsely: a grid of cells, each touched by it or clear.

/** More faces than this are not looked at one by one: where there are so many, some of their corners touch every cell. */
const mostFaces = 150_000;
/** So many corners, spread evenly over the numbers of all. */
const enoughCorners = 60_000;

/** A shape that is cast on the canvas: a mesh, and the matrix that brings its points into clip space, by columns. */
export interface CastMesh {
  positions: Float32Array;
  indices: Uint32Array;
  matrix: ArrayLike<number>;
}

/** A rectangle on the canvas, in CSS pixels from its top left corner. */
export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

export class Silhouette {
  /** CSS pixels along the side of a cell. */
  readonly cell: number;
  readonly columns: number;
  readonly rows: number;
  /** A number for each cell, row by row: 1 where something is. */
  readonly #touched: Uint8Array;
  /** How many cells are touched above and to the left of each corner of the grid. */
  #sums: Uint32Array | undefined;

  constructor(width: number, height: number, cell: number) {
    this.cell = cell;
    this.columns = Math.max(1, Math.ceil(width / cell));
    this.rows = Math.max(1, Math.ceil(height / cell));
    this.#touched = new Uint8Array(this.columns * this.rows);
  }

  /** Touches every cell that a mesh covers in part, on a canvas of the given size. */
  cast({ positions, indices, matrix: m }: CastMesh, width: number, height: number): void {
    const isOfCorners = indices.length > 3 * mostFaces;
    const all = positions.length / 3;
    const step = isOfCorners ? Math.max(1, Math.floor(all / enoughCorners)) : 1;
    const count = Math.ceil(all / step);
    const places = new Float32Array(2 * count);
    for (let v = 0; v < count; ++v) {
      const at = 3 * step * v;
      const [x, y, z] = [positions[at]!, positions[at + 1]!, positions[at + 2]!];
      const w = m[3]! * x + m[7]! * y + m[11]! * z + m[15]!;
      // Points behind the eye are nowhere.
      const across = w > 0 ? (m[0]! * x + m[4]! * y + m[8]! * z + m[12]!) / w : NaN;
      const up = w > 0 ? (m[1]! * x + m[5]! * y + m[9]! * z + m[13]!) / w : NaN;
      places[2 * v] = ((0.5 + 0.5 * across) * width) / this.cell;
      places[2 * v + 1] = ((0.5 - 0.5 * up) * height) / this.cell;
    }
    this.#sums = undefined;
    if (isOfCorners) {
      for (let v = 0; v < count; ++v) {
        const row = Math.floor(places[2 * v + 1]!);
        this.#touchRow(row, places[2 * v]!, places[2 * v]!);
      }
      return;
    }
    for (let i = 0; i < indices.length; i += 3) this.#touchFace(places, indices, i);
  }

  /** Touches every cell that a rectangle covers in part. */
  add({ left, top, width, height }: Box): void {
    this.#sums = undefined;
    const last = Math.min(this.rows - 1, Math.floor((top + height) / this.cell));
    for (let row = Math.max(0, Math.floor(top / this.cell)); row <= last; ++row) {
      this.#touchRow(row, left / this.cell, (left + width) / this.cell);
    }
  }

  /** The share of the cells under a rectangle that are touched or outside of the grid. */
  shareUnder({ left, top, width, height }: Box): number {
    const sums = (this.#sums ??= this.#sumUp());
    const from = (place: number): number => Math.floor(place / this.cell);
    const [x0, x1] = [from(left), from(left + width) + 1];
    const [y0, y1] = [from(top), from(top + height) + 1];
    const within = (place: number, most: number): number => Math.max(0, Math.min(most, place));
    const [a, b] = [within(x0, this.columns), within(x1, this.columns)];
    const [c, d] = [within(y0, this.rows), within(y1, this.rows)];
    const stride = this.columns + 1;
    const at = (row: number, column: number): number => sums[row * stride + column]!;
    const touched = at(d, b) - at(c, b) - at(d, a) + at(c, a);
    const all = (x1 - x0) * (y1 - y0);
    return (touched + all - (b - a) * (d - c)) / all;
  }

  #touchRow(row: number, from: number, to: number): void {
    if (!(row >= 0 && row < this.rows) || !(to >= 0) || !(from < this.columns)) return;
    const start = row * this.columns;
    const first = Math.max(0, Math.floor(from));
    this.#touched.fill(1, start + first, start + Math.min(this.columns, Math.floor(to) + 1));
  }

  #touchFace(places: Float32Array, indices: Uint32Array, face: number): void {
    const [a, b, c] = [2 * indices[face]!, 2 * indices[face + 1]!, 2 * indices[face + 2]!];
    const low = Math.floor(Math.min(places[a + 1]!, places[b + 1]!, places[c + 1]!));
    const high = Math.floor(Math.max(places[a + 1]!, places[b + 1]!, places[c + 1]!));
    // Also where a corner is behind the eye: then the bounds are no numbers.
    if (!(high >= 0 && low < this.rows)) return;
    for (let row = Math.max(0, low); row <= Math.min(this.rows - 1, high); ++row) {
      let [from, to] = [Infinity, -Infinity];
      for (let side = 0; side < 3; ++side) {
        const [p, q] = side === 0 ? [a, b] : side === 1 ? [b, c] : [c, a];
        const [x0, y0, x1, y1] = [places[p]!, places[p + 1]!, places[q]!, places[q + 1]!];
        // The part of the side within the row.
        const [first, second] =
          y0 === y1 ? [0, 1] : [(row - y0) / (y1 - y0), (row + 1 - y0) / (y1 - y0)];
        const begin = Math.max(0, Math.min(first, second));
        const end = Math.min(1, Math.max(first, second));
        if (begin > end) continue;
        const [x, y] = [x0 + begin * (x1 - x0), x0 + end * (x1 - x0)];
        from = Math.min(from, x, y);
        to = Math.max(to, x, y);
      }
      this.#touchRow(row, from, to);
    }
  }

  #sumUp(): Uint32Array {
    const stride = this.columns + 1;
    const sums = new Uint32Array(stride * (this.rows + 1));
    for (let row = 0; row < this.rows; ++row) {
      let inRow = 0;
      for (let column = 0; column < this.columns; ++column) {
        inRow += this.#touched[row * this.columns + column]!;
        sums[(row + 1) * stride + column + 1] = sums[row * stride + column + 1]! + inRow;
      }
    }
    return sums;
  }
}
