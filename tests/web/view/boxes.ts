// Boxes as triangles.

/** Boxes, each from its lowest to its highest corner. */
export function boxes(...ends: [readonly number[], readonly number[]][]) {
  const positions: number[] = [];
  const indices: number[] = [];
  const sides = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  for (const box of ends) {
    const first = positions.length / 3;
    for (let corner = 0; corner < 8; ++corner) {
      for (let k = 0; k < 3; ++k) positions.push(box[(corner >> k) & 1]![k]!);
    }
    for (const [a, b, c, d] of sides) {
      indices.push(...[a, b, c, a, c, d].map((corner) => first + corner!));
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}
