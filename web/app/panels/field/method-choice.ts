// How the girth is computed. Large models begin with that of few triangles; the rest is there on demand.

import type { Field, GirthAudit, MeshInfo, RefinedGirth } from '../../../src/kernel/index.js';
import {
  type GirthMethod,
  type GirthViewer,
  formatCount,
  make,
  sentence,
} from '../../../src/element/index.js';
import { usualMethod } from '../../state/attributes.js';
import type { Store } from '../../state/store.js';
import { Draft } from '../../widgets/draft.js';
import { kernel } from '../../model/kernel.js';
import { memoryWords, mostFaces, mostMemory, refinedMemory } from './refined-memory.js';

/** The shown names that a method changes. */
const concerned = new Set(['igf', 'kind', 'state', 'tips', 'parts']);
const methods: readonly [GirthMethod, string][] = [
  ['coarse', 'on fewer triangles'],
  ['refined', 'refined, at all vertices'],
  ['exact', 'exact, at all vertices'],
];

export class MethodChoice {
  readonly element = make('div', { class: 'method' });
  readonly #select = make('select', { id: 'method' });
  readonly #said = make('p', { class: 'hint', role: 'status' });
  readonly #draft: Draft;
  #name = 'none';
  readonly #viewer: GirthViewer;
  readonly #store: Store;

  constructor(viewer: GirthViewer, store: Store) {
    this.#viewer = viewer;
    this.#store = store;
    this.#select.append(...methods.map(([value, words]) => make('option', { value }, words)));
    this.#draft = new Draft(this.#select, {
      committed: (method) => this.#choose(method as GirthMethod),
    });
    this.element.append(
      make('p', { class: 'row' }, make('label', { for: 'method' }, 'Girth'), this.#select),
      this.#said,
    );
    viewer.addEventListener('field', ({ detail: { name, share } }) => {
      // The girth of fewer triangles is shown again at once when the refined one is stopped.
      const isStopped = name === 'igf' && share < 1 && this.method === 'refined';
      if (isStopped && viewer.shown) this.#choose('coarse');
    });
    viewer.addEventListener('error', ({ detail: { code } }) => {
      if (code === 'OUT_OF_MEMORY' && this.method === 'refined') this.#choose('coarse');
    });
    viewer.addEventListener('progress', () => this.show(this.#name));
    this.show(this.#name);
  }

  get method(): GirthMethod {
    const text = this.#viewer.getAttribute('method');
    return methods.find(([method]) => method === text)?.[0] ?? 'exact';
  }

  /** The method that the page uses unless somebody chooses. */
  get #usual(): GirthMethod {
    return usualMethod(this.#store.held.facts);
  }

  /** Another model. */
  clear(): void {
    this.#draft.discard();
    for (const option of this.#select.options) option.disabled = false;
  }

  /** Shows the choice for a field; hidden where no method matters to it, and for small models. */
  show(name: string): void {
    this.#name = name;
    const { method } = this;
    this.element.hidden = !concerned.has(name) || (method === 'exact' && this.#usual === 'exact');
    if (this.element.hidden) return;
    this.#draft.show(method);
    const { info } = this.#viewer;
    if (!info) return;
    if (this.#viewer.shareOf('igf') < 1) {
      this.#say(wordsBefore(method, info));
      return;
    }
    const refined = this.#select.options[methods.findIndex(([name]) => name === 'refined')]!;
    void Promise.all([this.#viewer.fieldOf('igf'), kernel]).then(
      ([field, { mode, threads }]) => {
        if (this.#viewer.info !== info || this.method !== method) return;
        const many = mode === 'threads' ? threads : 1;
        refined.disabled = refinedMemory(info, field.values, many) > mostMemory;
        this.#say(wordsOf(field, info, many));
      },
      () => undefined,
    );
  }

  /** Said once, however often it is shown. */
  #say(words: string): void {
    if (this.#said.textContent !== words) this.#said.textContent = words;
  }

  #choose(method: GirthMethod): void {
    this.#store.choose({ method: method === this.#usual ? undefined : method });
  }
}

/** A sentence on the method while it computes; '' for few triangles. */
function wordsBefore(method: GirthMethod, { vertexCount }: MeshInfo): string {
  if (method === 'refined') return 'The colours are those of fewer triangles until it is done.';
  if (method === 'coarse') return '';
  return `Exact at each of ${formatCount(vertexCount)} vertices: this may take hours.`;
}

/** A sentence on what was computed, and on the refined method where it is still to be had. */
function wordsOf(field: Field, info: MeshInfo, threads: number): string {
  if ('audit' in field) return auditWords((field as RefinedGirth).audit);
  // The refined method knows no persistence; and of what was computed exactly nothing is to be said.
  if (!field.note || field.persistence) return sentence(field.note);
  const bytes = refinedMemory(info, field.values, threads);
  const words =
    `${sentence(field.note)} Refined, at each of ${formatCount(info.vertexCount)} vertices, it takes about ` +
    `${memoryWords(bytes)} of memory`;
  if (bytes <= mostMemory) return `${words}.`;
  return (
    `${words}, and a page has ${memoryWords(mostMemory)}: about ${formatCount(mostFaces(info, field.values, threads))} ` +
    'faces fit, by remeshing in the details; the command has more memory.'
  );
}

/** The finding of the audit, in a sentence; '' where there was none. */
function auditWords({ vertices, equal }: GirthAudit): string {
  if (vertices === 0) return '';
  return (
    `${formatCount(equal)} of ${formatCount(vertices)} vertices that were drawn at random and computed exactly ` +
    `are equal to one part in a million.`
  );
}
