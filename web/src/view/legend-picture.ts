// A legend drawn into a picture.

import { colormapStops } from './colormaps.js';
import { type LegendContent, headingOf, linePlaces, ticksOf } from './legend.js';

export interface LegendInk {
  /** CSS colours of numbers and of quieter words. */
  ink: string;
  quiet: string;
  /** A CSS font family. */
  family: string;
}

const fontSize = 13;
const lineHeight = 20;
const barWidth = 10;
const longestLine = 220;

/**
 * Draws a legend with its lower left corner at a point. Lengths are in units of the context, which are
 * CSS pixels of the element; `barHeight` is that of a colour map's bar.
 */
export function drawLegend(
  context: CanvasRenderingContext2D,
  content: LegendContent,
  { ink, quiet, family }: LegendInk,
  [left, bottom]: readonly [number, number],
  barHeight: number,
): void {
  context.save();
  context.font = `${fontSize}px ${family}`;
  context.textBaseline = 'middle';
  let y = bottom;
  if (content.note) {
    context.fillStyle = quiet;
    for (const line of linesOf(context, content.note).reverse()) {
      context.fillText(line, left, y - lineHeight / 2);
      y -= lineHeight;
    }
    y -= 4;
  }
  if ('range' in content) {
    const top = y - barHeight;
    const gradient = context.createLinearGradient(0, y, 0, top);
    const colours = colormapStops(content.colormap).split(', ');
    colours.forEach((colour, i) => gradient.addColorStop(i / (colours.length - 1), colour));
    context.fillStyle = gradient;
    context.beginPath();
    context.roundRect(left, top, barWidth, barHeight, barWidth / 2);
    context.fill();
    context.fillStyle = 'rgb(255 255 255 / 0.7)';
    for (const place of linePlaces(content.isolines)) {
      context.fillRect(left, y - place * barHeight - 0.5, barWidth, 1);
    }
    context.fillStyle = ink;
    for (const { place, text } of ticksOf(content)) {
      context.fillText(text, left + 18, y - place * barHeight);
    }
    y = top - 14;
  } else {
    for (const { name, colour, hatched } of [...content.categories].reverse()) {
      const top = y - lineHeight + (lineHeight - 12) / 2;
      context.fillStyle = colour;
      context.beginPath();
      context.roundRect(left, top, 12, 12, 3);
      context.fill();
      if (hatched) drawStripes(context, left, top, 12);
      context.fillStyle = ink;
      context.fillText(name, left + 20, y - lineHeight / 2);
      y -= lineHeight;
    }
    y -= 4;
  }
  context.fillStyle = quiet;
  context.fillText(headingOf(content), left, y - lineHeight / 2);
  context.restore();
}

/** Words in lines that are not too long. */
function linesOf(context: CanvasRenderingContext2D, words: string): string[] {
  const lines: string[] = [];
  for (const word of words.split(' ')) {
    const longer = `${lines.at(-1) ?? ''} ${word}`;
    if (lines.length > 0 && context.measureText(longer).width <= longestLine) {
      lines[lines.length - 1] = longer;
    } else {
      lines.push(word);
    }
  }
  return lines;
}

/** Dark slanting stripes over a square. */
function drawStripes(
  context: CanvasRenderingContext2D,
  left: number,
  top: number,
  size: number,
): void {
  context.save();
  context.beginPath();
  context.roundRect(left, top, size, size, 3);
  context.clip();
  context.strokeStyle = 'rgb(0 0 0 / 0.3)';
  context.lineWidth = 2.5;
  for (let x = -size; x < size; x += 5) {
    context.beginPath();
    context.moveTo(left + x, top + size);
    context.lineTo(left + x + size, top);
    context.stroke();
  }
  context.restore();
}
