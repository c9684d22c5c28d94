// The values that each attribute of the element can have. Any other value counts as if the
// attribute were not there.

import { signatureNumbers } from '../../kernel/types/fields.js';
import { findLengthUnit, lengthUnits } from '../../kernel/types/length-units.js';
import type { GirthErrorFields } from '../../kernel/types/types.js';
import { colormapNames } from '../../view/colormap-names.js';
import { derivedNames, fieldNames, isShownName } from '../../view/field-words.js';
import { readLengthOrShare } from '../../view/length-text.js';
import { lookNames } from '../../view/look.js';
import { straightNames } from '../../view/straight-names.js';
import { upNames } from '../../view/up-axis.js';
import type { GirthViewerAttributes } from './attribute-types.js';
import { mostIsolines, parseRange } from './parse.js';
import { readCamera } from './place-words.js';
import { parseSection } from './section-words.js';
import { parseParts, parsePath, parsePins, parseTips, parseTwoPoints } from './wish-words.js';

interface Rule {
  /** The allowed values in words that follow 'it can be'. */
  allowed: string;
  accepts(text: string): boolean;
  /** Set where the attribute asks for something without a value, too. */
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

/** A switch: without a value, or with one that frameworks write. */
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

/** Controls on the surface: none, the legend, or the legend and a bar. */
const controlNames = ['none', 'legend', 'full'] as const;

/** In the order in which they are set together. Their comments are the manual: `npm run build:tables` copies them. */
const rules: Record<AttributeName, Rule> = {
  /** Address of a model: GLB, glTF with its buffers beside it, OBJ, PLY, STL, OFF, or a zip. */
  src: { allowed: 'the address of a model', accepts: () => true },
  /**
   * `lazy` fetches nothing but a small script before the element is near the view; by default,
   * `eager`, the script that draws comes at once, and only the model waits for the view.
   */
  loading: oneOf(['eager', 'lazy']),
  /**
   * Address of a picture that is shown until the surface is drawn, and where it cannot be drawn. An
   * element in the slot `poster` serves as well.
   */
  poster: { allowed: 'the address of a picture', accepts: () => true },
  /** The unit of lengths where the file does not state it, for example `mm`. */
  unit: lengthUnit,
  /**
   * The unit that lengths are written in: `um`, `mm`, `cm`, `m`, `km`, `in` or `ft`; by default the
   * model's own. Files that are exported keep the model's.
   */
  'shown-unit': lengthUnit,
  /**
   * The field that colours the surface: one of the kernel (`FieldName`; `igf`, the girth, by default),
   * `kind` (of the loop), `state` (how sure a refined girth is), `tips` (how far the girth rises at
   * the tip that a place is in), `parts` (tubes, plates and body) or `none`; values of the file as
   * in `_heat`; or two of these in one: their difference, `igf-sdf`, where they have the same unit,
   * or their ratio, `igf/sdf`.
   */
  field: {
    allowed: listed([
      ...[...fieldNames, ...derivedNames, 'none', 'values of the file as in _heat'],
      'two of these as in igf-sdf, igf/sdf',
    ]),
    accepts: (text) => isShownName(text.replace(/_\w+/g, (own) => own.toLowerCase())),
  },
  /** The field's name in the legend; by default its usual name. */
  'field-title': { allowed: 'words for the legend', accepts: () => true },
  /**
   * `viridis` (default), `cividis`, `plasma`, `magma`, `turbo`, or `rdbu`, which diverges and is
   * the default for differences, round 0, and where values have both signs.
   */
  colormap: oneOf(colormapNames),
  /**
   * `auto` (default), the body of the values, without what few places stretch it by; two numbers,
   * the values at the ends of the colour map; or two percentages as in `5% 95%`, the shares of the
   * surface's area that lie below them.
   */
  range: {
    allowed: 'auto, two rising numbers as in 1 2.5, or two rising shares as in 5% 95%',
    accepts: (text) => text === 'auto' || parseRange(text) !== undefined,
  },
  /** So many lines of equal value between the ends of the range; none by default. */
  isolines: wholeNumber(0, mostIsolines),
  /** The colour map is logarithmic, where all values in it are above 0. */
  log: flag,
  /**
   * How the girth is computed. `exact` (default); `coarse`, on about 10,000 triangles, whose values
   * are carried back to all vertices; `refined`, at all vertices in a fraction of the time, with
   * states and an audit (`RefinedGirth`), for surfaces of more than some 20,000 triangles. The
   * colours are those of `coarse` until a refined girth is there; with a `persistence` it is
   * `coarse`.
   */
  method: oneOf(['exact', 'coarse', 'refined']),
  /**
   * Passes over loops whose saddles last no longer than this, as noise makes them: a length in
   * model units or with a unit, as in `0.5` or `3mm`, or a share of the square root of the area, as
   * in `2%`. It holds for the girth, for what is made of it and for loops; pinned ones are computed
   * anew.
   */
  persistence: {
    allowed: 'a length as in 0.5 or 3mm, or a share of the square root of the area as in 2%',
    accepts: (text) => 'length' in readLengthOrShare(text, 'm', 1),
  },
  /**
   * The time of `hks`, as a share of the surface's area, `0.002` by default; small times see small details.
   */
  time: {
    allowed: 'a number above 0',
    accepts: (text) => Number(text) > 0 && Number.isFinite(Number(text)),
  },
  /** The energy of `wks`, from `1` (low: the whole shape) to `100` (details); `20` by default. */
  energy: wholeNumber(1, signatureNumbers.wks.count),
  /**
   * The frequency of `sihks`, from `1` (default) to `19`. Changed while its field is shown, each
   * of these three computes it anew.
   */
  component: wholeNumber(1, signatureNumbers.sihks.count),
  /**
   * `hover` (default), `none`, or vertices whose loops are pinned once the model is there, as in
   * `loop="12 4031"`.
   */
  loop: {
    allowed: 'hover, none, or vertices as in 12 4031',
    accepts: (text) => /^(hover|none|[\s,]*\d+([\s,]+\d+)*[\s,]*)$/.test(text),
  },
  /**
   * The loops that are pinned, with commas between them, and with their names: `pins="12 waist,
   * 4031"`. A point of a face is the face and two of its weights: `7:0.2:0.3`. `%2C` is a comma of
   * a name. `none` pins none, not even those that the file has.
   */
  pins: {
    allowed:
      'none, or vertices with commas between them, each with or without a name, as in 12 waist, 4031; or points as in 7:0.2:0.3, a face and two of its weights',
    accepts: (text) => parsePins(text) !== undefined,
  },
  /**
   * Draws the tips: all; those that rise at least so much, as in `5mm`; and marks one, as in `#2`
   * or `5mm #2`, the highest being 1. `none` draws none, not even those that the file has.
   */
  tips: {
    allowed: 'none, all, a length as in 5mm that they rise at least, and # with the number of one',
    accepts: (text) => parseTips(text) !== undefined,
    isBare: true,
  },
  /**
   * The girth and the shape diameter where tubes and plates begin, and the smoothing, as in
   * `parts="200mm 50mm 0.1"`; by default as the model's own values suggest. `field="parts"` colours
   * by them.
   */
  parts: {
    allowed:
      'the girth and the shape diameter where tubes and plates begin, as in 200mm 50mm, and a number for the smoothing',
    accepts: (text) => parseParts(text) !== undefined,
  },
  /**
   * Two points, as in `bottleneck="12, 4031"`: they are marked, and the narrowest loop on the
   * widest way between them is drawn.
   */
  bottleneck: twoPoints,
  /**
   * Two points or more, up to 200: the shortest path through them is drawn, and its points are
   * marked; of more than twelve, its ends.
   */
  profile: path,
  /**
   * From where the surface is seen: `front`, `side`, `top`, or the six numbers of a `CameraView`:
   * `polar`, `azimuth`, `distance` and the three of `target`; by default from where it is seen
   * whole.
   */
  camera: {
    allowed: `${listed(straightNames)}, or six numbers: polar angle and azimuth in radians, distance and the target’s x, y, z`,
    accepts: (text) =>
      straightNames.some((name) => name === text) || readCamera(text) !== undefined,
  },
  /** Draws the mesh's edges. */
  edges: flag,
  /** `smooth` (default); `flat`, so that each face can be seen; or `transparent`. */
  shading: oneOf(lookNames),
  /**
   * Cuts away what lies beyond a plane across a direction of the file, `x`, `-y` or three numbers,
   * and a share of the surface's extent along it: `x 40%` leaves the first 40% along x. The inside
   * is drawn plainly; what is cut away is not picked.
   */
  section: {
    allowed: 'a direction and the share along it that is left, as in x 40%',
    accepts: (text) => parseSection(text) !== undefined,
  },
  /**
   * The direction of the file that is up: `y`, `z`, `-y`, `-z`, `x` or `-x`. Default: the format's
   * convention (y of glTF and OBJ, z of STL), otherwise a guess from the shape; see `upAxis`.
   */
  up: oneOf(upNames),
  /** The next model is seen from where this one is, in sizes of the models. */
  'keep-view': flag,
  /**
   * A name. Elements of a page that have the same one are seen from the same place, in radii of
   * each surface: to move one moves all, within the frame. As at first, by `0` or `resetView`, all
   * surfaces are seen whole.
   */
  linked: named,
  /**
   * A name. The colours of elements that have the same one, and show the same field, span one
   * range: from the least to the greatest that each would show alone, whatever their units; or the
   * two numbers of `range` of one of them.
   */
  'one-scale': named,
  /**
   * Controls beside the surface: `none`; the `legend` (default); or `full`, and without a
   * value, a small bar too: first view, axes and straight views, drawing, pause.
   */
  controls: {
    allowed: listed(controlNames),
    accepts: (text) => text === 'true' || text === 'controls' || isControls(text),
    isBare: true,
  },
  /**
   * Turns slowly once it is computed and until something is done on the page, unless the system
   * asks for reduced motion; with a button that stops it.
   */
  turn: flag,
};

/** The details of `error` for a wrong attribute. */
interface AttributeFault extends GirthErrorFields {
  attribute: AttributeName;
}

/** An attribute that the element follows. */
export type AttributeName = keyof GirthViewerAttributes;

/** All of them. */
export const attributeNames = Object.keys(rules) as AttributeName[];

const isEmptyOrAllowed = (name: AttributeName, text: string): boolean =>
  text === '' || (rules[name] === flag && text === name) || rules[name].accepts(text);

/** The allowed values in words, where a value is none of them; undefined where all is well. */
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

/** The controls that an element wishes for; without a value, all. */
export function controlsOf(element: Element): (typeof controlNames)[number] {
  if (!isOn(element, 'controls')) return 'legend';
  const text = element.getAttribute('controls')!;
  return isControls(text) ? text : 'full';
}

/** Characters of a wrong value that are repeated. */
const mostQuoted = 60;
/** Wrong attributes that have been reported on the console, by any element. */
const saidOnConsole = new Set<string>();

/** The fault of a value, as sent with `error`, once written on the console; undefined for none. */
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
