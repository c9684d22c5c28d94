// What each attribute of the element can be. Any other value counts as if the attribute were not there.

import { signatureNumbers } from '../kernel/types/fields.js';
import { findLengthUnit, lengthUnits } from '../kernel/types/length-units.js';
import type { GirthErrorFields } from '../kernel/types/types.js';
import { colormapNames } from '../view/colormap-names.js';
import { derivedNames, fieldNames, isShownName } from '../view/field-words.js';
import { readLengthOrShare } from '../view/length-text.js';
import { lookNames } from '../view/look.js';
import { straightNames } from '../view/straight-names.js';
import { upNames } from '../view/up-axis.js';
import type { GirthViewerAttributes } from './attribute-types.js';
import { mostIsolines, parseRange } from './parse.js';
import { readCamera } from './place-words.js';
import { parseSection } from './section-words.js';
import { parseParts, parsePath, parsePins, parseTips, parseTwoPoints } from './wish-words.js';

interface Rule {
  /** For people: it can be … */
  allowed: string;
  accepts(text: string): boolean;
  /** Without a value, too, it asks for something. */
  isBare?: true;
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
  isBare: true,
};

const lengthUnit: Rule = {
  allowed: listed(lengthUnits.map(({ symbol }) => symbol)),
  accepts: (text) => findLengthUnit(text) !== undefined,
};

const twoPoints: Rule = {
  allowed: 'two vertices with a comma between them, as in 12, 4031, or points as in 7:0.2:0.3',
  accepts: (text) => parseTwoPoints(text) !== undefined,
};

const path: Rule = {
  allowed:
    'vertices with commas between them, as in 12, 4031, or points as in 7:0.2:0.3; at least two',
  accepts: (text) => parsePath(text) !== undefined,
};

const named: Rule = { allowed: 'a name', accepts: () => true };

/** What lies on the surface beside it: nothing, the legend, or the legend and a bar. */
const controlNames = ['none', 'legend', 'full'] as const;

/** In the order in which they are set together. */
const rules: Record<AttributeName, Rule> = {
  src: { allowed: 'the address of a model', accepts: () => true },
  loading: oneOf(['eager', 'lazy']),
  poster: { allowed: 'the address of a picture', accepts: () => true },
  unit: lengthUnit,
  'shown-unit': lengthUnit,
  field: {
    allowed: listed([
      ...[...fieldNames, ...derivedNames, 'none', 'values of the file as in _heat'],
      'two of these as in igf-sdf, igf/sdf',
    ]),
    accepts: (text) => isShownName(text.replace(/_\w+/g, (own) => own.toLowerCase())),
  },
  'field-title': { allowed: 'words for the legend', accepts: () => true },
  colormap: oneOf(colormapNames),
  range: {
    allowed: 'auto, two rising numbers as in 1 2.5, or two rising shares as in 5% 95%',
    accepts: (text) => text === 'auto' || parseRange(text) !== undefined,
  },
  isolines: wholeNumber(0, mostIsolines),
  log: flag,
  method: oneOf(['exact', 'coarse', 'refined']),
  persistence: {
    allowed: 'a length as in 0.5 or 3mm, or a share of the square root of the area as in 2%',
    accepts: (text) => 'length' in readLengthOrShare(text, 'm', 1),
  },
  time: {
    allowed: 'a number above 0',
    accepts: (text) => Number(text) > 0 && Number.isFinite(Number(text)),
  },
  energy: wholeNumber(1, signatureNumbers.wks.count),
  component: wholeNumber(1, signatureNumbers.sihks.count),
  loop: {
    allowed: 'hover, none, or vertices as in 12 4031',
    accepts: (text) => /^(hover|none|[\s,]*\d+([\s,]+\d+)*[\s,]*)$/.test(text),
  },
  pins: {
    allowed:
      'none, or vertices with commas between them, each with or without a name, as in 12 waist, 4031; or points as in 7:0.2:0.3, a face and two of its weights',
    accepts: (text) => parsePins(text) !== undefined,
  },
  tips: {
    allowed: 'none, all, a length as in 5mm that they rise at least, and # with the number of one',
    accepts: (text) => parseTips(text) !== undefined,
    isBare: true,
  },
  parts: {
    allowed:
      'the girth and the thickness where tubes and plates begin, as in 200mm 50mm, and a number for the smoothing',
    accepts: (text) => parseParts(text) !== undefined,
  },
  bottleneck: twoPoints,
  profile: path,
  camera: {
    allowed: `${listed(straightNames)}, or six numbers: polar angle, azimuth, distance and the target’s x, y, z`,
    accepts: (text) =>
      straightNames.some((name) => name === text) || readCamera(text) !== undefined,
  },
  edges: flag,
  shading: oneOf(lookNames),
  section: {
    allowed: 'a direction and the share along it that is left, as in x 40%',
    accepts: (text) => parseSection(text) !== undefined,
  },
  up: oneOf(upNames),
  'keep-view': flag,
  linked: named,
  'one-scale': named,
  controls: {
    allowed: listed(controlNames),
    accepts: (text) => text === 'true' || text === 'controls' || isControls(text),
    isBare: true,
  },
  turn: flag,
};

/** What is sent of a wrong attribute. */
interface AttributeFault extends GirthErrorFields {
  attribute: AttributeName;
}

/** An attribute that the element follows. */
export type AttributeName = keyof GirthViewerAttributes;

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

/** Whether an attribute asks for something without a value, too. */
export const isBare = (name: AttributeName): boolean => rules[name].isBare ?? false;

/** Whether an attribute that has no value is there. */
export function isOn(element: Element, name: AttributeName): boolean {
  const text = element.getAttribute(name);
  return text !== null && isEmptyOrAllowed(name, text);
}

const isControls = (text: string): text is (typeof controlNames)[number] =>
  controlNames.some((name) => name === text);

/** What is to lie on the surface beside it; without a value, all. */
export function controlsOf(element: Element): (typeof controlNames)[number] {
  if (!isOn(element, 'controls')) return 'legend';
  const text = element.getAttribute('controls')!;
  return isControls(text) ? text : 'full';
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
