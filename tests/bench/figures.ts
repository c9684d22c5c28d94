// Figures beside their goals.

import { loadavg } from 'node:os';

export interface Figure {
  what: string;
  figure: string;
  goal: string;
  /** The ratio of the figure to the goal: at most 1 where it is met. */
  ratio: string;
}

export function figure(what: string, unit: string, value: number, goal: number): Figure {
  return {
    what,
    figure: `${value.toPrecision(3)} ${unit}`,
    goal: `${Number(goal.toPrecision(3))} ${unit}`,
    ratio: (value / goal).toFixed(2),
  };
}

/** Shows figures as a table, with what else may have changed them. */
export function printFigures(figures: readonly Figure[]): void {
  console.log(`\nLoad of the machine at the end: ${loadavg()[0]!.toFixed(1)}`);
  console.table(figures);
}

/** The value below which that share of the values lies. */
export function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN;
}
