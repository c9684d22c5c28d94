// The state of the page, written as the fragment of its address and read from it. Words that cannot
// be understood are left out silently: the rest still holds.

import {
  type CameraView,
  type GirthMethod,
  isShownName,
  parseSection,
  parsePath,
  parseTwoPoints,
  readCamera,
  readCount,
  readNumber,
  readPoint,
  writeCamera,
  writePoint,
} from '../../src/element/index.js';
import type {
  FieldName,
  PrepareOptions,
  SpectralOptions,
  SurfacePoint,
  TubeReference,
} from '../../src/kernel/index.js';

export const panelNames = [
  'loops',
  'sections',
  'tube',
  'tips',
  'limbs',
  'necks',
  'parts',
  'print',
  'compare',
] as const;
export type PanelName = (typeof panelNames)[number];

export interface PageState {
  /** An example's name, or the address of a model. */
  model?: string;
  /** The name of a file that was dropped: a link cannot have the file itself. */
  file?: string;
  /** Holes were closed; only these components were kept; it was remeshed to so many faces. */
  closed?: boolean;
  /** Vertices no farther apart than this were joined, in model units. */
  weld?: number;
  components?: number[];
  faces?: number;
  /** Handles and tunnels shorter than this, in model units, were taken away after remeshing. */
  handles?: number;
  /** The unit of lengths, where the file does not say it. */
  unit?: string;
  /** The unit that lengths are written in, where that is another one. */
  shown?: string;
  /** How many times as large as its file the model is. */
  scale?: number;
  field?: string;
  /** Which number of a signature is shown: see the element's attributes of these names. */
  time?: number;
  energy?: number;
  component?: number;
  colormap?: string;
  /** The value of the element's attribute: two numbers or two percentages. */
  range?: string;
  isolines?: number;
  /**
   * The value of the element's attribute: the method of the girth, where it is not the usual one
   * for the model.
   */
  method?: GirthMethod;
  /** The value of the element's attribute: how long saddles must last to count. */
  persistence?: string;
  edges?: boolean;
  /** Whether the colour map is logarithmic. */
  log?: boolean;
  /** Values of the element's attributes: how the surface is drawn, and the way up, if chosen. */
  shading?: string;
  up?: string;
  /** The value of the element's attribute. */
  section?: string;
  camera?: CameraView;
  /** The points whose loops are pinned. */
  loops?: SurfacePoint[];
  /** The names of the loops, in their order; '' for no name. */
  names?: string[];
  /** The lengths of the loops as they were shown: for a reader who does not have the file. */
  values?: string[];
  /** The thresholds of parts, in model units, and their smoothing. */
  girth?: number;
  diameter?: number;
  smoothing?: number;
  /** The selected tip, from 1; tips that jump less are hidden. */
  tip?: number;
  jump?: number;
  /** Limits of printing, in model units, and the key of the preset that they come from. */
  tube?: number;
  wall?: number;
  gap?: number;
  printer?: string;
  /** The two points whose bottleneck is shown, or the girth along the path between them, or through more. */
  bottleneck?: SurfacePoint[];
  profile?: SurfacePoint[];
  /** The limb along whose axis the girth is shown, from 1. */
  axis?: number;
  /** The names of limbs, longest limb first; '' for no name. */
  limbNames?: string[];
  /** The diameter that narrowings and widenings of tubes are compared with, where it is not the taper. */
  reference?: TubeReference;
  /** Necks are listed that stand out by at least so much, in model units. */
  prominence?: number;
  /** Along what the surface is shown cut, and that the rims are left open. */
  cut?: CutWish;
  rims?: boolean;
  /** The model beside the shown one: an example's name or an address; or the name of an opened file. */
  beside?: string;
  besideFile?: string;
  /** Whether each of the two has a view of its own, and whether their colours span one range. */
  apart?: boolean;
  oneScale?: boolean;
  panel?: PanelName;
}

/**
 * All necks that are listed; one neck or handle, by its number as `girth necks` and `girth handles` print it; the
 * bottleneck of the two points; the loops that are pinned; or where the girth has a value, in model units.
 */
export type CutWish =
  | 'necks'
  | `neck:${number}`
  | `handle:${number}`
  | 'bottleneck'
  | 'pin'
  | `at:${string}`;

/** A cut where the girth has a value. */
export const cutAt = (girth: number): CutWish => `at:${writeLimit(girth)}`;
/** The girth that a cut is made at; undefined for other cuts. */
export const girthOfCut = (cut: CutWish | undefined): number | undefined =>
  cut?.startsWith('at:') ? Number(cut.slice(3)) : undefined;

/** More loops than these are not pinned from a link: each costs a computation. */
const mostLoops = 50;
const mostComponents = 1000;
/** Letters of a loop's name. */
export const longestName = 60;

/** Angles and shares to what can be seen. */
function short(value: number): string {
  // No '-0'.
  return String(Number(value.toFixed(4)) + 0);
}

/** Not negative; thresholds may be infinite. */
function readThreshold(text: string): number | undefined {
  if (text === 'inf') return Infinity;
  const number = readNumber(text);
  return number !== undefined && number >= 0 ? number : undefined;
}

function readWeld(text: string): number | undefined {
  const distance = readNumber(text);
  return distance !== undefined && distance > 0 ? distance : undefined;
}

function readScale(text: string): number | undefined {
  const scale = readNumber(text);
  return scale !== undefined && scale >= 1e-12 && scale <= 1e12 ? scale : undefined;
}

function readWord(text: string): string | undefined {
  return /^[a-z][a-z0-9-]{0,30}$/i.test(text) ? text : undefined;
}

function readShown(text: string): string | undefined {
  return text.length <= 130 && isShownName(text) ? text : undefined;
}

function readSection(text: string): string | undefined {
  return text.length <= 100 && parseSection(text) ? text : undefined;
}

/** Two ascending numbers, or percentages. */
function readRange(text: string): string | undefined {
  const ends = text.split(' ');
  const isPercent = ends.every((end) => end.endsWith('%'));
  const [low, high] = ends.map((end) => readNumber(isPercent ? end.slice(0, -1) : end));
  if (ends.length !== 2 || low === undefined || high === undefined || !(low < high))
    return undefined;
  if (isPercent && (low < 0 || high > 100)) return undefined;
  return text;
}

/** A share of the square root of the area, or a length. */
function readPersistence(text: string): string | undefined {
  return /^\d[\d.]{0,12}( ?[a-zµ]{1,3}|%)?$/i.test(text) ? text : undefined;
}

function readReference(text: string): TubeReference | undefined {
  return (['mean', 'before', 'beyond'] as const).find((reference) => reference === text);
}

function readMethod(text: string): GirthMethod | undefined {
  return (['exact', 'coarse', 'refined'] as const).find((method) => method === text);
}

function readAll<Type>(
  text: string,
  most: number,
  read: (text: string) => Type | undefined,
): Type[] | undefined {
  const read_ = text
    .split(',')
    .slice(0, most)
    .map(read)
    .filter((one) => one !== undefined);
  return read_.length > 0 ? read_ : undefined;
}

/** A relative address would mean something else on another page; others than these are no models. */
function readModel(text: string): string | undefined {
  if (readWord(text)) return text;
  try {
    const { protocol, href } = new URL(text);
    return protocol === 'https:' || protocol === 'http:' ? href : undefined;
  } catch {
    return undefined;
  }
}

function readFile(text: string): string | undefined {
  return text.length <= 200 ? text : undefined;
}

const writePoints = (points: SurfacePoint[]): string => points.map(writePoint).join(',');

/** Names are escaped by themselves, so that one may have a comma in it. */
function readNames(text: string): string[] | undefined {
  const names = text
    .split(',')
    .slice(0, mostLoops)
    .map((name) => {
      try {
        return decodeURIComponent(name)
          .replace(/\p{Cc}/gu, '')
          .slice(0, longestName);
      } catch {
        return '';
      }
    });
  return names.some((name) => name !== '') ? names : undefined;
}

const writeNames = (names: string[]): string => names.map(encodeURIComponent).join(',');

/** Numbers with or without a unit: '83.5 mm'. */
function readValue(text: string): string | undefined {
  return /^[\d.]{1,20}( [a-zµ]{1,3})?$/.test(text) ? text : undefined;
}

/** A length without the digits that only a change of the unit has brought. */
const writeLimit = (length: number): string => String(Number(length.toPrecision(12)));
const readUp = (text: string): string | undefined => (/^-?[xyz]$/.test(text) ? text : undefined);
const readFlag = (text: string): boolean | undefined => (text === '1' ? true : undefined);
function readCut(text: string): CutWish | undefined {
  if (text.startsWith('at:')) {
    const girth = readNumber(text.slice(3));
    return girth !== undefined && girth > 0 ? cutAt(girth) : undefined;
  }
  const isNamed = /^(necks|bottleneck|pin|(neck|handle):[1-9]\d{0,5})$/.test(text);
  return isNamed ? (text as CutWish) : undefined;
}
const readPanel = (text: string): PanelName | undefined => panelNames.find((name) => name === text);

type Reader<Type> = (text: string) => Type | undefined;
type Writer<Type> = (value: Type) => string;

/** How each part of the state is read and written; their order in the fragment. */
const parts: {
  [Key in keyof PageState]-?: [Reader<PageState[Key]>, Writer<NonNullable<PageState[Key]>>];
} = {
  model: [readModel, (model) => model],
  file: [readFile, (file) => file],
  closed: [readFlag, () => '1'],
  weld: [readWeld, String],
  components: [(text) => readAll(text, mostComponents, readCount), (numbers) => numbers.join(',')],
  faces: [readCount, String],
  handles: [readThreshold, (length) => (length === Infinity ? 'inf' : writeLimit(length))],
  unit: [readWord, (unit) => unit],
  shown: [readWord, (unit) => unit],
  scale: [readScale, String],
  field: [readShown, (field) => field],
  time: [readThreshold, String],
  energy: [readCount, String],
  component: [readCount, String],
  colormap: [readWord, (name) => name],
  range: [readRange, (range) => range],
  isolines: [readCount, String],
  method: [readMethod, (method) => method],
  persistence: [readPersistence, (persistence) => persistence],
  edges: [readFlag, () => '1'],
  log: [readFlag, () => '1'],
  shading: [readWord, (look) => look],
  up: [readUp, (up) => up],
  section: [readSection, (section) => section],
  camera: [readCamera, (camera) => writeCamera(camera, short)],
  loops: [(text) => readAll(text, mostLoops, readPoint), writePoints],
  names: [readNames, writeNames],
  values: [(text) => readAll(text, mostLoops, readValue), (values) => values.join(',')],
  girth: [readThreshold, (girth) => (girth === Infinity ? 'inf' : String(girth))],
  diameter: [readThreshold, (diameter) => (diameter === Infinity ? 'inf' : String(diameter))],
  smoothing: [readThreshold, String],
  tip: [readCount, String],
  jump: [readThreshold, (jump) => String(Number(jump.toPrecision(6)))],
  tube: [readThreshold, writeLimit],
  wall: [readThreshold, writeLimit],
  gap: [readThreshold, writeLimit],
  printer: [readWord, (key) => key],
  bottleneck: [parseTwoPoints, writePoints],
  profile: [parsePath, writePoints],
  axis: [readCount, String],
  limbNames: [readNames, writeNames],
  reference: [readReference, (reference) => reference],
  prominence: [readThreshold, writeLimit],
  cut: [readCut, (cut) => cut],
  rims: [readFlag, () => '1'],
  beside: [readModel, (model) => model],
  besideFile: [readFile, (file) => file],
  apart: [readFlag, () => '1'],
  oneScale: [readFlag, () => '1'],
  panel: [readPanel, (panel) => panel],
};

/** The steps that prepared a model before it was shown, as the kernel has them. */
export function preparationOf({ closed, weld, components, scale }: PageState): PrepareOptions {
  return {
    ...(closed ? { closeHoles: true } : {}),
    ...(weld === undefined ? {} : { weldDistance: weld }),
    ...(components ? { components } : {}),
    ...(scale === undefined ? {} : { scale }),
  };
}

/** Which number of its signature a field was, as a state has it. */
export function spectralIn(state: PageState, name: FieldName): SpectralOptions | undefined {
  const { time, energy, component } = state;
  if (name === 'hks') return time === undefined ? undefined : { time };
  const number = name === 'wks' ? energy : name === 'sihks' ? component : undefined;
  return number === undefined ? undefined : { component: number };
}

/** The part of a state that is about the model beside. */
export function besideOf({ beside, besideFile, apart, oneScale }: PageState): PageState {
  return {
    ...(beside === undefined ? {} : { beside }),
    ...(besideFile === undefined ? {} : { besideFile }),
    ...(apart ? { apart } : {}),
    ...(oneScale ? { oneScale } : {}),
  };
}

/** The state for a model that is `ratio` times as large: its lengths grow with it. */
export function resized(state: PageState, ratio: number): PageState {
  const grown = { ...state };
  for (const key of ['weld', 'handles', 'girth', 'diameter', 'jump', 'prominence'] as const) {
    const length = state[key];
    if (length !== undefined) grown[key] = length * ratio;
  }
  const at = girthOfCut(state.cut);
  if (at !== undefined) grown.cut = cutAt(at * ratio);
  // Persistence depends on the model's size; shares hold for any.
  if (state.persistence !== undefined && !state.persistence.endsWith('%')) delete grown.persistence;
  // The numbers of a range may be lengths, in any unit; shares of the surface hold for any size.
  if (state.range !== undefined && !state.range.includes('%')) delete grown.range;
  return grown;
}

/** The state as text, without the '#' in front. */
export function writeState(state: PageState): string {
  const words: string[] = [];
  for (const [key, [, write]] of Object.entries(parts)) {
    const value = state[key as keyof PageState];
    if (value === undefined || value === false || (Array.isArray(value) && value.length === 0))
      continue;
    const text = (write as Writer<unknown>)(value);
    // Legible where the rules for addresses allow it.
    words.push(`${key}=${encodeURIComponent(text).replace(/%(2C|3A|2F|40)/g, decodeURIComponent)}`);
  }
  return words.join('&');
}

/** The state that a text holds, with or without the '#' in front. */
export function readState(fragment: string): PageState {
  const state: PageState = {};
  for (const word of fragment.replace(/^#/, '').split('&')) {
    const [key = '', ...rest] = word.split('=');
    if (!Object.hasOwn(parts, key)) continue;
    let text: string;
    try {
      text = decodeURIComponent(rest.join('=').replace(/\+/g, ' '));
    } catch {
      continue;
    }
    if (text === '') continue;
    const value = parts[key as keyof PageState][0](text);
    if (value !== undefined) Object.assign(state, { [key]: value });
  }
  return state;
}
