// A picture of the surface as a figure: with its legend, the labels of its loops and a scale bar.

import { type LegendContent, type LengthFormat, drawLegend } from '../../view/index.js';
import type { TagLabel } from '../controls/readout.js';

/** Options of a picture beside the surface. */
export interface FigureOptions {
  /** Colours with their numbers, and the labels of pinned loops. Default: false. */
  legend?: boolean;
  /** A round length, true at the distance of what the camera looks at. Default: false. */
  scaleBar?: boolean;
  /** Nothing behind the surface, not even its shadow, rather than the element's paper. Default: true without a legend. */
  transparent?: boolean;
  /** The width in pixels. Default: as on the screen. */
  width?: number;
  /** The width on paper, in place of `width`, at `dotsPerInch`, which is then 300 by default. */
  millimetres?: number;
  /**
   * The density of the print, in pixels for each inch: words are at least seven points high.
   * Default: not stated.
   */
  dotsPerInch?: number;
}

const millimetresPerInch = 25.4;
/** Pixels for each inch, as printers have them. */
export const printDensity = 300;

/** The width of a picture in pixels, undefined as on the screen, and its density. */
export function sizeOf({ width, millimetres, dotsPerInch }: FigureOptions): {
  width: number | undefined;
  dotsPerInch: number | undefined;
} {
  if (millimetres === undefined) return { width, dotsPerInch };
  const density = dotsPerInch ?? printDensity;
  return { width: Math.round((millimetres / millimetresPerInch) * density), dotsPerInch: density };
}

/** Whether there is nothing behind the surface. */
export const isTransparent = ({ transparent, legend }: FigureOptions): boolean =>
  transparent ?? !legend;

export interface FigureParts {
  legend: LegendContent | undefined;
  /** The tags with their places on the element, in CSS pixels. */
  labels: readonly TagLabel[];
  /** CSS pixels for each unit of length. */
  scale: number;
  format: LengthFormat;
  /** Writes a length: handed in, since pages that take no picture need it too. */
  lengthWords(this: void, length: number, format: LengthFormat): string;
}

const margin = 16;
const labelHeight = 22;
/** A label is so far from the end of its leader at least. */
const leastLeader = 6;
/** The height of letters, in units of the context, and on paper at least, in points. */
const letters = 13;
const smallestLetters = 7;
const pointsPerInch = 72;

/** The picture, which may be larger than the element, with what belongs to it. */
export function figure(
  picture: HTMLCanvasElement,
  parts: FigureParts,
  options: FigureOptions,
  element: HTMLElement,
): HTMLCanvasElement {
  const whole = document.createElement('canvas');
  [whole.width, whole.height] = [picture.width, picture.height];
  const context = whole.getContext('2d')!;
  const css = getComputedStyle(element);
  const colour = (name: string): string => css.getPropertyValue(name).trim();
  const isClear = isTransparent(options);
  if (!isClear) {
    context.fillStyle = colour('--girth-paper');
    context.fillRect(0, 0, whole.width, whole.height);
  }
  context.drawImage(picture, 0, 0);
  const ratio = picture.width / Math.max(1, element.clientWidth);
  const { dotsPerInch = 0 } = options;
  const zoom = Math.max(ratio, ((smallestLetters / pointsPerInch) * dotsPerInch) / letters);
  context.scale(zoom, zoom);
  const [width, height] = [picture.width / zoom, picture.height / zoom];
  /** Units of the context in a pixel of the element. */
  const shrink = ratio / zoom;
  const family = css.fontFamily || 'sans-serif';
  // Ink on a transparent ground is that for white paper.
  const ink = isClear ? '#1c1d21' : colour('--girth-ink');
  const quiet = isClear ? '#5d6069' : colour('--girth-quiet');
  context.font = `${letters}px ${family}`;
  if (options.legend) {
    if (parts.legend) {
      const barHeight = Math.min(150, 0.4 * height);
      drawLegend(
        context,
        parts.legend,
        { ink, quiet, family },
        [margin, height - margin],
        barHeight,
      );
    }
    for (const { words, x, y, end } of parts.labels) {
      const wide = context.measureText(words).width + 20;
      const to = { x: end.x * shrink, y: end.y * shrink };
      const room = { width: width - wide, height: height - labelHeight };
      const [left, top] = besideEnd(to, { x: x * shrink, y: y * shrink }, wide, room);
      drawLabel(context, words, wide, { x: left, y: top, end: to });
    }
  }
  const scaled = { ...parts, scale: parts.scale * shrink };
  if (options.scaleBar) drawScaleBar(context, scaled, ink, width - margin, height - margin);
  return whole;
}

/**
 * The left top corner of a label: within the picture, as it is larger there than on the screen, and off the end of its
 * leader. `room`: the greatest left and top.
 */
function besideEnd(
  end: { x: number; y: number },
  corner: { x: number; y: number },
  wide: number,
  room: { width: number; height: number },
): [left: number, top: number] {
  const within = (value: number, most: number): number => Math.max(0, Math.min(value, most));
  const [left, top] = [within(corner.x, room.width), within(corner.y, room.height)];
  const isClear =
    end.x < left - leastLeader ||
    end.x > left + wide + leastLeader ||
    end.y < top - leastLeader ||
    end.y > top + labelHeight + leastLeader;
  if (isClear) return [left, top];
  const above = end.y - labelHeight - 2 * leastLeader;
  return [left, above >= 0 ? above : within(end.y + 2 * leastLeader, room.height)];
}

function drawLabel(
  context: CanvasRenderingContext2D,
  words: string,
  width: number,
  { x, y, end }: Omit<TagLabel, 'words'>,
): void {
  const near = (value: number, from: number, size: number): number =>
    Math.max(from, Math.min(from + size, value));
  context.strokeStyle = '#ff7a45';
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(near(end.x, x, width), near(end.y, y, labelHeight));
  context.lineTo(end.x, end.y);
  context.stroke();
  context.fillStyle = 'rgb(20 21 24 / 0.86)';
  context.beginPath();
  context.roundRect(x, y, width, labelHeight, labelHeight / 2);
  context.fill();
  context.fillStyle = '#ffffff';
  context.textBaseline = 'middle';
  context.fillText(words, x + 10, y + labelHeight / 2);
}

/** The greatest round length that is at most so many pixels; none where there is no scale. */
export function scaleBarLength(most: number, scale: number, format: LengthFormat): number {
  const reach = (most / scale) * format.scale;
  const power = 10 ** Math.floor(Math.log10(reach));
  const [first = power] = [5, 2, 1].map((times) => times * power).filter((one) => one <= reach);
  return first / format.scale;
}

/** The length of a scale bar in words; `decimals` are those of a round length. */
export function scaleBarWords(
  length: number,
  format: LengthFormat,
  lengthWords: FigureParts['lengthWords'],
): string {
  const decimals = Math.max(0, -Math.floor(Math.log10(length * format.scale) + 1e-9));
  const words = lengthWords(length, { ...format, decimals });
  if (format.unit !== '') return words;
  return `${words} ${words === '1' ? 'unit' : 'units'} of the file`;
}

function drawScaleBar(
  context: CanvasRenderingContext2D,
  { scale, format, lengthWords }: FigureParts,
  ink: string,
  right: number,
  bottom: number,
): void {
  const length = scaleBarLength(160, scale, format);
  const width = length * scale;
  context.fillStyle = ink;
  context.fillRect(right - width, bottom - 3, width, 3);
  context.textBaseline = 'bottom';
  context.textAlign = 'center';
  const words = scaleBarWords(length, format, lengthWords);
  // The words may be wider than the bar: they stay within the picture.
  const half = Math.max(width, context.measureText(words).width) / 2;
  context.fillText(words, right - half, bottom - 7);
  context.textAlign = 'start';
}
