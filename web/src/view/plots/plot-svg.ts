// A plot as SVG: lines and bars as shapes, numbers as text. Marks that a plot paints on its canvas by itself are
// written down by a pen that has as much of a canvas as plots use.

/** The pen that plots paint with: a part of a canvas's context. */
export type PlotPen = Pick<
  CanvasRenderingContext2D,
  | 'save'
  | 'restore'
  | 'beginPath'
  | 'moveTo'
  | 'lineTo'
  | 'rect'
  | 'clip'
  | 'stroke'
  | 'fillRect'
  | 'drawImage'
  | 'fillStyle'
  | 'strokeStyle'
  | 'lineWidth'
  | 'globalAlpha'
  | 'imageSmoothingEnabled'
>;

interface PenState {
  fillStyle: PlotPen['fillStyle'];
  strokeStyle: PlotPen['strokeStyle'];
  lineWidth: number;
  globalAlpha: number;
  /** The rectangle that it is confined to. */
  clip: readonly number[] | undefined;
}

const short = (length: number): string => String(Number(length.toFixed(2)));
/** Plots paint in plain colours. */
const colourOf = (style: PlotPen['fillStyle']): string =>
  typeof style === 'string' ? style : 'none';
/** Text that is no markup. */
const escaped = (text: string): string =>
  text.replace(/[&<>"]/g, (letter) => `&#${letter.charCodeAt(0)};`);

/** Writes down as SVG what is painted. Paths are lines, and clipping is by one rectangle. */
export class SvgPen implements PlotPen {
  fillStyle: PlotPen['fillStyle'] = '#000000';
  strokeStyle: PlotPen['strokeStyle'] = '#000000';
  lineWidth = 1;
  globalAlpha = 1;
  imageSmoothingEnabled = true;
  #clip: readonly number[] | undefined;
  #path: string[] = [];
  #box: readonly number[] | undefined;
  readonly #states: PenState[] = [];
  readonly #shapes: string[] = [];
  #clips = 0;

  /** The painting as SVG. */
  get svg(): string {
    return this.#shapes.join('');
  }

  save(): void {
    const { fillStyle, strokeStyle, lineWidth, globalAlpha } = this;
    this.#states.push({ fillStyle, strokeStyle, lineWidth, globalAlpha, clip: this.#clip });
  }

  restore(): void {
    const { clip, ...state } = this.#states.pop()!;
    Object.assign(this, state);
    this.#clip = clip;
  }

  beginPath(): void {
    this.#path = [];
    this.#box = undefined;
  }

  moveTo(x: number, y: number): void {
    this.#path.push(`M${short(x)} ${short(y)}`);
  }

  lineTo(x: number, y: number): void {
    this.#path.push(`L${short(x)} ${short(y)}`);
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.#box = [x, y, width, height];
  }

  clip(): void {
    this.#clip = this.#box;
  }

  stroke(): void {
    const line = `stroke="${colourOf(this.strokeStyle)}" stroke-width="${short(this.lineWidth)}"`;
    this.#add(`<path d="${this.#path.join('')}" fill="none" ${line}`);
  }

  fillRect(x: number, y: number, width: number, height: number): void {
    if (width <= 0 || height <= 0) return;
    this.#add(`<rect ${boxOf([x, y, width, height])} fill="${colourOf(this.fillStyle)}"`);
  }

  drawImage(image: CanvasImageSource, ...[x = 0, y = 0, width = 0, height = 0]: number[]): void {
    const canvas = document.createElement('canvas');
    const { width: across, height: down } = image as OffscreenCanvas;
    [canvas.width, canvas.height] = [across, down];
    canvas.getContext('2d')!.drawImage(image, 0, 0);
    const cells = this.imageSmoothingEnabled ? '' : ' style="image-rendering: pixelated"';
    const shape = `${boxOf([x, y, width, height])} preserveAspectRatio="none"${cells}`;
    this.#add(`<image ${shape} href="${canvas.toDataURL('image/png')}"`);
  }

  /** Adds a shape that is still open. */
  #add(shape: string): void {
    const opacity = this.globalAlpha < 1 ? ` opacity="${short(this.globalAlpha)}"` : '';
    if (!this.#clip) {
      this.#shapes.push(`${shape}${opacity}/>\n`);
      return;
    }
    const id = `clip-${++this.#clips}`;
    this.#shapes.push(
      `<clipPath id="${id}"><rect ${boxOf(this.#clip)}/></clipPath>\n`,
      `${shape}${opacity} clip-path="url(#${id})"/>\n`,
    );
  }
}

const boxOf = ([x, y, width, height]: readonly number[]): string =>
  `x="${short(x!)}" y="${short(y!)}" width="${short(Math.max(0, width!))}" height="${short(Math.max(0, height!))}"`;

/** A number at an axis, and how far along it that is: from 0 to 1. */
export interface SvgTick {
  place: number;
  text: string;
}

export interface SvgAxis {
  ticks: readonly SvgTick[];
  /** The name of the numbers; '' for none. */
  label: string;
}

export interface SvgPlot {
  /** The title of its content. */
  title: string;
  /** On the page, in CSS pixels, and on paper, in millimetres. */
  size: { width: number; height: number };
  paper: number;
  /** Undefined where none is written. */
  x: SvgAxis | undefined;
  y: SvgAxis | undefined;
  /** Points by their places on both axes; no number: the line has a gap. */
  lines: readonly {
    points: readonly (readonly [number, number])[];
    /** As the words have by default. */
    colour: string | undefined;
    dash: readonly number[];
  }[];
  paint(
    this: void,
    pen: PlotPen,
    inside: { left: number; top: number; width: number; height: number },
  ): void;
}

const ink = '#1c1d21';
const gridColour = '#d9dbe0';

/** The plot as a file's content, on white, in dark ink. */
export function plotSvg({ title, size, paper, x, y, lines, paint }: SvgPlot): string {
  const left = y ? 44 + (y.label ? 16 : 0) : 1;
  const bottom = x ? 20 + (x.label ? 16 : 0) : 1;
  const [top, right] = x ? [6, 10] : [1, 1];
  const inside = {
    ...{ left, top },
    width: size.width - left - right,
    height: size.height - top - bottom,
  };
  const across = (place: number): number => left + place * inside.width;
  const up = (place: number): number => top + (1 - place) * inside.height;
  const grid: string[] = [];
  const words: string[] = [];
  const text = (content: string, at: string, anchor: string): void => {
    words.push(`<text ${at} text-anchor="${anchor}">${escaped(content)}</text>\n`);
  };
  for (const { place, text: number } of x?.ticks ?? []) {
    grid.push(`M${short(across(place))} ${short(top)}V${short(top + inside.height)}`);
    text(number, `x="${short(across(place))}" y="${short(top + inside.height + 15)}"`, 'middle');
  }
  for (const { place, text: number } of y?.ticks ?? []) {
    grid.push(`M${short(left)} ${short(up(place))}H${short(left + inside.width)}`);
    text(number, `x="${short(left - 5)}" y="${short(up(place) + 4)}"`, 'end');
  }
  if (x?.label) text(x.label, `x="${short(across(0.5))}" y="${short(size.height - 4)}"`, 'middle');
  if (y?.label) {
    text(y.label, `transform="translate(11 ${short(up(0.5))}) rotate(-90)"`, 'middle');
  }
  const pen = new SvgPen();
  paint(pen, inside);
  const drawn = lines.map(({ points, colour = ink, dash }) => {
    let isGap = true;
    const path = points.map(([right, high]) => {
      const isKnown = Number.isFinite(right) && Number.isFinite(high);
      const command = isGap ? 'M' : 'L';
      isGap = !isKnown;
      return isKnown ? `${command}${short(across(right))} ${short(up(high))}` : '';
    });
    const dashes = dash.length > 0 ? ` stroke-dasharray="${dash.join(' ')}"` : '';
    return `<path d="${path.join('')}" stroke="${colour}"${dashes}/>\n`;
  });
  const height = short((paper * size.height) / size.width);
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${paper}mm" height="${height}mm" viewBox="0 0 ${size.width} ${size.height}">
<title>${escaped(title)}</title>
<defs><clipPath id="inside"><rect ${boxOf([left, top, inside.width, inside.height])}/></clipPath></defs>
<path d="${grid.join('')}" stroke="${gridColour}" fill="none"/>
${pen.svg}<g clip-path="url(#inside)" fill="none" stroke-width="1.75" stroke-linejoin="round">
${drawn.join('')}</g>
<g font-family="Helvetica, Arial, sans-serif" font-size="11" fill="${ink}">
${words.join('')}</g>
</svg>
`;
}
