// The file's axes as the eye sees them: three short lines with letters, drawn anew with each frame.

import type { Stage } from '../../view/index.js';

const space = 'http://www.w3.org/2000/svg';
const size = 48;
const reach = 16;
const letters = ['x', 'y', 'z'] as const;

function draw<Name extends 'svg' | 'line' | 'text'>(
  name: Name,
  attributes: Record<string, string> = {},
): SVGElementTagNameMap[Name] {
  const element = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

export class AxesSketch {
  readonly element = draw('svg', {
    viewBox: `${-size / 2} ${-size / 2} ${size} ${size}`,
    class: 'axes',
    'aria-hidden': 'true',
  });
  readonly #axes = letters.map((letter) => {
    const [line, text] = [draw('line'), draw('text')];
    text.textContent = letter;
    const group = document.createElementNS(space, 'g');
    group.setAttribute('class', `axis-${letter}`);
    group.append(line, text);
    return { group, line, text };
  });

  constructor() {
    this.element.append(...this.#axes.map(({ group }) => group));
  }

  /** Draws the axes as seen now; axes that point away lie behind the others. */
  update(stage: Stage): void {
    const seen = stage.axes.map((axis, i) => ({ axis, ...this.#axes[i]! }));
    for (const { axis, group, line, text } of seen) {
      line.setAttribute('x2', (reach * axis.x).toFixed(1));
      line.setAttribute('y2', (-reach * axis.y).toFixed(1));
      text.setAttribute('x', ((reach + 5) * axis.x).toFixed(1));
      text.setAttribute('y', (-(reach + 5) * axis.y).toFixed(1));
      group.classList.toggle('away', axis.z < -0.1);
    }
    const order = seen.sort((a, b) => a.axis.z - b.axis.z).map(({ group }) => group);
    if (order.some((group, i) => this.element.children[i] !== group)) this.element.append(...order);
  }
}
