// A second model beside the first, coloured by the same field: views are linked, and colours span one scale where that is
// wished for. Fetched when somebody asks for it, or a link does.

import { type GirthViewer, make } from '../../src/element/index.js';
import { type PageState, besideOf } from '../state/address-state.js';
import { announce } from '../widgets/announcer.js';
import { byId, setAttribute } from '../widgets/dom.js';
import { modelFacts } from './model-words.js';
import type { Store } from '../state/store.js';
import type { Opened } from './session.js';

/** The name of what the two have in common. */
const link = 'page';
/** Attributes that the second model takes over from the first. */
const mirrored = [
  ...['unit', 'shown-unit', 'field', 'field-title', 'colormap', 'isolines', 'log', 'persistence'],
  ...['time', 'energy', 'component', 'edges', 'shading', 'section'],
];

/** The page, as far as the second model needs it. */
export interface BesidePage {
  /** The built-in examples, with their titles. */
  gallery(): { opened: Opened; title: string }[];
  /** A file that was opened before on this visit, by its name. */
  openedBefore(file: string): Opened | undefined;
}

/** A switch with its words; a phone has room for the first ones. */
function toggle(first: string, rest: string, changed: () => void): [HTMLElement, HTMLInputElement] {
  const input = make('input', { type: 'checkbox', 'aria-label': `${first} ${rest}` });
  input.addEventListener('change', changed);
  return [make('label', { class: 'check' }, input, first, make('span', {}, rest)), input];
}

export class Beside {
  readonly #viewer: GirthViewer;
  readonly #store: Store;
  readonly #page: BesidePage;
  readonly #main = document.querySelector('main')!;
  readonly #opener = byId('beside-open');
  readonly #menu = byId('beside-menu');
  readonly #linked: HTMLInputElement;
  readonly #oneScale: HTMLInputElement;
  readonly #name = make('p', { class: 'model' });
  readonly #bar: HTMLElement;
  readonly #missing = make('div', { class: 'missing', hidden: '' });
  readonly #missingOpen = make('button', { type: 'button', class: 'open' }, 'Open\u2009…');
  readonly #watch = new MutationObserver(() => this.#mirror());
  /** The model that is shown beside, or on its way. */
  #opened: Opened | undefined;
  /** The name of a file that a link asks for and that cannot be had. */
  #wish: string | undefined;
  #second: GirthViewer | undefined;
  #pane: HTMLElement | undefined;
  /** Files that were shown beside on this visit, by their names. */
  readonly #files = new Map<string, Opened>();

  constructor(viewer: GirthViewer, store: Store, page: BesidePage) {
    this.#viewer = viewer;
    this.#store = store;
    this.#page = page;
    const changed = (): void => {
      this.#join();
      this.#keep();
    };
    const [linked, linkedInput] = toggle('Linked', 'views', changed);
    const [oneScale, oneScaleInput] = toggle('One scale', 'for both', changed);
    [this.#linked, this.#oneScale] = [linkedInput, oneScaleInput];
    const close = make(
      'button',
      { type: 'button', class: 'round', 'aria-label': 'Close the second model' },
      '✕',
    );
    close.addEventListener('click', () => {
      this.close();
      this.#opener.focus();
      announce('The second model is closed.');
    });
    this.#bar = make('div', { class: 'beside-bar' }, this.#name, linked, oneScale, close);
    this.#offer();
  }

  /** Shows a model beside the present one, in place of the one that is there. */
  async open(opened: Opened): Promise<void> {
    const isNew = !this.#pane;
    const second = this.#shown();
    if (isNew) this.#choose({});
    this.#opened = opened;
    this.#missing.hidden = true;
    const { source, model, prepare, link } = opened;
    if (link.file !== undefined) this.#files.set(link.file, opened);
    this.#keep();
    await second
      .load(source, model === undefined ? { prepare } : { prepare, model })
      .then(({ name }) => announce(`${name} is beside it.`))
      // A failure is written where the surface would be.
      .catch(() => undefined);
  }

  /** The page is as it was before. */
  close(): void {
    if (!this.#pane) return;
    this.#watch.disconnect();
    this.#pane.remove();
    this.#pane = this.#second = this.#opened = this.#wish = undefined;
    this.#main.classList.remove('paired');
    for (const name of ['linked', 'one-scale']) this.#viewer.removeAttribute(name);
    this.#keep();
  }

  /** Puts into the state which model is beside. */
  #keep(): void {
    const none = { beside: undefined, besideFile: undefined, apart: false, oneScale: false };
    this.#store.choose({ ...none, ...this.#read() });
  }

  #read(): PageState {
    if (!this.#pane) return {};
    const { model, file } = this.#opened?.link ?? { file: this.#wish };
    return besideOf({
      ...(model === undefined ? { besideFile: file } : { beside: model }),
      apart: !this.#linked.checked,
      oneScale: this.#oneScale.checked,
    });
  }

  /** Shows what a link asks for. */
  async apply(state: PageState): Promise<void> {
    const { beside, besideFile } = state;
    if (beside === undefined && besideFile === undefined) {
      this.close();
      return;
    }
    const now = this.#read();
    const isThere = now.beside === beside && now.besideFile === besideFile;
    const wanted = this.#wanted(state);
    const opening = isThere || !wanted ? undefined : this.open(wanted);
    // A link cannot have a file in it: that waits for it.
    if (!wanted && besideFile !== undefined) this.#miss(besideFile);
    this.#choose(state);
    this.#keep();
    await opening;
  }

  #miss(file: string): void {
    this.#shown();
    this.#opened = undefined;
    this.#wish = file;
    this.#missing.hidden = false;
    this.#missing.replaceChildren(
      make('p', {}, 'Beside it this link shows ', make('b', {}, file), '.'),
      make('p', {}, 'A link cannot have a file in it: open the file to see it here.'),
      this.#missingOpen,
    );
  }

  #wanted({ beside, besideFile }: PageState): Opened | undefined {
    if (beside?.includes(':')) return { source: beside, link: { model: beside }, prepare: {} };
    if (beside !== undefined) {
      return this.#page.gallery().find(({ opened }) => opened.link.model === beside)?.opened;
    }
    if (besideFile === undefined) return undefined;
    return this.#files.get(besideFile) ?? this.#page.openedBefore(besideFile);
  }

  /** The second element, with all about it. */
  #shown(): GirthViewer {
    if (this.#second) return this.#second;
    const second = make('girth-viewer');
    second.addEventListener('load', ({ detail }) => {
      const [name = '', ...rest] = modelFacts(detail.info);
      this.#name.replaceChildren(make('b', {}, name), ` · ${rest.join(' · ')}`);
      this.#name.title = this.#name.textContent ?? '';
    });
    this.#name.replaceChildren();
    this.#second = second;
    this.#mirror();
    this.#watch.observe(this.#viewer, { attributeFilter: [...mirrored, 'range'] });
    const pane = make(
      'section',
      { class: 'beside', 'aria-label': 'Second model' },
      second,
      this.#bar,
      this.#missing,
    );
    this.#pane = pane;
    this.#main.classList.add('paired');
    this.#main.querySelector('.surface')!.after(pane);
    return second;
  }

  /** Links views, and has one scale, as a state asks for it. */
  #choose({ apart = false, oneScale = false }: PageState): void {
    this.#linked.checked = !apart;
    this.#oneScale.checked = oneScale;
    this.#join();
  }

  #join(): void {
    if (!this.#second) return;
    for (const viewer of [this.#viewer, this.#second]) {
      setAttribute(viewer, 'linked', this.#linked.checked ? link : '');
      setAttribute(viewer, 'one-scale', this.#oneScale.checked ? link : '');
    }
  }

  #mirror(): void {
    const [viewer, second] = [this.#viewer, this.#second];
    if (!second) return;
    const range = viewer.getAttribute('range');
    for (const name of [...mirrored, 'range']) {
      // Two numbers are the range of one of them, unless that is for both.
      const text = name === 'range' && !range?.includes('%') ? null : viewer.getAttribute(name);
      if (text === second.getAttribute(name)) continue;
      if (text === null) second.removeAttribute(name);
      else second.setAttribute(name, text);
    }
  }

  /** Lists what can be opened beside: a file, or an example. */
  #offer(): void {
    const chooser = byId<HTMLInputElement>('beside-file');
    const entry = (words: string, act: () => void): HTMLElement => {
      const button = make('button', { type: 'button' }, words);
      button.addEventListener('click', () => {
        this.#menu.hidePopover();
        act();
      });
      return button;
    };
    chooser.addEventListener('change', () => {
      const files = [...(chooser.files ?? [])];
      // A file may be chosen again after it was changed. Nobody types here.
      // oxlint-disable-next-line girth/shown-text
      chooser.value = '';
      const [first] = files;
      if (!first) return;
      const source = files.length === 1 ? first : files;
      void this.open({ source, link: { file: first.name }, prepare: {} });
    });
    this.#missingOpen.addEventListener('click', () => chooser.click());
    this.#menu.append(
      entry('A file …', () => chooser.click()),
      ...this.#page
        .gallery()
        .map(({ opened, title }) => entry(title, () => void this.open(opened))),
    );
  }
}
