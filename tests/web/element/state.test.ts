import { expect, test } from 'vitest';
import { attributesOf, stateNames, stateOf } from '../../../web/src/element/attributes/state.js';
import {
  parseParts,
  parsePins,
  parseTips,
  writeParts,
  writePins,
  writeTips,
} from '../../../web/src/element/attributes/wish-words.js';

/** As much of an element as is looked at. */
const elementWith = (attributes: Record<string, string>) =>
  ({ getAttribute: (name: string) => attributes[name] ?? null }) as unknown as Element;

test('pins are read as they were written, whatever their names are', () => {
  const names = ['', 'waist', 'left leg', 'a, b', '12', '12 more', '100%', ' both ends ', 'é\n,'];
  const pins = names.map((name, i) => ({ point: i, name }));
  expect(parsePins(writePins(pins))).toEqual(pins);
  const point = { face: 7, weights: [0.1, 0.2, 0.7] as [number, number, number] };
  const [read] = parsePins(writePins([{ point, name: 'a' }]))!;
  expect(read!.point).toEqual({ face: 7, weights: [0.1, 0.2, expect.closeTo(0.7, 15)] });
  expect(parsePins(writePins([]))).toEqual([]);
  expect(parsePins(Array.from({ length: 1001 }, (_, i) => i).join())).toBeUndefined();
});

test('tips and parts are read as they were written', () => {
  for (const selected of [undefined, 3]) {
    for (const leastJump of ['0', '0.05', '5mm']) {
      expect(parseTips(writeTips({ leastJump, selected }))).toEqual({ leastJump, selected });
    }
  }
  expect(parseTips('')).toEqual({ leastJump: '0', selected: undefined });
  for (const parts of [
    { girth: '0.2', shapeDiameter: 'inf', smoothing: 0 },
    { girth: '5cm', shapeDiameter: '1e-3', smoothing: 0.25 },
  ]) {
    expect(parseParts(writeParts(parts))).toEqual(parts);
  }
});

test('a state has what attributes ask for, and not what counts for nothing', () => {
  const state = stateOf(
    elementWith({
      ...{ src: 'a.glb', field: 'foo', isolines: '', log: '', tips: '', turn: 'true' },
      ...{ loading: 'lazy', poster: 'a.png', loop: '12 4', controls: 'none' },
    }),
  );
  const rest = { src: 'a.glb', log: true, tips: true, turn: true, pins: '12, 4', controls: 'none' };
  expect(state).toEqual(rest);
  expect(Object.fromEntries(attributesOf(state))).toEqual({
    ...rest,
    ...{ log: '', tips: '', turn: '' },
  });
  expect(stateOf(elementWith({ loop: 'none' }))).toEqual({ loop: 'none', pins: 'none' });
  for (const ofPage of ['poster', 'linked', 'one-scale']) expect(stateNames).not.toContain(ofPage);
});

test.each([
  [null, 'is an object'],
  ['{}', 'is an object'],
  [[], 'is an object'],
  [{ feld: 'igf' }, 'no “feld”'],
  [{ poster: 'a.png' }, 'no “poster”'],
  [{ field: 'foo' }, 'field is not "foo"'],
  [{ field: true }, 'field is not true'],
  [{ field: {} }, 'field is not {}'],
  [{ src: null }, 'src is not null'],
  [{ isolines: NaN }, 'isolines is not null'],
  [{ log: false }, 'log is not false'],
])('%j is no state', (state, words) => {
  const error = expect.objectContaining({
    code: 'INVALID_OPTION',
    message: expect.stringContaining(words) as string,
    hint: expect.stringMatching(/./) as string,
  }) as Error;
  expect(() => attributesOf(state)).toThrow(error);
});
