// What each attribute of the element can be. Any other value counts as if the attribute were not there.

import type { GirthErrorFields } from '../kernel/types.js';
import { colormapNames } from '../view/colormap-names.js';
import { derivedNames, fieldNames, isGivenName, isShownName } from '../view/field-words.js';
import { findLengthUnit, lengthUnits, readLengthOrShare } from '../view/length-text.js';
import { lookNames } from '../view/look.js';
import { upNames } from '../view/up-axis.js';
import { mostIsolines, parseRange } from './parse.js';

interface Rule {
  /** For people: it can be … */
  allowed: string;
  accepts(text: string): boolean;
}

const listed = (words: readonly string[]): string =>
  `${words.slice(0, -1).join(', ')} or ${words.at(-1)}`;

function oneOf(words: readonly string[]): Rule {
  return { allowed: listed(words), accepts: (text) => words.includes(text) };
}

function wholeNumber(least: number, most: number): Rule {
  return {
    allowed: `a whole number from ${least} to ${most}`,
    accepts: (text) => /^\s*\d+\s*$/.test(text) && Number(text) >= least && Number(text) <= most,
  };
}

/** Without a value, or with one that frameworks write. */
const flag: Rule = {
  allowed: 'without a value; leave it out to switch it off',
  accepts: (text) => text === 'true',
};

const lengthUnit: Rule = {
  allowed: listed(lengthUnits.map(({ symbol }) => symbol)),
  accepts: (text) => findLengthUnit(text) !== undefined,
};

const rules = {
  src: { allowed: 'the address of a model', accepts: () => true },
  loading: oneOf(['eager', 'lazy']),
  poster: { allowed: 'the address of a picture', accepts: () => true },
  unit: lengthUnit,
  'shown-unit': lengthUnit,
  field: {
    allowed: listed([...fieldNames, ...derivedNames, 'none', 'values of the file as in _heat']),
    accepts: (text) => isShownName(text) || isGivenName(text.toLowerCase()),
  },
  'field-title': { allowed: 'words for the legend', accepts: () => true },
  colormap: oneOf(colormapNames),
  range: {
    allowed: 'auto, two rising numbers as in 1 2.5, or two rising shares as in 5% 95%',
    accepts: (text) => text === 'auto' || parseRange(text) !== undefined,
  },
  isolines: wholeNumber(0, mostIsolines),
  log: flag,
  persistence: {
    allowed: 'a length as in 0.5 or 3mm, or a share of the square root of the area as in 2%',
    accepts: (text) => 'length' in readLengthOrShare(text, 'm', 1),
  },
  time: {
    allowed: 'a number above 0',
    accepts: (text) => Number(text) > 0 && Number.isFinite(Number(text)),
  },
  energy: wholeNumber(1, 100),
  component: wholeNumber(1, 19),
  loop: {
    allowed: 'hover, none, or vertices as in 12 4031',
    accepts: (text) => /^(hover|none|[\s,]*\d+([\s,]+\d+)*[\s,]*)$/.test(text),
  },
  edges: flag,
  shading: oneOf(lookNames),
  up: oneOf(upNames),
  'keep-view': flag,
  controls: flag,
  turn: flag,
} satisfies Record<string, Rule>;

/** What is sent of a wrong attribute. */
interface AttributeFault extends GirthErrorFields {
  attribute: AttributeName;
}

/** An attribute that the element follows. */
export type AttributeName = keyof typeof rules;

/** All of them. */
export const attributeNames = Object.keys(rules) as AttributeName[];

const isEmptyOrAllowed = (name: AttributeName, text: string): boolean =>
  text === '' || (rules[name] === flag && text === name) || rules[name].accepts(text);

/** What an attribute can be, in words, where its value is none of that; undefined where all is well. */
export function allowedInstead(name: AttributeName, text: string): string | undefined {
  return isEmptyOrAllowed(name, text) ? undefined : rules[name].allowed;
}

/** The value of an attribute; null where there is none, or none that is allowed. */
export function attributeOf(element: Element, name: AttributeName): string | null {
  const text = element.getAttribute(name);
  return text && isEmptyOrAllowed(name, text) ? text : null;
}

/** Whether an attribute that has no value is there. */
export function isOn(element: Element, name: AttributeName): boolean {
  const text = element.getAttribute(name);
  return text !== null && isEmptyOrAllowed(name, text);
}

/** Characters of a wrong value that are repeated. */
const mostQuoted = 60;
/** Wrong attributes that have been reported on the console, by any element. */
const saidOnConsole = new Set<string>();

/** What is wrong with a value, as it is sent with `error`, and once written on the console; undefined for nothing. */
export function faultOf(name: AttributeName, text: string): AttributeFault | undefined {
  const allowed = allowedInstead(name, text);
  if (allowed === undefined) return undefined;
  const said = `${name}="${text.slice(0, mostQuoted)}"`;
  const message = `the attribute ${said} means nothing, and counts as if it were not there`;
  const hint = `${name} can be ${allowed}`;
  if (!saidOnConsole.has(said)) console.warn(`<girth-viewer>: ${message}; ${hint}`);
  saidOnConsole.add(said);
  return { code: 'INVALID_OPTION', element: -1, message, hint, attribute: name };
}
