// Writes every example at several resolutions, for benchmarks: arguments are the folder and the numbers
// of faces. Files are named NAME_FACES.glb after the number asked for.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { loadCore } from './core.ts';
import { generate } from './generate.ts';
import { models } from './models/index.ts';

/** Models whose thin limbs cannot be made of fewer faces. */
const fewestFaces: Partial<Record<string, number>> = { chair: 4000, octopus: 4000 };

const [folder, ...sizes] = process.argv.slice(2);
if (folder === undefined) throw new Error('the folder to write to is missing');
mkdirSync(folder, { recursive: true });

const core = await loadCore();
for (const model of models) {
  for (const faces of sizes.map(Number)) {
    if (faces < (fewestFaces[model.name] ?? 0)) continue;
    // More faces start from a finer grid; fewer do not start from a coarser one, which would lose thin parts.
    const cell = model.cell * Math.min(1, Math.sqrt(model.faces / faces));
    const { glb } = generate({ ...model, faces, cell }, core);
    writeFileSync(join(folder, `${model.name}_${String(faces)}.glb`), glb);
  }
}
