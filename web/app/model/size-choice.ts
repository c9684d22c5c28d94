// The unit of a file, the unit that lengths are shown in, and the size that the model is given. The unit of the file
// and the unit that is shown are two things.

import { type GirthViewer, make } from '../../src/element/index.js';
import { Draft } from '../widgets/draft.js';
import { LengthInput } from '../widgets/length-input.js';
import { isUnusual, ofSize, tallWords } from './model-size.js';

/** Units that a thing may be given in. */
const units = ['mm', 'cm', 'm', 'in', 'ft'] as const;

/** How much larger the model is than its file. */
export interface ModelScale {
  /** 1: as in the file. */
  readonly scale: number;
  rescale(scale: number): void;
}

export class SizeChoice {
  readonly element: HTMLElement;
  readonly #unit = make('select', {});
  readonly #unitRow: HTMLElement;
  readonly #unitDraft: Draft;
  readonly #stated = make('span', { class: 'said' });
  readonly #shown = make('select', {});
  readonly #shownRow: HTMLElement;
  readonly #shownDraft: Draft;
  readonly #height: LengthInput;
  readonly #words = make('p', { class: 'hint size-words', role: 'status' });
  readonly #reset = make('button', { type: 'button', class: 'more' }, 'as in the file');
  readonly #viewer: GirthViewer;
  readonly #model: ModelScale;

  /** `prefix` begins the names of its elements: there may be several on the page. */
  constructor(prefix: string, viewer: GirthViewer, model: ModelScale) {
    this.#viewer = viewer;
    this.#model = model;
    const list = (select: HTMLSelectElement, id: string, none: string): void => {
      select.id = id;
      select.append(
        make('option', { value: '' }, none),
        ...units.map((name) => make('option', { value: name }, name)),
      );
    };
    list(this.#unit, `${prefix}unit`, 'choose a unit');
    list(this.#shown, `${prefix}shown-unit`, 'as the file');
    this.#unitDraft = new Draft(this.#unit, {
      committed: (unit) => viewer.setAttribute('unit', unit),
    });
    this.#shownDraft = new Draft(this.#shown, {
      committed: (unit) => {
        if (unit === '') viewer.removeAttribute('shown-unit');
        else viewer.setAttribute('shown-unit', unit);
      },
    });
    this.#height = new LengthInput(`${prefix}height`, 'Height', {
      changed: (height) => this.#resize(height),
      wrong: (why) => (this.#words.textContent = `${why}.`),
      unitTyped: (unit) => viewer.setAttribute('unit', unit),
    });
    const row = (words: string, control: HTMLElement, ...more: HTMLElement[]): HTMLElement =>
      make('p', { class: 'length' }, make('label', { for: control.id }, words), control, ...more);
    this.#unitRow = row('Unit of the file', this.#unit, this.#stated);
    this.#shownRow = row('Shown in', this.#shown);
    this.#reset.addEventListener('click', () => model.rescale(1));
    this.element = make(
      'div',
      { class: 'size-choice' },
      this.#unitRow,
      this.#shownRow,
      this.#height.label,
      this.#words,
      make('p', { class: 'hint' }, this.#reset),
    );
    for (const event of ['unit', 'view']) viewer.addEventListener(event, () => this.refresh());
  }

  /** Another model, or the same one in another size. */
  clear(): void {
    this.#height.discard();
    this.refresh();
  }

  refresh(): void {
    const [viewer, { scale }] = [this.#viewer, this.#model];
    const { info, lengthFormat, unit } = viewer;
    const isStated = (info?.unit ?? '') !== '';
    this.#unit.hidden = isStated;
    this.#stated.textContent = isStated ? `${unit}, as it states` : '';
    for (const [select, name] of [
      [this.#unit, unit],
      [this.#shown, viewer.shownUnit],
    ] as const) {
      if ([...select.options].some(({ value }) => value === name)) continue;
      select.append(make('option', { value: name }, name));
    }
    this.#unitDraft.show(isStated ? '' : unit);
    this.#shownDraft.show(viewer.shownUnit);
    this.#shownRow.hidden = unit === '';
    this.#reset.hidden = scale === 1;
    if (!info) return;
    const { height } = viewer;
    this.#height.show(height, lengthFormat);
    const scaled = scale === 1 ? '' : `, ${ofSize(scale, 'the file’s size')}`;
    const isOdd = unit !== '' && isUnusual(height, unit);
    this.#words.textContent =
      unit === ''
        ? 'The size is unknown: choose the unit, or type the height with its unit.'
        : `${tallWords(height, lengthFormat)}${scaled}${isOdd ? ': really?' : ''}`;
    this.#words.classList.toggle('odd', isOdd);
  }

  /** Makes the model so high, in model units. */
  #resize(height: number | undefined): void {
    const present = this.#viewer.height;
    if (height === undefined || !(height > 0) || !(present > 0)) return this.refresh();
    const ratio = height / present;
    if (Math.abs(ratio - 1) > 1e-9) this.#model.rescale(this.#model.scale * ratio);
  }
}
