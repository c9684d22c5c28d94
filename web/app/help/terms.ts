// The words that not everybody knows: a title and two lines each, with a small picture that Girth has made (`terms/`,
// by `npm run build:terms`).

interface Term {
  title: string;
  lines: readonly [string, string];
  picture: URL;
}

export const terms = {
  girth: {
    title: 'Girth',
    lines: [
      'The length of the shortest loop round the surface',
      'at a point, like a rubber band that holds tight.',
    ],
    picture: new URL('./terms/girth.webp', import.meta.url),
  },
  loop: {
    title: 'Loop',
    lines: [
      'The shortest way round through a point. Both of its',
      'halves are shortest paths to the dot half way round.',
    ],
    picture: new URL('./terms/loop.webp', import.meta.url),
  },
  tip: {
    title: 'Tip',
    lines: [
      'Where the shape ends: a part that is cut off by a',
      'line across which the girth jumps.',
    ],
    picture: new URL('./terms/tip.webp', import.meta.url),
  },
  tube: {
    title: 'Tube',
    lines: [
      'Thin, and its girth is small: legs, bars, handles.',
      'Its diameter is the girth divided by π.',
    ],
    picture: new URL('./terms/tube.webp', import.meta.url),
  },
  plate: {
    title: 'Plate',
    lines: [
      'Thin, but its girth is large: seats, panels, blades.',
      'The shape diameter (SDF) shows how thin.',
    ],
    picture: new URL('./terms/plate.webp', import.meta.url),
  },
  sdf: {
    title: 'SDF, shape diameter function',
    lines: [
      'How thick the shape is at a point: the mean length',
      'of rays from there through its inside.',
    ],
    picture: new URL('./terms/sdf.webp', import.meta.url),
  },
  thickness: {
    title: 'Thickness',
    lines: [
      'The width of the largest ball inside that touches',
      'the surface at a point. Edges sharper than 75° have none.',
    ],
    picture: new URL('./terms/thickness.svg', import.meta.url),
  },
  emd: {
    title: 'EMD, earth mover’s distance',
    lines: [
      'The least work that makes one distribution the',
      'other: the area between their cumulative curves.',
    ],
    picture: new URL('./terms/emd.svg', import.meta.url),
  },
} as const satisfies Record<string, Term>;

export type TermName = keyof typeof terms;
export const termNames = Object.keys(terms) as TermName[];
