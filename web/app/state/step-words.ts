// A step of undo in words: what is another in one of two states.

import { type PageState, readState } from './address-state.js';

const words: Readonly<Record<keyof PageState, string>> = {
  ...{ model: 'model', file: 'model', closed: 'closed holes', weld: 'weld distance' },
  ...{ components: 'components', faces: 'number of faces', handles: 'removed handles' },
  ...{ unit: 'unit of the file', shown: 'shown unit', scale: 'size' },
  ...{ field: 'field', time: 'time', energy: 'energy', component: 'frequency' },
  ...{ colormap: 'colour map', range: 'range of colours', isolines: 'isolines' },
  ...{ method: 'method', persistence: 'persistence', edges: 'edges', log: 'logarithmic colours' },
  ...{ shading: 'shading', up: 'way up', section: 'section', camera: 'view' },
  ...{ loops: 'pinned loops', names: 'names of loops', values: 'pinned loops' },
  ...{ girth: 'thresholds of parts', diameter: 'thresholds of parts', smoothing: 'smoothing' },
  ...{ tip: 'chosen tip', jump: 'least rise of tips' },
  ...{ tube: 'limits of printing', wall: 'limits of printing', gap: 'limits of printing' },
  ...{
    printer: 'printer',
    bottleneck: 'bottleneck',
    profile: 'path',
    axis: 'limb',
    limbNames: 'names of limbs',
  },
  ...{ reference: 'reference of tubes', prominence: 'least prominence', cut: 'cut', rims: 'rims' },
  ...{ beside: 'model beside', besideFile: 'model beside', apart: 'views', oneScale: 'colours' },
  panel: 'panel',
};

/** Parts that move with others. */
const following = new Set([words.camera, words.panel]);

/** Names of what differs between two states as the address has them: 'colour map, isolines'; '' where nothing does. */
export function stepWords(one: string, other: string): string {
  const [from, to] = [readState(one), readState(other)];
  const keys = Object.keys(words) as (keyof PageState)[];
  const changed = new Set(
    keys
      .filter((key) => JSON.stringify(from[key]) !== JSON.stringify(to[key]))
      .map((key) => words[key]),
  );
  if (changed.has(words.model)) return words.model;
  const own = [...changed].filter((name) => !following.has(name));
  return (own.length > 0 ? own : [...changed]).join(', ');
}
