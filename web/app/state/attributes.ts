// The attributes of the element follow the state; its own bar, its unit and its camera are choices, too.

import type { GirthMethod, GirthViewer } from '../../src/element/index.js';
import { setAttribute } from '../widgets/dom.js';
import type { SurfaceFacts } from './actions.js';
import type { PageState } from './address-state.js';
import type { Store } from './store.js';

/** Models from this many faces on are computed on few triangles first: exactly they would take long. */
const manyFaces = 100_000;

/** The method that the page uses unless somebody chooses; files may have the girth in them. */
export function usualMethod(facts: SurfaceFacts | undefined): GirthMethod {
  return facts && facts.faceCount >= manyFaces && !facts.given.includes('igf') ? 'coarse' : 'exact';
}

const numberIn = (value: number | undefined): string => (value === undefined ? '' : String(value));

/** The value of each attribute for a state, '' for none; in the order in which they are set. */
const texts: Record<string, (state: PageState) => string | boolean | undefined> = {
  'shown-unit': ({ shown }) => shown,
  up: ({ up }) => up,
  shading: ({ shading }) => shading,
  section: ({ section }) => section,
  time: ({ time }) => numberIn(time),
  energy: ({ energy }) => numberIn(energy),
  component: ({ component }) => numberIn(component),
  persistence: ({ persistence }) => persistence,
  field: ({ field }) => field,
  colormap: ({ colormap }) => colormap,
  range: ({ range }) => range,
  isolines: ({ isolines }) => numberIn(isolines),
  edges: ({ edges }) => edges ?? false,
  log: ({ log }) => log ?? false,
};

function set(viewer: GirthViewer, name: string, text: string | boolean | undefined): void {
  if (typeof text === 'boolean') viewer.toggleAttribute(name, text);
  else if ((viewer.getAttribute(name) ?? '') !== (text ?? '')) setAttribute(viewer, name, text);
}

/** Keeps the element as the state says, and the state as its bar and the hand on the surface say. */
export function followAttributes(viewer: GirthViewer, store: Store): void {
  store.watch(
    [
      ...(['unit', 'shown', 'up', 'shading', 'section', 'time', 'energy', 'component'] as const),
      ...(['method', 'persistence', 'field', 'colormap', 'range', 'isolines'] as const),
      ...(['edges', 'log'] as const),
    ],
    (state) => {
      const { facts } = store.held;
      set(viewer, 'unit', state.unit);
      const method = state.method ?? usualMethod(facts);
      set(viewer, 'method', method === 'exact' ? '' : method);
      for (const [name, text] of Object.entries(texts)) set(viewer, name, text(state));
    },
  );
  viewer.addEventListener('unit', () => {
    const isOwn = !viewer.info?.unit && viewer.unit !== '';
    store.choose({
      unit: isOwn ? viewer.unit : undefined,
      shown: viewer.shownUnit || undefined,
    });
  });
  viewer.addEventListener('view', () => {
    const chosen = (name: string): string | undefined => viewer.getAttribute(name) || undefined;
    store.choose({
      up: chosen('up'),
      shading: chosen('shading'),
      section: chosen('section'),
      edges: viewer.hasAttribute('edges'),
    });
  });
}

/** Keeps the camera where the state says, after panels have taken it elsewhere. */
export function followCamera(viewer: GirthViewer, store: Store): void {
  // The first view of a model needs no words, nor does one that passes by.
  const isOwn = (): boolean => !viewer.isAtHome && !viewer.isTurning;
  const keep = (): void => store.choose({ camera: isOwn() ? viewer.camera : undefined });
  viewer.addEventListener('camera', keep);
  let seen: object | undefined;
  store.watch(['camera'], ({ camera }) => {
    const { surface } = store.held.facts ?? {};
    if (camera) viewer.camera = camera;
    // Another model may have the view of the one before.
    else if (surface !== seen) keep();
    else if (isOwn()) viewer.resetView();
    seen = surface;
  });
}
