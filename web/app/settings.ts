// The colour map and the edges.

import { type GirthViewer, colormapNames, make } from '../src/element/index.js';
import { byId } from './dom.js';

export function offerColormaps(viewer: GirthViewer, changed: () => void): void {
  const select = byId<HTMLSelectElement>('colormap');
  select.append(...colormapNames.map((name) => make('option', { value: name }, name)));
  select.addEventListener('change', () => {
    viewer.setAttribute('colormap', select.value);
    changed();
  });
  const edges = byId<HTMLInputElement>('edges');
  edges.addEventListener('change', () => viewer.toggleAttribute('edges', edges.checked));
}
