// Random numbers from a seed, and states of the page made of them.

import type { PageState } from '../../../web/app/state/address-state.js';

export interface Random {
  /** A whole number below `end`. */
  below(end: number): number;
  /** One of them. */
  of<Type>(list: readonly Type[]): Type;
}

/** Numbers that are the same for the same seed (mulberry32). */
export function randomFrom(seed: number): Random {
  let at = seed >>> 0;
  const next = (): number => {
    at = (at + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(at ^ (at >>> 15), at | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return (mixed ^ (mixed >>> 14)) >>> 0;
  };
  const below = (end: number): number => next() % end;
  return { below, of: (list) => list[below(list.length)]! };
}

type Choices = { [Key in keyof PageState]-?: readonly NonNullable<PageState[Key]>[] };

const point = { face: 2, weights: [0.25, 0.5, 0.25] } as const;

/** Some values of each part of a state that is about how a surface is shown. */
export const choices: Omit<
  Choices,
  'model' | 'file' | 'closed' | 'weld' | 'components' | 'faces' | 'handles' | 'scale' | 'values'
> = {
  unit: ['mm', 'in'],
  shown: ['cm', 'ft'],
  field: ['sdf', 'kind', 'igf-sdf', 'none'],
  time: [0.1, 0.001],
  energy: [3, 70],
  component: [2, 5],
  colormap: ['turbo', 'magma'],
  range: ['5% 95%', '0.25 3'],
  isolines: [5, 40],
  method: ['coarse', 'refined'],
  persistence: ['1.5%', '2 mm'],
  edges: [true],
  log: [true],
  shading: ['flat', 'xray'],
  up: ['-x', 'z'],
  section: ['y 60%', '-x 40.5%'],
  reference: ['mean', 'beyond'],
  camera: [{ polar: 1.25, azimuth: -0.5, distance: 4.5, target: [0, 0.25, -1] }],
  loops: [[3], [4, point]],
  names: [['rim, left', '50% & more']],
  girth: [0.5, Infinity],
  diameter: [0.25],
  smoothing: [0.5, 2],
  tip: [1, 7],
  jump: [0.125],
  tube: [3],
  wall: [0.75],
  gap: [0.5],
  printer: ['sla', 'fdm'],
  bottleneck: [[1, 4]],
  profile: [[1, point, 3]],
  axis: [1, 3],
  limbNames: [['left arm', '', 'tail, short']],
  prominence: [0.125],
  cut: ['necks', 'neck:2', 'at:0.5'],
  rims: [true],
  beside: ['cup', 'https://example.org/a.glb'],
  besideFile: ['left, lower jaw.ply'],
  apart: [true],
  oneScale: [true],
  panel: ['tips', 'limbs', 'necks', 'parts', 'print', 'compare'],
};

/** A part of a state that somebody chooses, or takes back. */
export function randomChoice(random: Random): PageState {
  const key = random.of(Object.keys(choices) as (keyof typeof choices)[]);
  const isTakenBack = random.below(4) === 0;
  return { [key]: isTakenBack ? undefined : random.of<unknown>(choices[key]) };
}

/** Where a surface may be from, and what may have been done to it. */
export function randomModel(random: Random): PageState {
  return {
    ...random.of<PageState>([{ model: 'cup' }, { model: 'octopus' }, { file: 'Röhre & 1+2.obj' }]),
    ...random.of<PageState>([{}, {}, { closed: true, components: [0, 4] }, { scale: 1.5 }]),
    ...random.of<PageState>([{}, {}, { faces: 5000 }, { weld: 5.6e-17, handles: Infinity }]),
  };
}

/** A whole state as links ask for it. */
export function randomState(random: Random): PageState {
  let state = randomModel(random);
  for (let count = random.below(30); count > 0; --count) {
    state = { ...state, ...randomChoice(random) };
  }
  return Object.fromEntries(Object.entries(state).filter(([, value]) => value !== undefined));
}
