// Results of a mesh, to be written: of which kind one is.

import { analysisLists } from '../types/analyses.js';
import { failure } from '../types/errors.js';
import type { FoundBesides } from '../types/protocol.js';

interface Kind {
  name: string;
  /** A member that only its results have. */
  member: string;
  /** A member of `FoundBesides` that its files need. */
  by?: keyof FoundBesides;
  /** Its files have faces by their numbers in the model's file. */
  hasFaces?: true;
}

const kinds: readonly Kind[] = [
  ...Object.entries(analysisLists).map(([name, member]) => ({ name, member })),
  { name: 'tips', member: 'arcs', by: 'linePoints' },
  { name: 'limbs', member: 'tipsWithoutLimb' },
  { name: 'necks', member: 'necks' },
  { name: 'handles', member: 'handles' },
  { name: 'bottleneck', member: 'way' },
  { name: 'profile', member: 'stations' },
  { name: 'axis', member: 'loops' },
  { name: 'parts', member: 'partOf', by: 'options' },
  { name: 'printCheck', member: 'passingScale', by: 'limits', hasFaces: true },
  { name: 'segments', member: 'labels', by: 'by', hasFaces: true },
];

/** The kind of a result. Throws where it is none, or `besides` lacks what it is written by. */
export function kindOf(found: object, besides: FoundBesides): Kind {
  const kind = kinds.find(({ member }) => member in found);
  if (!kind) {
    throw failure('USAGE', 'this is no result of a mesh', {
      hint: 'write what a mesh has found',
    });
  }
  if (kind.by && !besides[kind.by]) {
    throw failure('USAGE', `this mesh has not found these ${kind.name}`, {
      hint: 'write the very object that it gave',
    });
  }
  return kind;
}
