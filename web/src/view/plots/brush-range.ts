// The range of values that is marked on a plot, and how pointer and keys change it.

/** The lower and the upper end. */
export type ValueRange = readonly [number, number];

/** The range between two places of a drag; places are shares of the axis. */
export function dragged(from: number, to: number): [number, number] {
  const clamp = (place: number): number => Math.min(1, Math.max(0, place));
  return from <= to ? [clamp(from), clamp(to)] : [clamp(to), clamp(from)];
}

/**
 * The range that a key makes of a range of bins [first, last]: arrows move it, with Shift its upper end; Home
 * and End move it to the ends; Escape, Delete and Backspace remove it ('none'). Undefined: the key
 * means nothing here. Without a range an arrow begins at the end it comes from.
 */
export function movedByKey(
  range: ValueRange | undefined,
  key: string,
  withShift: boolean,
  bins: number,
): ValueRange | 'none' | undefined {
  if (key === 'Escape' || key === 'Delete' || key === 'Backspace')
    return range ? 'none' : undefined;
  const step = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[key];
  const width = range ? range[1] - range[0] : 0;
  if (key === 'Home') return [0, width];
  if (key === 'End') return [bins - 1 - width, bins - 1];
  if (step === undefined) return undefined;
  if (!range) return step > 0 ? [0, 0] : [bins - 1, bins - 1];
  const [first, last] = range;
  if (withShift) return [first, Math.min(bins - 1, Math.max(first, last + step))];
  const moved = Math.min(bins - 1 - width, Math.max(0, first + step));
  return [moved, moved + width];
}
