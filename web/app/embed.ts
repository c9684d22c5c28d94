// A page that is all figure, for an <iframe>: embed.html#src=chair.glb&field=sdf shows what an element of these
// attributes would.

import { type ViewerState, sentence } from '../src/element/index.js';
import { byId } from './widgets/dom.js';

const viewer = document.querySelector('girth-viewer')!;
const fault = byId('fault');

function say(words: string): void {
  fault.textContent = words;
  fault.hidden = words === '';
}

/** Shows what the address asks for. */
function follow(): void {
  const state = Object.fromEntries(new URLSearchParams(location.hash.slice(1))) as ViewerState;
  if (!state.src) {
    say('The address of this frame names no model: it must end in #src= and the address of one.');
    return;
  }
  try {
    viewer.state = state;
    say('');
  } catch (error) {
    const { message, hint } = error as { message: string; hint: string };
    say(`The address of this frame cannot be followed: ${message}. ${sentence(hint)}`);
  }
}

viewer.addEventListener('load', ({ detail }) => {
  document.title = `${detail.info.name} – Girth`;
});
window.addEventListener('hashchange', follow);
follow();
