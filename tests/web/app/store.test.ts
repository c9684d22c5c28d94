// The state of the page: how it changes, and that a wish holds for its own model only.

import { expect, test } from 'vitest';
import {
  type SurfaceFacts,
  chosen,
  fitted,
  isOfSurface,
  left,
  modelKeys,
  without,
} from '../../../web/app/state/actions.js';
import { type PageState, readState, writeState } from '../../../web/app/state/address-state.js';
import { Store } from '../../../web/app/state/store.js';
import { choices, randomChoice, randomFrom, randomModel, randomState } from './random-state.js';

const about = { vertexCount: 10, faceCount: 16, unit: '', given: ['_heat'] };
/** The facts of a surface that has just come. */
const newFacts = (): SurfaceFacts => ({ surface: {}, ...about });
const facts = newFacts();

test('any state is the same after it was written as a link and read, and again', () => {
  for (let seed = 1; seed <= 500; ++seed) {
    const state = randomState(randomFrom(seed));
    const link = writeState(state);
    expect(readState(link), `seed ${seed}: ${link}`).toEqual(state);
    expect(writeState(readState(link)), `seed ${seed}`).toBe(link);
  }
});

test('what a surface cannot have is left out of its state', () => {
  const model = { model: 'cup' };
  const fit = (state: PageState, other: Partial<SurfaceFacts> = {}) =>
    without(fitted(state, model, { ...facts, ...other }), ['model']);
  expect(fit({ field: '_heat' })).toEqual({ field: '_heat' });
  expect(fit({ field: '_cold', colormap: 'mud' })).toEqual({});
  expect(fit({ field: 'igf-_cold' })).toEqual({});
  expect(fit({ field: 'igf', panel: 'loops' })).toEqual({});
  expect(fit({ unit: 'mm' }, { unit: 'in' })).toEqual({});
  expect(fit({ loops: [3, 99, 4], names: ['', 'far', 'near'] })).toEqual({
    loops: [3, 4],
    names: ['', 'near'],
  });
  expect(fit({ bottleneck: [3, 99], profile: [1, 2], values: ['3 mm'] })).toEqual({
    profile: [1, 2],
  });
  // The surface says itself where it is from.
  expect(fitted({ model: 'chair', faces: 9 }, model, facts)).toEqual(model);
});

test('a wish is shown with its model, and what was chosen meanwhile with it', () => {
  const store = new Store();
  store.arrive({ model: 'cup' }, facts);
  const wish = store.ask({ model: 'octopus', tip: 2, colormap: 'turbo' });
  store.choose({ isolines: 10, tip: 5 });
  expect(store.shown).toEqual({ model: 'cup', isolines: 10, tip: 5 });
  store.arrive({ model: 'octopus' }, facts, wish, true);
  expect(store.shown).toEqual({ model: 'octopus', tip: 2, colormap: 'turbo', isolines: 10 });
  expect(store.wish).toBeUndefined();
});

test('before the first model the address means what the link asks for, though its model fails', () => {
  const store = new Store();
  const link = { model: 'https://example.org/a.glb', field: 'sdf' };
  const wish = store.ask(link);
  expect(store.meant).toEqual(link);
  store.fail(wish);
  expect(store.meant).toEqual(link);
  expect(store.wish?.isMissing).toBe(true);
  store.arrive({ model: 'cup' }, facts);
  expect(store.meant).toEqual({ model: 'cup' });
});

test('of another model the choices of manner stay, of the same one also its unit and limits', () => {
  const whole = Object.fromEntries(Object.entries(choices).map(([key, [value]]) => [key, value]));
  const [another, same] = [left(whole, true), left(whole, false)];
  const own = ['unit', 'shown', 'up', 'section', 'tube', 'wall', 'gap', 'printer', 'reference'];
  expect(Object.keys(same).sort()).toEqual([...Object.keys(another), ...own].sort());
  expect(Object.keys(another).sort()).toEqual(
    [
      ...['field', 'time', 'energy', 'component', 'colormap', 'isolines', 'persistence', 'edges'],
      ...['log', 'shading', 'beside', 'besideFile', 'apart', 'oneScale', 'panel'],
    ].sort(),
  );
});

test('watchers are told in their order, of their own keys, and of what others change', () => {
  const store = new Store();
  const told: string[] = [];
  store.watch(['tip'], ({ tip }) => {
    told.push(`tip ${tip}`);
    if (tip === 9) store.choose({ tip: undefined });
  });
  store.watch(['tip', 'jump'], ({ tip, jump }) => told.push(`both ${tip} ${jump}`));
  store.choose({ field: 'sdf' });
  expect(told).toEqual([]);
  store.choose({ jump: 1 });
  store.choose({ jump: 1 });
  expect(told.splice(0)).toEqual(['both undefined 1']);
  store.choose({ tip: 9 });
  expect(told.splice(0)).toEqual([
    ...['tip 9', 'both undefined 1', 'tip undefined', 'both undefined 1'],
  ]);
  // Another surface, though the state of it is the same.
  store.arrive({}, newFacts());
  expect(told.splice(0)).toEqual(['tip undefined', 'both undefined undefined']);
  store.choose({ tip: 3 });
  told.splice(0);
  // One surface in another state.
  const { facts: same } = store.held;
  store.arrive({ ...store.shown }, same!, store.ask({ tip: 3, jump: 2 }));
  expect(told).toEqual(['both 3 2']);
});

/** A model that is being opened: the wish that it is for, or none where it was opened by hand. */
interface Opening {
  model: PageState;
  wish: number | undefined;
}

test('10,000 random steps: what is shown is what was asked for last, whatever comes late', () => {
  for (const seed of [49, 2026, 11, 29]) {
    const random = randomFrom(seed);
    const store = new Store();
    const late: Opening[] = [];
    /** The newest wish, in the words of a plain model of the page. */
    let wanted: { number: number; state: PageState } | undefined;
    let shown: PageState = {};
    let isThere = false;
    const followed: PageState[] = [{}];
    store.watch(
      [...modelKeys, ...(Object.keys(choices) as (keyof PageState)[])],
      (state) => void followed.push(state),
    );
    for (let step = 0; step < 2_500; ++step) {
      const where = `seed ${seed}, step ${step}`;
      const act = random.below(10);
      if (act < 4) {
        const choice = randomChoice(random);
        const [key] = Object.keys(choice) as [keyof PageState];
        // A choice by hand holds for what is waited for, unless it is about the surface that is shown.
        const isForBoth = (state: PageState): boolean =>
          isOfSurface(shown, state) || key in left({ [key]: 1 }, !isSame(shown, state));
        if (wanted && chosen(shown, choice) !== shown && isForBoth(wanted.state))
          wanted = { ...wanted, state: chosen(wanted.state, choice) };
        shown = chosen(shown, choice);
        store.choose(choice);
      } else if (act < 6) {
        const state = randomState(random);
        const number = store.ask(state, { byHand: random.below(2) === 0 });
        wanted = { number, state };
        late.push({ model: state, wish: number });
      } else if (act < 7) {
        store.giveUp();
        wanted = undefined;
        late.push({ model: randomModel(random), wish: undefined });
      } else {
        // Any of those under way comes, or fails; the element has ended those that were asked for before it.
        const [opening] = late.splice(random.below(Math.max(1, late.length)), 1);
        if (!opening) continue;
        const isMet = opening.wish !== undefined && opening.wish === wanted?.number;
        if (random.below(4) === 0) {
          if (opening.wish !== undefined) store.fail(opening.wish);
          if (isMet && isThere) wanted = undefined;
        } else {
          const model = Object.fromEntries(
            modelKeys.flatMap((key) => (key in opening.model ? [[key, opening.model[key]]] : [])),
          );
          const isAnother = !isSame(shown, model);
          shown = fitted(isMet ? wanted!.state : left(shown, isAnother), model, facts);
          if (isMet) wanted = undefined;
          isThere = true;
          store.arrive(model, newFacts(), opening.wish, isAnother);
        }
      }
      expect(store.shown, where).toEqual(shown);
      expect(store.wish?.state, where).toEqual(wanted?.state);
      expect(store.meant, where).toEqual(isThere || !wanted ? shown : wanted.state);
      // Views were told last of the state that is shown, and a link of it says the same.
      expect(followed.at(-1), where).toEqual(shown);
      expect(readState(writeState(shown)), where).toEqual(shown);
    }
  }
});

const isSame = (one: PageState, other: PageState): boolean =>
  one.model === other.model && one.file === other.file;
