// Keys of the surface that no control stands for. The element acts on them: `press` is asked.

import type { GirthViewer } from '../../src/element/index.js';
import type { Action } from './action.js';
import { eventOf } from './shortcuts.js';

const keys = [
  ['Turn left', 'ArrowLeft'],
  ['Turn right', 'ArrowRight'],
  ['Turn up', 'ArrowUp'],
  ['Turn down', 'ArrowDown'],
  ['Nearer', 'Plus'],
  ['Farther', 'Minus'],
  ['Move the loop left', 'Shift+ArrowLeft'],
  ['Move the loop right', 'Shift+ArrowRight'],
  ['Move the loop up', 'Shift+ArrowUp'],
  ['Move the loop down', 'Shift+ArrowDown'],
  ['Turn about the loop’s point', 'C'],
  ['Pin the loop', 'Enter'],
  ['Hide the loop', 'Escape'],
  ['Remove the loop that was pinned last', 'Delete'],
] as const;

/** The keys of the surface as actions. */
export function surfaceActions(viewer: GirthViewer): Action[] {
  return keys.map(([words, shortcut]) => ({
    words,
    place: ['Surface'],
    keys: [shortcut],
    isOn: false,
    isPossible: viewer.info !== undefined,
    run: () => void viewer.press(eventOf(shortcut)),
  }));
}
