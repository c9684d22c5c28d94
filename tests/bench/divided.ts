// Surfaces with each of their triangles cut into four, again and again: the same shape in more triangles.

import { readFileSync } from 'node:fs';

/** An OFF file of triangles as an OBJ whose triangles were cut so many times. */
export function dividedOff(path: string, times: number): string {
  const tokens = readFileSync(path, 'utf8').split(/\s+/);
  let next = 1; // behind the word OFF
  const number = () => Number(tokens[next++]);
  const [vertexCount, faceCount] = [number(), number()];
  next += 1; // the number of edges
  const points = Array.from({ length: vertexCount }, () => [number(), number(), number()] as const);
  let faces = Array.from({ length: faceCount }, () => {
    next += 1; // the number of corners
    return [number(), number(), number()] as const;
  });
  for (let time = 0; time < times; ++time) {
    const middles = new Map<string, number>();
    const middle = (a: number, b: number): number => {
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      let vertex = middles.get(key);
      if (vertex === undefined) {
        const [p, q] = [points[a]!, points[b]!];
        vertex = points.push([(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2]) - 1;
        middles.set(key, vertex);
      }
      return vertex;
    };
    faces = faces.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
      return [
        [a, ab, ca],
        [ab, b, bc],
        [ca, bc, c],
        [ab, bc, ca],
      ] as const;
    });
  }
  const lines = [
    ...points.map((point) => `v ${point.join(' ')}`),
    ...faces.map((corners) => `f ${corners.map((corner) => corner + 1).join(' ')}`),
  ];
  return `${lines.join('\n')}\n`;
}
