// Programs with the processor time that they take, which what else the machine does hardly changes.

import { execFileSync } from 'node:child_process';

export interface Run {
  output: string;
  /** Seconds by the clock. */
  clock: number;
  /** Seconds of processor time, of all threads, user and system. */
  processor: number;
}

/** Runs a program; its errors are shown. */
export function runProgram(program: string, args: readonly string[]): Run {
  const from = performance.now();
  const text = execFileSync('sh', ['-c', '"$@"; times', 'sh', program, ...args], {
    encoding: 'utf8',
  });
  const clock = (performance.now() - from) / 1000;
  const lines = text.trim().split('\n');
  // The shell's own times, then its children's: user and system.
  const seconds = [...lines.at(-1)!.matchAll(/(\d+)m([\d.]+)s/g)].map(
    ([, minutes, rest]) => 60 * Number(minutes) + Number(rest),
  );
  return {
    output: lines.slice(0, -2).join('\n'),
    clock,
    processor: seconds.reduce((sum, part) => sum + part, 0),
  };
}
