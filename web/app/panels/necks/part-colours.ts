// Four colours for the parts of a cut: as many as a surface can be shaded in at a time, so that several parts share one.

import type { CutPart } from '../../../src/kernel/index.js';

export const partColours = ['#cfd0d3', '#0072b2', '#e69f00', '#d55e00'] as const;

/** The number of faces and vertices that cutting has made. */
const none = 0xffffffff;

/** The neighbours of each part, which it was cut from: they share pieces of a face, or vertices. */
export function neighboursOf(parts: readonly Pick<CutPart, 'faces' | 'vertices'>[]): Set<number>[] {
  const neighbours = parts.map(() => new Set<number>());
  for (const key of ['faces', 'vertices'] as const) {
    const owners = new Map<number, number[]>();
    parts.forEach((part, i) => {
      for (const whole of part[key]) {
        if (whole === none) continue;
        const known = owners.get(whole);
        if (!known) owners.set(whole, [i]);
        else if (known.at(-1) !== i) {
          for (const other of known) {
            neighbours[other]!.add(i);
            neighbours[i]!.add(other);
          }
          known.push(i);
        }
      }
    });
  }
  return neighbours;
}

/**
 * For each part the number of its colour: of those that its neighbours have not, the one of the fewest parts. It goes from
 * neighbour to neighbour, so that where parts make a tree, as those of a body without handles do, none clash.
 */
export function colourParts(parts: readonly Pick<CutPart, 'faces' | 'vertices'>[]): number[] {
  const neighbours = neighboursOf(parts);
  const colours = parts.map((): number | undefined => undefined);
  const counts: number[] = partColours.map(() => 0);
  const pending: number[] = [];
  const reached = new Set<number>();
  const reach = (part: number): void => {
    if (reached.has(part)) return;
    reached.add(part);
    pending.push(part);
  };
  for (let first = 0; first < parts.length; ++first) {
    reach(first);
    for (let part = pending.pop(); part !== undefined; part = pending.pop()) {
      const taken = new Set([...neighbours[part]!].map((other) => colours[other]));
      const all = [...counts.keys()];
      const free = all.filter((colour) => !taken.has(colour));
      const from = free.length > 0 ? free : all;
      const chosen = from.reduce((best, one) => (counts[one]! < counts[best]! ? one : best));
      colours[part] = chosen;
      ++counts[chosen]!;
      for (const other of neighbours[part]!) reach(other);
    }
  }
  return colours as number[];
}
