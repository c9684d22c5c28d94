// The small bar on the canvas: back to the first view; the axes, straight views and the way up; how the
// surface is drawn; and a stop for the turning.

import {
  type Stage,
  type StraightName,
  type UpAxis,
  lookNames,
  straightNames,
  upNames,
} from '../../view/index.js';
import { AxesSketch } from './axes-sketch.js';
import { make } from './dom.js';

export interface BarActions {
  home(): void;
  lookStraight(name: StraightName): void;
  /** Null: as fits the model. */
  setUp(name: string | null): void;
  setLook(name: string): void;
  setEdges(shown: boolean): void;
  /** Whether the next model is seen from where this one is. */
  keepView(kept: boolean): void;
  toggleTurning(): void;
}

const upWords = { y: 'y', z: 'z', '-y': '−y', '-z': '−z', x: 'x', '-x': '−x' } as const;
const byWords = { format: 'as the format has it', guess: 'a guess', choice: 'as chosen' } as const;
const lookWords = { smooth: 'Smooth', flat: 'Flat', transparent: 'Transparent' } as const;
const straightWords = { front: 'Front', side: 'Side', top: 'Top' } as const;

const paths = {
  home: 'M3 9.5 10 3l7 6.5M5 8v9h10V8',
  look: 'M10 3a7 7 0 1 0 0 14a7 7 0 1 0 0-14M10 3v14M12 5.5v9M14 7.5v5',
  pause: 'M7 4v12M13 4v12',
  play: 'M6 4l10 6-10 6z',
} as const;

export function icon(shape: string): SVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const picture = document.createElementNS(space, 'svg');
  picture.setAttribute('viewBox', '0 0 20 20');
  picture.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', shape);
  picture.append(path);
  return picture;
}

/** A button that has only a picture. */
export function button(words: string, ...content: Node[]): HTMLButtonElement {
  return make('button', { type: 'button', 'aria-label': words, title: words }, ...content);
}

/** The key does the same. */
function keyed(control: HTMLButtonElement, key: string): HTMLButtonElement {
  control.setAttribute('aria-keyshortcuts', key);
  return control;
}

export class CanvasBar {
  readonly element = make('div', { class: 'bar-tools', role: 'toolbar', 'aria-label': 'View' });
  /** Starts and stops the turning. */
  readonly turn = button('Pause the turning', icon(paths.pause));
  readonly #home = keyed(button('First view (0)', icon(paths.home)), '0');
  readonly #sketch = new AxesSketch();
  readonly #upShown = make('small');
  readonly #axes = make(
    'button',
    { type: 'button' },
    make('span', { class: 'quiet-live' }, 'Axes and straight views: '),
    this.#sketch.element,
    this.#upShown,
  );
  readonly #look = button('How the surface is drawn', icon(paths.look));
  readonly #up = make('select', { 'aria-label': 'Which way is up' });
  readonly #fitting = make('option', { value: '' });
  readonly #looks: HTMLInputElement[];
  readonly #edges = make('input', { type: 'checkbox', name: 'edges' });
  readonly #keep = make('input', { type: 'checkbox', name: 'keep' });
  readonly #menus: [HTMLButtonElement, HTMLElement][] = [];

  constructor(actions: BarActions) {
    this.#home.addEventListener('click', () => actions.home());
    this.turn.addEventListener('click', () => actions.toggleTurning());
    const straight = straightNames.map((name, i) => {
      const one = keyed(make('button', { type: 'button' }, straightWords[name], ' '), `${i + 1}`);
      one.append(make('kbd', {}, String(i + 1)));
      one.addEventListener('click', () => actions.lookStraight(name));
      return one;
    });
    const ups = upNames.map((name) => make('option', { value: name }, `${upWords[name]} is up`));
    this.#up.append(this.#fitting, ...ups);
    this.#up.addEventListener('change', () => actions.setUp(this.#up.value || null));
    this.#looks = lookNames.map((value) => {
      const input = make('input', { type: 'radio', name: 'look', value });
      input.addEventListener('change', () => actions.setLook(value));
      return input;
    });
    this.#edges.addEventListener('change', () => actions.setEdges(this.#edges.checked));
    const axesMenu = make(
      'div',
      { class: 'menu plate', hidden: '' },
      ...straight,
      this.#up,
      make('label', {}, this.#keep, 'Same view for the next model'),
    );
    this.#keep.addEventListener('change', () => actions.keepView(this.#keep.checked));
    const lookMenu = make(
      'div',
      { class: 'menu plate', hidden: '' },
      ...this.#looks.map((input, i) => make('label', {}, input, lookWords[lookNames[i]!])),
      make('label', {}, this.#edges, 'Edges'),
    );
    this.element.append(this.#home, this.turn);
    this.add(this.#axes, axesMenu);
    this.add(this.#look, lookMenu);
    this.element.addEventListener('focusout', ({ relatedTarget }) => {
      const stays = relatedTarget instanceof Node && this.element.contains(relatedTarget);
      if (relatedTarget && !stays) this.#open(undefined);
    });
    this.element.addEventListener('keydown', (event) => {
      const open = this.#menus.find(([, menu]) => !menu.hidden);
      if (event.key !== 'Escape' || !open) return;
      event.preventDefault();
      event.stopPropagation();
      this.#open(undefined);
      open[0].focus();
    });
  }

  /** Another menu, with what opens it. */
  add(opener: HTMLButtonElement, menu: HTMLElement): void {
    this.#menus.push([opener, menu]);
    opener.setAttribute('aria-expanded', 'false');
    opener.addEventListener('click', () => this.#open(menu.hidden ? menu : undefined));
    const tool = make('div', { class: 'tool' }, opener, menu);
    tool.hidden = this.#home.hidden;
    this.turn.before(tool);
  }

  /** Closes what is open; for actions elsewhere. */
  close(): void {
    this.#open(undefined);
  }

  /** Shows all of the bar, or where the surface turns by itself, only its stop. */
  show(all: boolean, stop: boolean): void {
    for (const child of this.element.children) {
      (child as HTMLElement).hidden = child === this.turn ? !stop : !all;
    }
  }

  /** The axes as they are seen now. */
  place(stage: Stage): void {
    if (!this.#home.hidden) this.#sketch.update(stage);
  }

  /** Which way is up, and which would fit. */
  showUp(axis: UpAxis, fitting: UpAxis): void {
    const { name, by } = axis;
    const words = ({ name, by }: UpAxis): string =>
      `${name ? `${upWords[name]} is up` : 'the long axis is up'}, ${byWords[by]}`;
    const short = name ? `${upWords[name]} up` : 'askew';
    this.#upShown.textContent = by === 'guess' ? `${short}?` : short;
    this.#axes.title = words(axis);
    this.#fitting.textContent = words(fitting);
    this.#up.value = by === 'choice' ? name! : '';
  }

  showLook(look: string, edges: boolean): void {
    for (const input of this.#looks) input.checked = input.value === look;
    this.#edges.checked = edges;
  }

  showKept(isKept: boolean): void {
    this.#keep.checked = isKept;
  }

  showTurning(isTurning: boolean): void {
    const words = isTurning ? 'Pause the turning' : 'Turn slowly';
    if (this.turn.title === words) return;
    this.turn.title = words;
    this.turn.setAttribute('aria-label', words);
    this.turn.replaceChildren(icon(isTurning ? paths.pause : paths.play));
  }

  #open(wanted: HTMLElement | undefined): void {
    for (const [opener, menu] of this.#menus) {
      menu.hidden = menu !== wanted;
      opener.setAttribute('aria-expanded', String(menu === wanted));
    }
  }
}
