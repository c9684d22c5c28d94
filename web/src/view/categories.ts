// Fields that sort the vertices: their categories, each with a name, a colour and a pattern.

/** One of few kinds of place on a surface. */
export interface Category {
  /** For the legend. */
  name: string;
  /** `#rrggbb`. */
  colour: string;
  /** Drawn with stripes: distinguished without its colour. */
  hatched: boolean;
}

// Blue, orange, sky blue and vermilion are those of Okabe and Ito's palette, chosen to be distinguishable in
// every common kind of colour blindness; they also differ in lightness.
const blue = '#0072b2';
const orange = '#e69f00';
const skyBlue = '#56b4e9';
const vermilion = '#d55e00';
const light = '#cfd0d3';
const grey = '#96979c';

/** The kinds of a girth, in the order of their numbers. */
export const girthKinds: readonly Category[] = [
  { name: 'loop', colour: skyBlue, hatched: false },
  { name: 'there and back', colour: vermilion, hatched: false },
  { name: 'not found in time', colour: grey, hatched: true },
];

/** How sure a refined girth is, in the order of the states' numbers. */
export const girthStates: readonly Category[] = [
  { name: 'proved', colour: blue, hatched: false },
  { name: 'consistent', colour: skyBlue, hatched: false },
  { name: 'suspect', colour: orange, hatched: true },
];

/** The kinds of a part, in the order of their numbers. */
export const partKinds: readonly Category[] = [
  { name: 'body', colour: light, hatched: false },
  { name: 'tube', colour: blue, hatched: false },
  { name: 'plate', colour: orange, hatched: false },
  { name: 'unknown', colour: grey, hatched: true },
];
