// Lines of HTML that show on other pages what is on the screen: an element, and a frame.

import type { ViewerState } from '../../src/element/index.js';

/** Attributes that concern a visit rather than a figure. */
const leftOut = new Set(['src', 'turn', 'keep-view']);

function attributesOf(state: ViewerState): [name: string, value: string | true][] {
  return Object.entries(state)
    .filter(([name]) => !leftOut.has(name))
    .map(([name, value]) => [name, value === true ? true : String(value)]);
}

const quoted = (text: string): string =>
  `"${text.replace(/[&"<>]/g, (letter) => `&#${letter.charCodeAt(0)};`)}"`;

/** The script, and an element that shows a state of the model at an address. */
export function elementLine(src: string, state: ViewerState): string {
  const words = attributesOf(state).map(([name, value]) =>
    value === true ? name : `${name}=${quoted(value)}`,
  );
  const tag = ['<girth-viewer', `src=${quoted(src)}`, ...words].join(' ');
  return (
    '<script type="module" src="girth/dist/girth-viewer.js"></script>\n' +
    `${tag} style="width: 100%; height: 400px"></girth-viewer>`
  );
}

/** A frame that shows the same; `embed` is the address of the page that is all figure. */
export function frameLine(embed: string, src: string, state: ViewerState, title: string): string {
  const words = new URLSearchParams([['src', src]]);
  for (const [name, value] of attributesOf(state)) words.set(name, value === true ? '' : value);
  // Legible where the rules for addresses allow it.
  const fragment = words.toString().replace(/%(2C|3A|2F|40)/g, decodeURIComponent);
  return `<iframe src=${quoted(`${embed}#${fragment}`)} title=${quoted(title)} width="100%" height="400" loading="lazy" style="border: 0"></iframe>`;
}
