// The state of the element as an object that can be kept as JSON: its attributes, and their values.

import { GirthError } from '../../kernel/types/errors.js';
import type { ViewerState } from './attribute-types.js';
import {
  type AttributeName,
  allowedInstead,
  attributeNames,
  attributeOf,
  isBare,
  isOn,
} from './attributes.js';
import { parseVertices } from './parse.js';
import { type PinWish, parsePins, writePins } from './wish-words.js';

/** An attribute of a state. */
export type StateName = keyof ViewerState;

/** Attributes that are about the page that an element is on. */
const pageNames: readonly AttributeName[] = ['loading', 'poster', 'linked', 'one-scale'];

/** All of them. */
export const stateNames = attributeNames.filter(
  (name): name is StateName => !pageNames.includes(name),
);

/** An attribute of something that hands and methods change as well. */
export type WishName = 'pins' | 'tips' | 'parts' | 'bottleneck' | 'profile' | 'camera';

/** The attributes that a state asks for, with their texts; throws INVALID_OPTION for whatever is no state. */
export function attributesOf(state: unknown): Map<StateName, string> {
  const isRecord = typeof state === 'object' && state !== null && !Array.isArray(state);
  if (!isRecord)
    throw fault('a state is an object', 'give what `state` has given, after JSON.parse');
  const texts = new Map<StateName, string>();
  for (const [name, value] of Object.entries(state)) {
    if (!isStateName(name)) {
      throw fault(`a state has no “${name.slice(0, 40)}”`, `it can have ${stateNames.join(', ')}`);
    }
    if (value !== undefined) texts.set(name, textOf(name, value));
  }
  return texts;
}

/** The state that the attributes of an element ask for. */
export function stateOf(element: Element): ViewerState {
  const state: ViewerState = {};
  for (const name of stateNames) {
    const text = attributeOf(element, name);
    if (text !== null && text !== 'true') state[name] = text;
    else if (isBare(name) && isOn(element, name)) state[name] = true;
  }
  const pins = pinsOf(element);
  if (pins) state.pins = writePins(pins);
  // Vertices are among the pins.
  if (state.loop !== 'none') delete state.loop;
  return state;
}

/** The loops that attributes ask for; undefined where they do not. */
export function pinsOf(element: Element): PinWish[] | undefined {
  const pins = attributeOf(element, 'pins');
  if (pins) return parsePins(pins);
  const loop = attributeOf(element, 'loop');
  const vertices = parseVertices(loop).map((point) => ({ point, name: '' }));
  return vertices.length > 0 || loop === 'none' ? vertices : undefined;
}

const isStateName = (name: string): name is StateName =>
  (stateNames as readonly string[]).includes(name);

function textOf(name: AttributeName, value: unknown): string {
  const isText = typeof value === 'string' || typeof value === 'number';
  const text = value === true && isBare(name) ? '' : isText ? String(value) : undefined;
  const kinds = isBare(name) ? 'a text, a number or true' : 'a text or a number';
  const allowed = text === undefined ? kinds : allowedInstead(name, text);
  if (text !== undefined && allowed === undefined) return text;
  const shown = String(JSON.stringify(value)).slice(0, 60);
  throw fault(`in a state, ${name} is not ${shown}`, `${name} can be ${allowed}`);
}

function fault(message: string, hint: string): GirthError {
  return new GirthError({ code: 'INVALID_OPTION', element: -1, message, hint });
}
