// Writes the examples and their index to the folder given as argument, and a table of what they are
// like to standard output.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { loadCore } from './core.ts';
import { generate } from './generate.ts';
import { models } from './models/index.ts';

const folder = process.argv[2];
if (folder === undefined) throw new Error('the folder to write to is missing');
mkdirSync(folder, { recursive: true });

const core = await loadCore();
const index = models.map((model) => {
  const started = performance.now();
  const { glb, measures } = generate(model, core);
  const seconds = (performance.now() - started) / 1000;
  const { name, title, about } = model;
  const { faces, vertices, genus } = measures;
  const file = `${name}.glb`;
  writeFileSync(join(folder, file), glb);
  console.log(
    `${name.padEnd(10)}${String(faces).padStart(6)} faces  genus ${genus}` +
      `  angles ${measures.smallestAngle.toFixed(1)} to ${measures.largestAngle.toFixed(1)} degrees` +
      `  valence ${measures.smallestValence} to ${measures.largestValence}` +
      `  edges ${(1000 * measures.shortestEdge).toFixed(1)} to ${(1000 * measures.longestEdge).toFixed(1)} mm` +
      `  ${seconds.toFixed(1)} s`,
  );
  return { name, title, about, file, faces, vertices, genus };
});
writeFileSync(join(folder, 'index.json'), `${JSON.stringify(index, null, 2)}\n`);
