// `npx girth` against the native command, whole runs on models of 10,000 faces, from start to exit, with what Node.js takes
// to start and to compile the module. They take turns, and of the ratios within a turn the median counts.

import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, test } from 'vitest';
import { command, repository } from '../browser/support.js';
import { packed } from '../web/package/packed.js';
import { figure, printFigures, quantile, type Figure } from './figures.js';
import { runProgram, type Run } from './processor-time.js';

const turns = 9;
/** Times of the native time. */
const goal = 2;

const figures: Figure[] = [];
const folder = mkdtempSync(join(tmpdir(), 'girth-command-'));
afterAll(() => {
  rmSync(folder, { recursive: true });
  printFigures(figures);
});

const program = join(packed().folder, 'dist/command/girth.cjs');
const modelOf = (name: string) => join(repository, 'web/app/public/examples', `${name}.glb`);

test.each([
  ['igf', 'chair', 'values.csv'],
  ['igf', 'octopus', 'values.csv'],
  ['tips', 'octopus', 'tips.json'],
  ['parts', 'chair', 'parts.csv'],
])('girth %s, %s', (name, model, output) => {
  const args = [name, modelOf(model), '-o', join(folder, output), '--threads', '2', '--quiet'];
  const ratios: Omit<Run, 'output'>[] = [];
  const natively: number[] = [];
  for (let turn = 0; turn < turns; ++turn) {
    const native = runProgram(command, args);
    const module = runProgram(process.execPath, [program, ...args]);
    natively.push(native.processor);
    ratios.push({
      clock: module.clock / native.clock,
      processor: module.processor / native.processor,
    });
  }
  console.log(
    `girth ${name}, ${model}: natively, seconds of processor time:`,
    quantile(natively, 0.5),
  );
  for (const key of ['processor', 'clock'] as const) {
    const ratio = quantile(
      ratios.map((turn) => turn[key]),
      0.5,
    );
    figures.push(figure(`girth ${name}, ${model}: ${key}`, 'times native', ratio, goal));
  }
});
