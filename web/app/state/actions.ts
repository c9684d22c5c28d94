// How the state of the page changes: each function makes a state of another one.

import { combinationOf, isColormapName, isShownName } from '../../src/element/index.js';
import type { SurfacePoint } from '../../src/kernel/index.js';
import type { PageState } from './address-state.js';

/** Facts of the surface that is shown, which a state must fit. */
export interface SurfaceFacts {
  /** Which surface: another object for another one. */
  surface: object;
  vertexCount: number;
  faceCount: number;
  /** The unit that the file states; '' for none. */
  unit: string;
  /** Names of the values that the file has. */
  given: readonly string[];
}

type Key = keyof PageState;

/** Keys of the state that say where the surface comes from, and what was done to it. */
export const modelKeys = [
  ...(['model', 'file', 'closed', 'weld', 'components'] as const),
  ...(['faces', 'handles', 'scale'] as const),
] satisfies readonly Key[];
/** Keys of the state that stay with a model, however it is prepared. */
const ownKeys = [
  ...(['unit', 'shown', 'up', 'section'] as const),
  ...(['tube', 'wall', 'gap', 'printer', 'reference'] as const),
] satisfies readonly Key[];
/** Keys of the state that are about one surface. */
const surfaceKeys = [
  ...(['range', 'method', 'camera', 'loops', 'names', 'values', 'girth', 'diameter'] as const),
  ...([
    'smoothing',
    'tip',
    'jump',
    'bottleneck',
    'profile',
    'axis',
    'limbNames',
    'prominence',
  ] as const),
  ...(['cut', 'rims'] as const),
] satisfies readonly Key[];

const isNothing = (value: unknown): boolean =>
  value === undefined || value === false || (Array.isArray(value) && value.length === 0);

const isEqual = (one: unknown, other: unknown): boolean =>
  one === other ||
  (typeof one === 'object' &&
    typeof other === 'object' &&
    JSON.stringify(one) === JSON.stringify(other));

export function without(state: PageState, keys: readonly Key[]): PageState {
  const rest = { ...state };
  for (const key of keys) delete rest[key];
  return rest;
}

/** A choice made by hand; undefined takes one back. Without a difference it is the given state itself. */
export function chosen(state: PageState, choice: PageState): PageState {
  const next: Record<string, unknown> = { ...state };
  let isAnother = false;
  for (const [key, value] of Object.entries(choice)) {
    const wanted: unknown = isNothing(value) ? undefined : value;
    if (isEqual(next[key], wanted)) continue;
    isAnother = true;
    if (wanted === undefined) delete next[key];
    else next[key] = wanted;
  }
  return isAnother ? next : state;
}

/** Whether two states are of the same surface. */
export const isOfSurface = (one: PageState, other: PageState): boolean =>
  modelKeys.every((key) => isEqual(one[key], other[key]));

/** A choice made while a wish waits for its model: what of it holds for that model, too. */
export function heldChoice(shown: PageState, wish: PageState, choice: PageState): PageState {
  if (isOfSurface(shown, wish)) return choice;
  const isSame = shown.model === wish.model && shown.file === wish.file;
  return without(choice, [...modelKeys, ...surfaceKeys, ...(isSame ? [] : ownKeys)]);
}

/** The rest of a state when another surface comes by hand; `isAnother`: it is of another model. */
export const left = (state: PageState, isAnother: boolean): PageState =>
  without(state, [...surfaceKeys, ...(isAnother ? ownKeys : [])]);

const isOn = (point: SurfacePoint, { vertexCount, faceCount }: SurfaceFacts): boolean =>
  typeof point === 'number' ? point < vertexCount : point.face < faceCount;

/** Whether a surface has what a name is of: values of a file are those of that file. */
function hasField(name: string, facts: SurfaceFacts): boolean {
  if (!isShownName(name) || name === 'igf') return false;
  const { first, second } = combinationOf(name) ?? { first: name, second: name };
  return [first, second].every((one) => !one.startsWith('_') || facts.given.includes(one));
}

/**
 * The state of a surface that has come: `model` says where it is from; things that it cannot have
 * are left out.
 */
export function fitted(state: PageState, model: PageState, facts: SurfaceFacts): PageState {
  const next: PageState = { ...without(state, [...modelKeys, 'values']), ...model };
  const { field, colormap, loops, names } = next;
  if (field !== undefined && !hasField(field, facts)) delete next.field;
  if (colormap !== undefined && !isColormapName(colormap)) delete next.colormap;
  if (facts.unit !== '') delete next.unit;
  for (const path of ['bottleneck', 'profile'] as const) {
    if (next[path]?.every((point) => isOn(point, facts)) === false) delete next[path];
  }
  if (loops) {
    const kept = loops
      .map((point, i) => ({ point, name: names?.[i] ?? '' }))
      .filter(({ point }) => isOn(point, facts));
    Object.assign(next, pinnedOf(kept));
  }
  // Only the panel of loops is open where none is named.
  if (next.panel === 'loops') delete next.panel;
  return chosen({}, next);
}

/** Pinned loops as a state has them. */
export function pinnedOf(pins: readonly { point: SurfacePoint; name: string }[]): PageState {
  const names = pins.map(({ name }) => name);
  return {
    loops: pins.map(({ point }) => point),
    names: names.some((name) => name !== '') ? names : [],
  };
}
