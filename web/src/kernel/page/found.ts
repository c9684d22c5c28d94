// Results of a mesh, to be written: of which kind one is.

import { failure } from '../types/errors.js';
import type { FoundBesides } from '../types/protocol.js';

/** A member that only results of one kind have; and what these are written by besides. */
const kinds: readonly [member: string, kind: string, by?: keyof FoundBesides][] = [
  ['arcs', 'tips', 'linePoints'],
  ['tipsWithoutLimb', 'limbs'],
  ['necks', 'necks'],
  ['handles', 'handles'],
  ['sections', 'sections'],
  ['way', 'bottleneck'],
  ['stations', 'profile'],
  ['loops', 'axis'],
  ['partOf', 'parts', 'options'],
  ['passingScale', 'printCheck', 'limits'],
  ['labels', 'segments', 'by'],
];

/** The kind of a result. Throws where it is none, or `besides` lacks what it is written by. */
export function kindOf(found: object, besides: FoundBesides): string {
  const [, kind, by] = kinds.find(([member]) => member in found) ?? [];
  if (!kind)
    throw failure('USAGE', 'this is no result that is written', {
      hint: 'write what a mesh has found',
    });
  if (by && !besides[by]) {
    throw failure('USAGE', `this mesh has not found these ${kind}`, {
      hint: 'write the very object that it gave',
    });
  }
  return kind;
}
