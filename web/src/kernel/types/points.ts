// Points of a surface, as all calls take and give them.

/** A point of a face. */
export interface FacePoint {
  /** From 0 to the face count minus one. Face f has the vertices `indices[3 * f]` and the next two. */
  face: number;
  /** Shares of the face's three vertices, in their order: none below 0, the sum 1. */
  weights: readonly [number, number, number];
}

/** A vertex, or a point of a face: of its inside, of an edge (one weight is 0) or a corner. */
export type SurfacePoint = number | FacePoint;
