// Handles and tunnels that are too short to be meant, taken away: which, and what was done.

import { type GirthViewer, formatLength, make } from '../../../src/element/index.js';
import type { Handle, HandleKind, HandleRemoval } from '../../../src/kernel/index.js';
import { LengthInput } from '../../widgets/length-input.js';
import { plural } from '../../model/model-words.js';

/** One and several of a kind; what was done with small ones, whose tube was dropped, and with the others. */
const words: Record<HandleKind, readonly [string, string, string, string]> = {
  handle: ['handle', 'handles', 'removed', 'cut, too large to be removed whole'],
  tunnel: ['tunnel', 'tunnels', 'filled', 'closed'],
  unknown: ['loop of unknown kind', 'loops of unknown kind', 'removed', 'cut'],
};

/** The result of a removal in words, without a full stop. */
export function removalWords(removal: HandleRemoval): string {
  const { removed, genusBefore, genusAfter, crossingFaces } = removal;
  const counts = Object.entries(words).flatMap(([kind, [one, several, ...done]]) =>
    done.map((what, i) => {
      const those = removed.filter((it) => it.kind === kind && it.droppedArea > 0 === (i === 0));
      return those.length > 0 ? `${plural(those.length, one, several)} ${what}` : '';
    }),
  );
  const all = counts.filter((one) => one !== '').join(', ');
  const crossing =
    crossingFaces > 0
      ? `; no room: ${plural(crossingFaces, 'face made or moved crosses', 'faces made or moved cross')} others`
      : '';
  return `${all}; genus ${genusBefore} before, ${genusAfter} now${crossing}`;
}

export class HandleRemovalForm {
  readonly element: HTMLElement;
  readonly #length: LengthInput;
  readonly #remove = make('button', { type: 'submit', class: 'plain' }, 'Remove');
  readonly #form = make('form', { class: 'length-form' });
  readonly #words = make('p', { class: 'hint' });
  readonly #said = make('p', { class: 'said', role: 'status' });
  #handles: readonly Handle[] = [];
  readonly #viewer: GirthViewer;

  /** `remove` shows the surface without them, and tells what was done; undefined where that came to nothing. */
  constructor(viewer: GirthViewer, remove: (length: number) => Promise<HandleRemoval | undefined>) {
    this.#viewer = viewer;
    this.#length = new LengthInput('handle-length', 'Remove below', {
      changed: () => this.#refresh(),
      wrong: (why) => (this.#words.textContent = `${why}.`),
    });
    this.#form.append(this.#length.label, this.#remove);
    this.#form.addEventListener('submit', (event) => {
      event.preventDefault();
      if (!this.#length.commit()) return;
      const { length } = this.#length;
      if (length === undefined) {
        this.#words.textContent = 'Type a length: shorter handles and tunnels are removed.';
        return;
      }
      void remove(length).then((removal) => {
        if (removal?.removed.length !== 0) return;
        const proven = formatLength(removal.provenLength, this.#viewer.lengthFormat);
        this.#said.textContent =
          removal.provenLength < length
            ? `No shorter loop was found, and none is shorter than ${proven}: nothing was changed.`
            : 'No loop is shorter: nothing was changed.';
      });
    });
    this.element = make('div', {}, this.#form, this.#words, this.#said);
  }

  /** Another model. */
  clear(): void {
    this.#length.discard();
    this.#length.show(undefined, this.#viewer.lengthFormat);
    this.show([]);
  }

  /** The handles that were found, or another unit. */
  show(handles: readonly Handle[]): void {
    const { removal, lengthFormat } = this.#viewer;
    this.#handles = handles;
    this.#form.hidden = handles.length === 0;
    this.#length.show(this.#length.length, lengthFormat);
    this.#said.textContent = removal ? `Done: ${removalWords(removal)}.` : '';
    this.#refresh();
  }

  #refresh(): void {
    const { length } = this.#length;
    const shorter = this.#handles.filter((one) => one.length < (length ?? 0)).length;
    this.#words.textContent =
      this.#handles.length === 0
        ? ''
        : length === undefined
          ? 'Short ones are mostly errors of a scan: a handle is removed, a tunnel is filled.'
          : `${shorter} of these ${this.#handles.length} loops are shorter than ${formatLength(length, this.#viewer.lengthFormat)}.`;
  }
}
