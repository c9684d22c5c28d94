// Steps back and forth.

import { expect, test } from 'vitest';
import { UndoSteps } from '../../../web/app/state/undo-steps.js';

test('back and forth, and a new step forgets what was undone', () => {
  const steps = new UndoSteps();
  expect(steps.undo()).toBe(undefined);
  for (const state of ['a', 'b', 'b', 'c']) steps.take(state);
  expect(steps.undo()).toBe('b');
  expect(steps.undo()).toBe('a');
  expect([steps.undo(), steps.before, steps.after]).toEqual([undefined, undefined, 'b']);
  expect(steps.redo()).toBe('b');
  steps.take('d');
  expect([steps.redo(), steps.after, steps.before]).toEqual([undefined, undefined, 'b']);
  expect([steps.undo(), steps.undo(), steps.undo()]).toEqual(['b', 'a', undefined]);
});

test('a state that is written otherwise once it is shown is no step', () => {
  const steps = new UndoSteps();
  for (const state of ['a', 'b']) steps.take(state);
  expect(steps.undo()).toBe('a');
  steps.correct('a, written otherwise');
  steps.take('a, written otherwise');
  expect([steps.before, steps.redo(), steps.undo()]).toEqual([
    undefined,
    'b',
    'a, written otherwise',
  ]);
});

test('of very many steps the last ones are kept', () => {
  const steps = new UndoSteps();
  for (let i = 0; i <= 1000; ++i) steps.take(String(i));
  let count = 0;
  while (steps.undo() !== undefined) ++count;
  expect(count).toBe(200);
});
