import type { Implicit } from '../implicit.ts';
import type { Box } from '../polygonise.ts';

/** An example, and how it is made. Lengths in metres, y up, as in glTF. */
export interface Model {
  /** File name without extension. */
  name: string;
  title: string;
  /** One sentence: what its girth shows. */
  about: string;
  genus: number;
  /** Faces asked for; met to within a few per cent. */
  faces: number;
  solid: Implicit;
  /** Contains the solid, with some room to every side. */
  box: Box;
  /** Width of the grid's cells: at most a quarter of the thinnest part. */
  cell: number;
}
