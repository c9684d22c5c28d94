// The surface's outline with its loops as SVG, for papers: lines as lines, words as text, all lengths on paper.

import { type OutlineScene, type Stroke, outlineOf, seenPieces } from '../../view/outline.js';
import type { FigureParts } from './snapshot.js';

/** Options of a drawing beside the outline. */
export interface DrawingOptions {
  /** The width on paper, in millimetres. Default: 85, one column of a paper. */
  width?: number;
  /** Names and lengths of the pinned loops. Default: true. */
  labels?: boolean;
  /** A round length, true at the distance of what the camera looks at. Default: true. */
  scaleBar?: boolean;
}

/** A line on the surface: x, y, z of its points, and its CSS colour. */
export interface DrawnLine {
  polyline: ArrayLike<number>;
  colour: string;
}

export interface Drawing {
  scene: OutlineScene;
  lines: readonly DrawnLine[];
  parts: FigureParts;
  /** The width of the element, in CSS pixels. */
  width: number;
  height: number;
  /** The title of the drawing. */
  title: string;
  /** How long the scale bar is, in model units, for at most so many pixels. */
  barLength(this: void, most: number, scale: number, format: FigureParts['format']): number;
  /** Its words. */
  barWords(
    this: void,
    length: number,
    format: FigureParts['format'],
    lengthWords: FigureParts['lengthWords'],
  ): string;
}

const usualWidth = 85;
const ink = '#1c1d21';
/** Widths of lines and the height of letters, in millimetres on paper. */
const outlineWidth = 0.3;
const creaseWidth = 0.15;
const loopWidth = 0.45;
const letters = 2.8;
/** The size of a tag on the page, about, in CSS pixels. */
const tagPadding = 20;
const letterWidth = 7;

const escaped = (text: string): string =>
  text.replace(/[&<>"]/g, (letter) => `&#${letter.charCodeAt(0)};`);
const short = (length: number): string => String(Number(length.toFixed(2)));

/** The strokes as the `d` of a path. */
const pathOf = (strokes: readonly Stroke[]): string =>
  strokes
    .map((stroke) => {
      const points: string[] = [];
      for (let i = 0; i < stroke.length; i += 2) {
        points.push(`${short(stroke[i]!)} ${short(stroke[i + 1]!)}`);
      }
      return `M${points.join('L')}`;
    })
    .join('');

/** The drawing as a file's content. */
export function drawingSvg(
  { scene, lines, parts, width, height, title, barLength, barWords }: Drawing,
  { width: paper = usualWidth, labels = true, scaleBar = true }: DrawingOptions,
): string {
  /** CSS pixels of a millimetre on paper. */
  const unit = width / paper;
  const of = (millimetres: number): string => short(millimetres * unit);
  const { contours, creases } = outlineOf(scene);
  const path = (kind: string, strokes: readonly Stroke[], attributes: string): string =>
    strokes.length > 0 ? `<path class="${kind}" d="${pathOf(strokes)}" ${attributes}/>\n` : '';
  const looped = lines.map(({ polyline, colour }) => {
    const { seen, hidden } = seenPieces(scene, polyline);
    const stroke = `stroke="${colour}" stroke-width="${of(loopWidth)}"`;
    const dashes = `stroke-dasharray="${of(0.6)} ${of(0.9)}" stroke-opacity="0.6"`;
    return path('hidden', hidden, `${stroke} ${dashes}`) + path('loop', seen, stroke);
  });
  const body =
    path('crease', creases, `stroke="${ink}" stroke-width="${of(creaseWidth)}"`) +
    path('contour', contours, `stroke="${ink}" stroke-width="${of(outlineWidth)}"`) +
    looped.join('');
  const words: string[] = [];
  const text = (x: number, y: number, content: string, attributes = ''): string =>
    `<text x="${short(x)}" y="${short(y)}"${attributes}>${escaped(content)}</text>\n`;
  if (labels) {
    for (const { words: content, x, y, end } of parts.labels) {
      const middle = y + (letters * unit) / 2;
      const leader = `stroke="${ink}" stroke-width="${of(creaseWidth)}"`;
      // The words lie beside the end of the leader that is away from the loop.
      const wide = tagPadding + letterWidth * content.length;
      const isLeft = end.x > x + wide / 2;
      const near = isLeft ? x + wide : x;
      const gap = isLeft ? -0.5 * unit : 0.5 * unit;
      const anchor = isLeft ? ' text-anchor="end"' : '';
      words.push(
        `<path d="M${short(near)} ${short(middle)}L${short(end.x)} ${short(end.y)}" ${leader}/>\n`,
        text(near + gap, middle + 0.35 * letters * unit, content, anchor),
      );
    }
  }
  if (scaleBar) {
    const { scale, format, lengthWords } = parts;
    const length = barLength(0.3 * width, scale, format);
    const [right, bottom] = [width - 2 * unit, height - 2 * unit];
    const left = right - length * scale;
    words.push(
      `<path d="M${short(left)} ${short(bottom)}H${short(right)}" stroke="${ink}" stroke-width="${of(0.6)}"/>\n`,
      text(right, bottom - unit, barWords(length, format, lengthWords), ' text-anchor="end"'),
    );
  }
  const size = `width="${paper}mm" height="${short((paper * height) / width)}mm"`;
  const halo = `paint-order="stroke" stroke="#ffffff" stroke-width="${of(0.5)}" stroke-linejoin="round"`;
  const written = words.filter((one) => one.startsWith('<text')).join('');
  const drawn = words.filter((one) => one.startsWith('<path')).join('');
  return `<svg xmlns="http://www.w3.org/2000/svg" ${size} viewBox="0 0 ${short(width)} ${short(height)}">
<title>${escaped(title)}</title>
<g fill="none" stroke-linecap="round" stroke-linejoin="round">
${body}${drawn}</g>
<g font-family="Helvetica, Arial, sans-serif" font-size="${of(letters)}" fill="${ink}" ${halo}>
${written}</g>
</svg>
`;
}
