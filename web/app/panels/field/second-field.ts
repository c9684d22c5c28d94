// The field that the chosen one is compared with: its difference from it, or the ratio of the two.

import {
  type GirthViewer,
  type ShownName,
  type ValuesName,
  combinationOf,
  fieldNames,
  isShownName,
  make,
} from '../../../src/element/index.js';
import { Draft } from '../../widgets/draft.js';

const signs = { difference: '-', ratio: '/' } as const;
const groups = { difference: 'Difference', ratio: 'Ratio' } as const;
const signWords = { difference: 'less', ratio: 'divided by' } as const;

export class SecondField {
  readonly element = make('div', { class: 'row second' });
  readonly #list = make('select', { id: 'second-field', 'aria-label': 'Compared with' });
  readonly #draft: Draft;
  /** The field that the second one is compared with. */
  #first: ShownName = 'igf';
  #offered = '';
  readonly #viewer: GirthViewer;
  readonly #wordsFor: (name: ShownName) => string;

  /** `chosen`: another comparison is wanted, or none. */
  constructor(
    viewer: GirthViewer,
    wordsFor: (name: ShownName) => string,
    chosen: (name: ShownName) => void,
  ) {
    this.#viewer = viewer;
    this.#wordsFor = wordsFor;
    this.element.append(this.#list);
    this.#draft = new Draft(this.#list, { committed: (rest) => chosen(this.#with(rest)) });
  }

  /** Shows the choice for a field; hidden where the field has no numbers at every vertex. */
  show(name: ShownName): void {
    const combined = combinationOf(name);
    this.#first = combined?.first ?? name;
    this.#offer();
    this.element.hidden = this.#list.options.length === 1;
    this.#draft.show(combined ? signs[combined.by] + combined.second : '');
  }

  /** The name to show for another first field: compared with the same second one, if possible. */
  instead(first: ShownName): ShownName {
    const name = `${first}${this.#draft.text}`;
    return isShownName(name) ? name : first;
  }

  #with(rest: string): ShownName {
    const name = `${this.#first}${rest}`;
    return isShownName(name) ? name : this.#first;
  }

  /** Lists what the first can be compared with. */
  #offer(): void {
    const names: ValuesName[] = [...fieldNames, ...this.#viewer.given];
    const offered = [this.#first, ...names].join();
    if (offered === this.#offered) return;
    this.#offered = offered;
    const lists = (['difference', 'ratio'] as const).map((by) => {
      const options = names
        .filter((second) => combinationOf(`${this.#first}${signs[by]}${second}`)?.by === by)
        .map((second) => {
          const words = `${signWords[by]} ${this.#wordsFor(second)}`;
          return make('option', { value: signs[by] + second }, words);
        });
      return options.length > 0 ? [make('optgroup', { label: groups[by] }, ...options)] : [];
    });
    this.#list.replaceChildren(
      make('option', { value: '' }, 'not compared with another field'),
      ...lists.flat(),
    );
  }
}
