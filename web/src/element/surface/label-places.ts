// Places of labels: beside the things that they are about, clear of the surface and of each other.

import type { Box, Silhouette } from '../../view/index.js';

/** CSS pixels between a label and what it is about, and around a label. */
const gap = 12;
const margin = 4;
/** A label goes so many CSS pixels farther to be clear as a whole. */
const worthOfClear = 600;
/** A place that is clear is kept until another one is nearer by so many CSS pixels. */
const worthOfRest = 80;

/** A label to be placed. */
export interface Label {
  /** The box that the label is about. */
  about: Box;
  width: number;
  height: number;
  /** The present place of the label, if it has one. */
  before: { left: number; top: number } | undefined;
}

/** How far a box is from another, along the shorter way. */
function distance(one: Box, other: Box): number {
  const apart = (a: number, size: number, b: number, otherSize: number): number =>
    Math.max(0, b - (a + size), a - (b + otherSize));
  return Math.hypot(
    apart(one.left, one.width, other.left, other.width),
    apart(one.top, one.height, other.top, other.height),
  );
}

/**
 * The top left corners of labels, placed one after the other on a canvas of that size. Places that `taken` touches are
 * avoided as far as there is room; the labels are added to it.
 */
export function placeLabels(
  labels: readonly Label[],
  taken: Silhouette,
  canvas: { width: number; height: number },
): { left: number; top: number }[] {
  return labels.map(({ about, width, height, before }) => {
    const boxAt = (left: number, top: number): Box => ({ left, top, width, height });
    const costAt = (left: number, top: number): number => {
      const box = boxAt(left, top);
      const covered = taken.shareUnder(box);
      const way = distance(box, about);
      // Nearer than the gap it lies on the loop itself.
      return worthOfClear * covered + way + 4 * Math.max(0, gap - way);
    };
    const [right, bottom] = [canvas.width - width - margin, canvas.height - height - margin];
    const within = (value: number, most: number): number => Math.max(margin, Math.min(most, value));
    let best = { left: 0, top: 0 };
    let least = Infinity;
    if (before) {
      best = { left: within(before.left, right), top: within(before.top, bottom) };
      least = costAt(best.left, best.top) - worthOfRest;
    }
    const middle = about.top + about.height / 2 - height / 2;
    const see = (left: number, top: number): void => {
      // The height of the labelled box decides between places that are as good.
      const cost = costAt(left, top) + 0.05 * Math.abs(top - middle);
      if (cost < least) [least, best] = [cost, { left, top }];
    };
    // Straight beside it, then all over the canvas.
    see(within(about.left - gap - width, right), within(middle, bottom));
    see(within(about.left + about.width + gap, right), within(middle, bottom));
    for (let top = margin; top <= bottom; top += taken.cell) {
      for (let left = margin; left <= right; left += taken.cell) see(left, top);
    }
    taken.add({
      left: best.left - margin,
      top: best.top - margin,
      width: width + 2 * margin,
      height: height + 2 * margin,
    });
    return best;
  });
}
