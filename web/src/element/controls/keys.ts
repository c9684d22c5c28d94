// Keys of the surface, and their actions.

import { type Stage, straightNames } from '../../view/index.js';
import type { LoopsOnSurface } from '../surface/loops-on-surface.js';

const arrows: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
/** Radians of an arrow, and what one step of the zoom multiplies the distance with. */
const turn = 0.12;
const nearer = 0.88;

/** Does what a key means; false where it means nothing. */
export function press(
  event: KeyboardEvent,
  stage: Stage,
  loops: LoopsOnSurface,
  atOnce: boolean,
): boolean {
  if (event.ctrlKey || event.altKey || event.metaKey) return false;
  const { key } = event;
  const arrow = arrows[key];
  if (arrow && event.shiftKey) loops.moveProbe(...arrow);
  else if (arrow) stage.orbit(turn * arrow[0], turn * arrow[1]);
  else if (key === '+' || key === '=') stage.zoom(nearer);
  else if (key === '-' || key === '_') stage.zoom(1 / nearer);
  else if (key === '0' || key === 'Home') stage.resetView();
  else if (/^[123]$/.test(key)) {
    stage.lookStraight(straightNames[Number(key) - 1]!, atOnce);
  } else if (key === 'c') return loops.turnAboutProbe();
  else if (key === 'Enter') return loops.pinProbe();
  else if (key === 'Escape') return loops.stopChoosing() || loops.clear();
  else if (key === 'Delete' || key === 'Backspace') loops.unpinLast();
  else return false;
  return true;
}
