// The fields of one model: each is computed when it is first asked for, kept, and known in part meanwhile.

import { failure } from '../../kernel/types/errors.js';
import { summaryOf } from '../../kernel/page/field-run.js';
import { persistentFields } from '../../kernel/types/fields.js';
import { unitSymbol } from '../../kernel/types/units.js';
import type {
  Barcodes,
  Field,
  FieldName,
  FieldOptions,
  Mesh,
  MeshInfo,
  NamedField,
  PartialField,
  SpectralOptions,
} from '../../kernel/types/types.js';
import {
  type Adjacency,
  type CombinedName,
  FieldPreview,
  type GivenName,
  type ShownName,
  TimeLeft,
  type ValuesName,
  combinationOf,
  combinedUnit,
  fieldUnit,
  isFieldName,
  isGivenName,
} from '../../view/index.js';
import type { GirthMethod } from '../attributes/attribute-types.js';
import type { CombinedField, Operand } from './combined-field.js';
import { methodOf } from './girth-method.js';
import type { GivenField } from './given-fields.js';

/** One field, as far as it is computed. */
export interface FieldState {
  readonly name: FieldName;
  /** The values so far; gone once the whole field is there. */
  preview: FieldPreview | undefined;
  /** Set once the whole field is there. */
  field: Field | undefined;
  /** Set while it is computed. */
  running: { promise: Promise<Field>; abort: AbortController } | undefined;
}

export interface FieldsHost {
  /** Which number of its signature a field is to be; undefined: the usual one. */
  spectral(name: FieldName): SpectralOptions | undefined;
  /** How long saddles must last to count, in model units; 0: all do. */
  persistence(info: MeshInfo): number;
  /** How the girth is to be computed. */
  method(): GirthMethod;
  /** Values of elsewhere are in the state's preview until the field is there. */
  lent(state: FieldState): void;
  /** New values, not yet in the state's preview. */
  received(state: FieldState, partial: PartialField): void;
  progressed(name: FieldName, fraction: number, secondsLeft: number | undefined): void;
  /** A whole field has come; it counts once the promise is settled, or at once where there is none. */
  arriving(state: FieldState, field: Field): Promise<void> | undefined;
  /** The computation is over: complete, cancelled or failed. */
  ended(state: FieldState, error?: unknown): void;
}

const combiningKit = { failure, summaryOf, isFieldName, combinedUnit };

/** Whether a field depends on how long saddles must last. */
const concernsSaddles = (name: FieldName): boolean => persistentFields.includes(name);

/** Whether two lengths are the same but for rounding, as those of a surface in another size are. */
const isAlike = (one: number, other: number): boolean => Math.abs(one - other) <= 1e-9 * other;

export class Fields {
  readonly #states = new Map<FieldName, FieldState>();
  readonly #given = new Map<string, GivenField>();
  readonly #combined = new Map<ShownName, CombinedField>();
  /** The girth itself by each method, also while another one is shown, or one with a persistence. */
  readonly #girths = new Map<GirthMethod, Field>();
  /** Fields that were computed before, elsewhere, with the options of their computation. */
  readonly #adopted: { field: Field; spectral: SpectralOptions | undefined }[] = [];
  /** The saddles of all vertices, where they are kept. */
  #barcodes: Barcodes | undefined;
  /** Set while they are computed. */
  #keeping: { promise: Promise<void>; abort: AbortController; reach: number } | undefined;
  readonly #mesh: Mesh;
  readonly #adjacency: Adjacency;
  readonly #host: FieldsHost;

  /** `given`: what the model's file has for the surface's vertices. `girth`: that, where it is known already. */
  constructor(
    mesh: Mesh,
    adjacency: Adjacency,
    host: FieldsHost,
    given: readonly GivenField[] = [],
    girth?: Field,
  ) {
    this.#mesh = mesh;
    if (girth) this.#girths.set(methodOf(girth), girth);
    for (const field of given) this.#given.set(field.name, field);
    this.#adjacency = adjacency;
    this.#host = host;
  }

  /** Every field that was asked for. */
  get all(): Iterable<FieldState> {
    return this.#states.values();
  }

  get(name: FieldName): FieldState | undefined {
    return this.#states.get(name);
  }

  /** The field that the model's file has of a name, unless a computed one counts instead. */
  givenOf(name: ShownName): GivenField | undefined {
    // Computed fields are exact; and files have the usual numbers of signatures.
    if (isFieldName(name) && (this.#states.get(name)?.field || this.spectralOf(name))) {
      return undefined;
    }
    return this.#given.get(name);
  }

  /** The symbol of the unit of what the model's file has of a name; undefined where that does not count. */
  givenUnit(name: ShownName): string | undefined {
    const given = this.givenOf(name);
    return given && isGivenName(given.name) ? unitSymbol(given.unit) : undefined;
  }

  /** A whole field, computed or as the file has it. */
  wholeOf(name: ValuesName): Operand | undefined {
    return this.givenOf(name) ?? (isFieldName(name) ? this.#states.get(name)?.field : undefined);
  }

  /** Two fields in one; undefined before `combine`, and once one of them is another than then. */
  combinedOf(name: ShownName): CombinedField | undefined {
    const made = this.#combined.get(name);
    const of = made && combinationOf(name);
    const isStill = of && made.first === this.wholeOf(of.first);
    return isStill && made.second === this.wholeOf(of.second) ? made : undefined;
  }

  /** Makes one field of two, each of which is computed unless it is there. Errors: USAGE where there are none such. */
  async combine(name: CombinedName): Promise<CombinedField> {
    const { combined } = await import('./combined-field.js');
    const made =
      this.combinedOf(name) ?? (await combined(this, combinationOf(name)!, combiningKit));
    this.#combined.set(name, made);
    return made;
  }

  /** Makes one field of two for a file, where `unit` is that of lengths. */
  async combinedToWrite(name: CombinedName, unit: string): Promise<NamedField> {
    const made = await this.combine(name);
    const { combinedToWrite } = await import('./combined-field.js');
    const unitOf = (of: ValuesName): string => this.givenUnit(of) ?? fieldUnit(of, unit);
    return combinedToWrite(combinationOf(name)!, made, unitOf, combiningKit);
  }

  /** Fails as a wish for values does that the file has not. */
  async notGiven(name: GivenName): Promise<never> {
    const { notGiven } = await import('./own-values.js');
    throw notGiven(name, this.givenNames, failure);
  }

  /** The names of what the model's file has, in its order. */
  get givenNames(): (FieldName | GivenName)[] {
    return [...this.#given.values()].map(({ name }) => name);
  }

  /** The field that was asked for first among those that are being computed. */
  get computing(): FieldName | undefined {
    if (this.#keeping) return 'igf';
    return [...this.#states.values()].find(({ running }) => running)?.name;
  }

  /** The values there are, one per vertex; NaN where there is none, or none yet. */
  valuesOf(name: ShownName): Float64Array {
    const state = isFieldName(name) ? this.#states.get(name) : undefined;
    return (
      this.combinedOf(name)?.values ??
      state?.field?.values ??
      this.#given.get(name)?.values ??
      state?.preview?.values ??
      new Float64Array(this.#mesh.info.vertexCount).fill(NaN)
    );
  }

  /** The computed share of the vertices. */
  shareOf(name: FieldName): number {
    const state = this.#states.get(name);
    if (state?.field || this.#given.has(name)) return 1;
    return (state?.preview?.computed ?? 0) / this.#mesh.info.vertexCount;
  }

  /** The whole field; computed now unless it is there already. */
  compute(name: FieldName): Promise<Field> {
    let state = this.#states.get(name);
    if (!state) {
      state = { name, preview: undefined, field: undefined, running: undefined };
      this.#states.set(name, state);
    }
    if (state.field) return Promise.resolve(state.field);
    // One that was cancelled and is only coming to its end does not count.
    if (!state.running || state.running.abort.signal.aborted) {
      const abort = new AbortController();
      state.running = { promise: this.#run(state, abort), abort };
    }
    return state.running.promise;
  }

  /** The girth itself, whatever persistence the one that is shown has. */
  async girth(signal: AbortSignal): Promise<Field> {
    if (this.persistence === 0) return this.compute('igf');
    const known = this.#known('igf', 0);
    if (known) return known;
    const { method } = this;
    const girth = await this.#girthBy(method, undefined, { signal });
    this.#girths.set(method, girth);
    return girth;
  }

  /** How the girth is computed: refined, it knows of no persistence. */
  get method(): GirthMethod {
    const method = this.#host.method();
    return method === 'refined' && this.persistence > 0 ? 'coarse' : method;
  }

  /** Which number of its signature a field is. */
  spectralOf(name: FieldName): SpectralOptions | undefined {
    return this.#host.spectral(name);
  }

  /** How long saddles must last to count, in model units. */
  get persistence(): number {
    return this.#host.persistence(this.#mesh.info);
  }

  /**
   * Computes the saddles of all vertices and keeps them: from then on the girth with a persistence up to
   * `maxPersistence`, in model units, is there at once.
   */
  keepBarcodes(maxPersistence: number): Promise<void> {
    const reached = Math.max(this.#barcodes?.maxPersistence ?? 0, this.#keeping?.reach ?? 0);
    if (!(maxPersistence > reached)) return this.#keeping?.promise ?? Promise.resolve();
    this.#keeping?.abort.abort();
    const abort = new AbortController();
    this.#keeping = { promise: this.#keep(maxPersistence, abort), abort, reach: maxPersistence };
    return this.#keeping.promise;
  }

  /** Lets go of a field that is now to be another number of its signature. */
  forget(name: FieldName): void {
    const state = this.#states.get(name);
    this.#states.delete(name);
    this.#given.delete(name);
    state?.running?.abort.abort();
  }

  /** Stops every computation, or those of one field; what there is stays. */
  cancel(name?: string): void {
    if (name === undefined || name === 'igf') this.#keeping?.abort.abort();
    for (const state of this.#states.values()) {
      if (name === undefined || name === state.name) state.running?.abort.abort();
    }
  }

  async #run(state: FieldState, abort: AbortController): Promise<Field> {
    const { name } = state;
    const { signal } = abort;
    const { persistence, method } = this;
    let failure: unknown;
    try {
      const field = await (this.#known(name, persistence) ?? this.#computed(state, signal));
      if (name === 'igf' && persistence === 0) this.#girths.set(method, field);
      const arriving = this.#host.arriving(state, field);
      if (arriving) await arriving;
      state.field = field;
      state.preview = undefined;
      return field;
    } catch (error) {
      failure = error;
      throw error;
    } finally {
      if (!state.running || state.running.abort === abort) {
        state.running = undefined;
        this.#host.ended(state, failure);
      }
    }
  }

  async #keep(maxPersistence: number, abort: AbortController): Promise<void> {
    const { signal } = abort;
    const onProgress = this.#progressOf('igf', signal);
    try {
      onProgress(0);
      this.#barcodes = await this.#mesh.barcodes({ maxPersistence, signal, onProgress });
    } finally {
      if (this.#keeping?.abort === abort) this.#keeping = undefined;
    }
  }

  /** Takes a whole field that was computed before in place of computing it. */
  adopt(field: Field, spectral: SpectralOptions | undefined): void {
    this.#adopted.push({ field, spectral });
  }

  /** The field as far as it is known without computing it again. */
  #known(name: FieldName, persistence: number): Field | undefined {
    const wish = JSON.stringify(this.spectralOf(name));
    const adopted = this.#adopted.find(
      ({ field, spectral }) =>
        field.name === name &&
        (name !== 'igf' || methodOf(field) === this.method) &&
        isAlike(field.persistence ?? 0, concernsSaddles(name) ? persistence : 0) &&
        JSON.stringify(spectral) === wish,
    );
    if (adopted) return adopted.field;
    if (name !== 'igf') return undefined;
    if (persistence === 0) return this.#girths.get(this.method);
    if (this.method !== 'exact') return undefined;
    const barcodes = this.#barcodes;
    const isKept = barcodes !== undefined && persistence <= barcodes.maxPersistence;
    return isKept ? barcodes.girth(persistence) : undefined;
  }

  #computed(state: FieldState, signal: AbortSignal): Promise<Field> {
    const { name } = state;
    const spectral = this.spectralOf(name);
    const onProgress = this.#progressOf(name, signal);
    state.preview ??= new FieldPreview(this.#adjacency);
    onProgress(0);
    if (name === 'igf' && this.method !== 'exact') {
      return this.#girthBy(this.method, state, { signal, onProgress });
    }
    return this.#mesh.field(name, {
      signal,
      persistence: this.persistence,
      // The girth is computed unasked: what is asked for goes first.
      urgent: name !== 'igf',
      ...(spectral ? { spectral } : {}),
      onProgress,
      ...this.#receiving(state, signal),
    });
  }

  #receiving(state: FieldState, signal: AbortSignal): Required<Pick<FieldOptions, 'onPartial'>> {
    return {
      onPartial: (partial) => {
        if (!signal.aborted) this.#host.received(state, partial);
      },
    };
  }

  /** The girth by a method; refined, with that of few triangles to be seen until it is there. */
  async #girthBy(
    method: GirthMethod,
    state: FieldState | undefined,
    { signal, onProgress }: { signal: AbortSignal; onProgress?: (share: number) => void },
  ): Promise<Field> {
    const mesh = this.#mesh;
    const watched = { signal, ...(onProgress && { onProgress }) };
    if (method === 'exact') return mesh.field('igf', watched);
    const { coarseGirth, onItsOwn } = await import('./large-girth.js');
    if (method === 'coarse') {
      const persistence = state ? this.persistence : 0;
      const some = state ? this.#receiving(state, signal) : {};
      return onItsOwn(coarseGirth(mesh, { ...watched, ...some, persistence }));
    }
    if (state) {
      const some = { signal, persistence: 0, ...this.#receiving(state, signal) };
      const first = this.#girths.get('coarse') ?? (await coarseGirth(mesh, some));
      this.#girths.set('coarse', first);
      if (state.preview) {
        state.preview.lend(first.values, first.range);
        this.#host.lent(state);
      }
    }
    return onItsOwn(mesh.refinedGirth(watched));
  }

  #progressOf(name: FieldName, signal: AbortSignal): (fraction: number) => void {
    const timeLeft = new TimeLeft(performance.now());
    return (fraction) => {
      if (signal.aborted) return;
      const left = fraction > 0 ? timeLeft.update(fraction, performance.now()) : undefined;
      this.#host.progressed(name, fraction, left);
    };
  }
}
