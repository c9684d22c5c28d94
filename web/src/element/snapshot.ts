// A picture of the surface with its legend.

import { type LegendContent, drawLegend } from '../view/index.js';

/** The picture on the element's paper, with the legend where the element has it. */
export function withLegend(
  picture: HTMLCanvasElement,
  content: LegendContent | undefined,
  element: HTMLElement,
): HTMLCanvasElement {
  const whole = document.createElement('canvas');
  [whole.width, whole.height] = [picture.width, picture.height];
  const context = whole.getContext('2d')!;
  const css = getComputedStyle(element);
  const colour = (name: string): string => css.getPropertyValue(name).trim();
  context.fillStyle = colour('--girth-paper');
  context.fillRect(0, 0, whole.width, whole.height);
  context.drawImage(picture, 0, 0);
  if (!content) return whole;
  const ratio = picture.width / Math.max(1, element.clientWidth);
  context.scale(ratio, ratio);
  const height = picture.height / ratio;
  drawLegend(
    context,
    content,
    {
      ink: colour('--girth-ink'),
      quiet: colour('--girth-quiet'),
      family: css.fontFamily || 'sans-serif',
    },
    [16, height - 16],
    Math.min(150, 0.4 * height),
  );
  return whole;
}
