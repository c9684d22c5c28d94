// A surface without creases for the tests of the view.

/** A torus about the y axis, `around` by `across` quadrilaterals in two triangles each. */
export function torus(around: number, across: number, big = 1, small = 0.4) {
  const positions = new Float32Array(3 * around * across);
  const indices: number[] = [];
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j < across; ++j) {
      const u = (2 * Math.PI * i) / around;
      const v = (2 * Math.PI * j) / across;
      // Thicker on one side, so that there is a field to see.
      const r = small * (1 + 0.45 * Math.cos(u));
      const at = [
        (big + r * Math.cos(v)) * Math.cos(u),
        r * Math.sin(v),
        (big + r * Math.cos(v)) * Math.sin(u),
      ];
      positions.set(at, 3 * (i * across + j));
      const [a, b] = [i * across + j, i * across + ((j + 1) % across)];
      const [c, d] = [a, b].map((k) => (k + across) % (around * across)) as [number, number];
      indices.push(a, b, c, b, d, c);
    }
  }
  return { positions, indices: Uint32Array.from(indices) };
}
