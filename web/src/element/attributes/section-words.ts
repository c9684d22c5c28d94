// A plane that cuts a surface, as words of attributes and addresses.

import { readNumber } from './place-words.js';

/** A plane across a direction of the file: what lies beyond a share of the surface's extent along it is cut away. */
export interface SectionWish {
  /** Towards what is cut away: x, y and z of the file, not all 0. */
  direction: readonly [number, number, number];
  /** The share of the surface's extent, from 0 to 1. */
  share: number;
}

const axes = ['x', 'y', 'z'];

/** A direction and a share: 'x 40%', '-z 50%', '0.5,0.2,0.8 30%'; undefined for anything else. */
export function parseSection(text: string): SectionWish | undefined {
  const [, sign, axis = '', numbers, percent = ''] =
    /^\s*(?:(-?)([xyz])|(\S+,\S+,\S+))\s+(\S+)%\s*$/.exec(text) ?? [];
  const share = (readNumber(percent) ?? NaN) / 100;
  const length = sign === '-' ? -1 : 1;
  const direction = numbers
    ? numbers.split(',').map((number) => readNumber(number) ?? NaN)
    : axes.map((one) => (one === axis ? length : 0));
  const isDirection = direction.length === 3 && direction.some((part) => part !== 0);
  if (!isDirection || direction.some(Number.isNaN) || !(share >= 0 && share <= 1)) return undefined;
  return { direction: direction as [number, number, number], share };
}
