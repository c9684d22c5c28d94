// The sheet that shares the view: a link, and lines of HTML for other pages.

import { make } from '../../src/element/index.js';
import { copyText } from '../widgets/clipboard.js';
import { byId } from '../widgets/dom.js';
import { failureWords } from '../widgets/failure-words.js';
import { Draft } from '../widgets/draft.js';

/** The forms in which the view can be shared. */
export interface Shared {
  link: string;
  /** The file that the link cannot have in it; undefined where it has all. */
  fileName: string | undefined;
  /** Undefined where an element would show something else. */
  element: string | undefined;
  /** Undefined where there is no address that others can fetch the model from. */
  frame: string | undefined;
  /** Whether the surface is not as its file has it. */
  isPrepared: boolean;
}

/** A line that can be copied. */
class Line {
  readonly element: HTMLElement;
  readonly #shown: Draft;

  constructor(label: string, copyWords: string, said: HTMLElement) {
    const field = make('input', { type: 'text', readonly: '', 'aria-label': label });
    const copy = make('button', { type: 'button', class: 'plain' }, copyWords);
    this.#shown = new Draft(field);
    this.element = make('div', { class: 'link' }, field, copy);
    field.addEventListener('focus', () => field.select());
    copy.addEventListener('click', () => {
      field.select();
      void copyText(this.#shown.text).then((isCopied) => {
        said.textContent = isCopied
          ? 'Copied.'
          : 'This browser does not let pages copy: copy the line from its field.';
      });
    });
  }

  /** Undefined: there is no such line. */
  show(text: string | undefined): void {
    this.element.hidden = text === undefined;
    if (text !== undefined) this.#shown.show(text);
  }
}

function wordsOnLink({ fileName }: Shared): string {
  return fileName === undefined
    ? 'It opens this model with field, colours, camera, loops and thresholds as they are now.'
    : `${fileName} stays on your machine: a link cannot have it. Whoever opens the link and drops ` +
        'that file sees it as it is now.';
}

function wordsOnLines({ fileName, isPrepared }: Shared): string {
  if (isPrepared) {
    return 'Elements show a model as its file has it. To put this one on a page, export it as GLB and open that file.';
  }
  const rest = 'The element needs the folder dist of the package beside your page, as girth/dist';
  return fileName === undefined
    ? `${rest}; the frame needs no script of yours.`
    : `${rest}, and ${fileName} too.`;
}

/** Fills the sheet each time that it opens; `savePage` saves the model as a web page of its own. */
export function offerSharing(shared: () => Shared, savePage: () => Promise<void>): void {
  const sheet = byId('share');
  const said = make('p', { class: 'hint', role: 'status' });
  const link = new Line('Link', 'Copy link', said);
  const element = new Line('Element', 'Copy element', said);
  const frame = new Line('Frame', 'Copy frame', said);
  const [onLink, onLines] = [make('p', { class: 'hint' }), make('p', { class: 'hint' })];
  const lines = make('h3', {}, 'On a page of your own');
  const save = make('button', { type: 'button', class: 'plain' }, 'Save a web page');
  save.addEventListener('click', () => {
    said.textContent = '';
    savePage().catch((error: unknown) => {
      said.textContent = `That could not be written: ${failureWords(error)}.`;
    });
  });
  const onPage = make(
    'p',
    { class: 'hint' },
    'One file with the model, its values and pinned loops: it opens in any browser, from a disk too.',
  );
  const parts = [link.element, onLink, lines, element.element, frame.element, onLines];
  sheet.append(...parts, make('p', { class: 'buttons' }, save), onPage, said);
  sheet.addEventListener('beforetoggle', (event) => {
    if (event.newState !== 'open') return;
    const now = shared();
    said.textContent = '';
    link.show(now.link);
    element.show(now.element);
    frame.show(now.frame);
    onLink.textContent = wordsOnLink(now);
    onLines.textContent = wordsOnLines(now);
  });
}
