// Tips, parts and pinned loops, as words of the element's attributes: read, and written.

import type { SurfacePoint } from '../../kernel/types/types.js';
import { readLength } from '../../view/length-text.js';
import { readCount, readNumber, readPoint, writePoint } from './place-words.js';

/** More loops than these are not pinned by an attribute: each costs a computation. */
const mostPins = 1000;
/** A path is through no more points than these. */
export const mostPathPoints = 200;

/** Which tips are drawn. */
export interface TipsWish {
  /** The jump that tips rise by, at least: a length, with or without a unit. */
  leastJump: string;
  /** The number of the selected tip, from 1. */
  selected: number | undefined;
}

/** 'none'; all tips where it is empty or 'all'; a length, '#' with a number, or both as in '5mm #2'. */
export function parseTips(text: string): TipsWish | 'none' | undefined {
  if (text === 'none') return text;
  const [, words, number] = /^\s*(.*?)\s*(?:#(\d{1,6}))?\s*$/s.exec(text) ?? [];
  if (words === undefined) return undefined;
  const selected = number === undefined ? undefined : readCount(number);
  if (selected === 0) return undefined;
  if (words === '' || words === 'all' || words === 'true') return { leastJump: '0', selected };
  return isLength(words) ? { leastJump: words, selected } : undefined;
}

export function writeTips({ leastJump, selected }: TipsWish): string {
  const words = leastJump === '0' ? 'all' : leastJump;
  return selected === undefined ? words : `${words} #${selected}`;
}

/** Thresholds of tubes and plates: two lengths, with or without units, and the smoothing. */
export interface PartsWords {
  girth: string;
  shapeDiameter: string;
  smoothing: number;
}

/** Two lengths, or 'inf', and possibly a number from 0 on for the smoothing, with spaces between them. */
export function parseParts(text: string): PartsWords | undefined {
  const words = text.trim().split(/\s+/);
  if (words.length < 2 || words.length > 3) return undefined;
  const [girth, shapeDiameter, last = '0'] = words as [string, string, string?];
  const smoothing = readNumber(last);
  const areLengths = [girth, shapeDiameter].every((word) => word === 'inf' || isLength(word));
  if (!areLengths || smoothing === undefined || smoothing < 0) return undefined;
  return { girth, shapeDiameter, smoothing };
}

export function writeParts({ girth, shapeDiameter, smoothing }: PartsWords): string {
  return [girth, shapeDiameter, ...(smoothing === 0 ? [] : [smoothing])].join(' ');
}

/** A loop that is to be pinned. */
export interface PinWish {
  point: SurfacePoint;
  /** '' for none. */
  name: string;
}

/** 'none', or points with commas between them, each with or without a name behind it: '12 waist, 40:0.2:0.3'. */
export function parsePins(text: string): PinWish[] | undefined {
  if (text.trim() === 'none') return [];
  const words = text.split(',');
  if (words.length > mostPins) return undefined;
  const pins = words.map(parsePin);
  return pins.every((pin) => pin !== undefined) ? pins : undefined;
}

function parsePin(text: string): PinWish | undefined {
  const [, first = '', rest = ''] = /^\s*(\S+)\s*(.*?)\s*$/s.exec(text) ?? [];
  const point = readPoint(first);
  // A number there is a forgotten comma more often than a name.
  if (point === undefined || readPoint(rest.split(/\s/)[0]!) !== undefined) return undefined;
  try {
    return { point, name: decodeURIComponent(rest) };
  } catch {
    return undefined;
  }
}

export function writePins(pins: readonly PinWish[]): string {
  if (pins.length === 0) return 'none';
  return pins.map(({ point, name }) => `${writePoint(point)} ${escaped(name)}`.trim()).join(', ');
}

/** Legible but for what would be read as something else. */
function escaped(name: string): string {
  const words = name.replace(/[%,]|^\s|\s$|\p{Cc}/gu, encodeURIComponent);
  const [first] = words;
  const isNumber = readPoint(words.split(/\s/)[0]!) !== undefined;
  return isNumber && first ? `%${first.charCodeAt(0).toString(16)}${words.slice(1)}` : words;
}

/** Two points or more with commas between them, as in '12, 4031'; undefined for anything else. */
export function parsePath(text: string): SurfacePoint[] | undefined {
  const points = text.split(',').map((word) => readPoint(word.trim()));
  if (points.length < 2 || points.length > mostPathPoints) return undefined;
  return points.every((point) => point !== undefined) ? points : undefined;
}

/** Exactly two points with a comma between them; undefined for anything else. */
export function parseTwoPoints(text: string): SurfacePoint[] | undefined {
  const points = parsePath(text);
  return points?.length === 2 ? points : undefined;
}

/** The points as `parsePath` reads them. */
export function writePath(points: readonly SurfacePoint[]): string {
  return points.map(writePoint).join(', ');
}

const isLength = (text: string): boolean => 'length' in readLength(text, 'm');
