// A model that is compared with others: read, and its fields computed, in the kernel's workers.

import type { Field, FieldName, Kernel, Mesh } from '../../../src/kernel/index.js';
import { failureWords } from '../../widgets/failure-words.js';
import type { Opened } from '../../model/session.js';

/** The page, as far as a compared model needs it. */
export interface ComparedModelHost {
  /** A field that the page has of the model, or is computing; undefined where it shows another one. */
  fieldOf(name: FieldName): Promise<Field> | undefined;
  changed(): void;
}

export class ComparedModel {
  mesh: Mesh | undefined;
  /** The area that each vertex stands for; of a surface whose own area is 1. */
  weights: Float64Array | undefined;
  /** The finished share of what is computed now. */
  share = 0;
  /** The reason why the model cannot be compared; '' where it can. */
  failure = '';
  /** Aborted to stop what is computed now; another one comes with the next computation. */
  #work = new AbortController();
  readonly #known = new Map<FieldName, Field>();
  #isDisposed = false;
  readonly opened: Opened;
  readonly name: string;
  readonly #host: ComparedModelHost;

  constructor(opened: Opened, name: string, host: ComparedModelHost) {
    this.opened = opened;
    this.name = name;
    this.#host = host;
  }

  /** The field, once it is computed. */
  fieldOf(name: FieldName): Field | undefined {
    return this.#known.get(name);
  }

  /** Values as if the surface had the area 1: size does not matter. */
  normalised(name: FieldName): Float64Array | undefined {
    const field = this.#known.get(name);
    const area = this.mesh?.info.area ?? 0;
    if (!field || !(area > 0)) return undefined;
    const scale = field.unit === 'radian' ? 1 : 1 / Math.sqrt(area);
    return field.values.map((value) => value * scale);
  }

  /** Reads the model and computes a field; what goes wrong is in `failure`. One at a time. */
  async compute(kernel: Kernel, name: FieldName): Promise<void> {
    this.#work = new AbortController();
    const { signal } = this.#work;
    this.share = 0;
    try {
      this.mesh ??= await this.#load(kernel, signal);
      this.weights ??= await this.mesh.vertexAreas({ signal });
      const onProgress = (share: number): void => {
        this.share = share;
        this.#host.changed();
      };
      const field =
        (await this.#fieldOfPage(name, signal)) ??
        (await this.mesh.field(name, { signal, onProgress }));
      this.#known.set(name, field);
    } catch (error) {
      if (!signal.aborted) this.failure = failureWords(error);
      else if (this.#isDisposed) this.mesh?.dispose();
    }
    this.share = 0;
    this.#host.changed();
  }

  /**
   * The field that the page has of the same surface: its vertices come in the same order. Undefined where
   * there is none, or where the page cancels it, for example because it shows another model.
   */
  async #fieldOfPage(name: FieldName, signal: AbortSignal): Promise<Field | undefined> {
    const field = this.#host.fieldOf(name)?.catch(() => undefined);
    if (!field) return undefined;
    const stopped = new Promise<undefined>((resolve) => {
      signal.addEventListener('abort', () => resolve(undefined), { once: true });
    });
    const found = await Promise.race([field, stopped]);
    signal.throwIfAborted();
    return found;
  }

  /** Stops the computation; it may be begun again. */
  cancel(): void {
    this.#work.abort();
  }

  /** Equation (1) of the paper; NaN where one of the two fields is missing. */
  async differenceTo(other: ComparedModel, name: FieldName, signal: AbortSignal): Promise<number> {
    const [field, otherField] = [this.#known.get(name), other.#known.get(name)];
    if (!this.mesh || !other.mesh || !field || !otherField) return NaN;
    return this.mesh.difference(field, other.mesh, otherField, { signal });
  }

  dispose(): void {
    this.#isDisposed = true;
    this.#work.abort();
    this.mesh?.dispose();
  }

  async #load(kernel: Kernel, signal: AbortSignal): Promise<Mesh> {
    const { source, model, prepare, remeshed, handles } = this.opened;
    const options = { signal, prepare, ...(model === undefined ? {} : { model }) };
    const address = typeof source === 'string' ? new URL(source, document.baseURI) : source;
    let mesh: Mesh = await kernel.load(address, options);
    if (remeshed) mesh = await madeOf(mesh, () => mesh.remesh(remeshed.faces, { signal }));
    if (handles !== undefined) {
      mesh = await madeOf(mesh, () => mesh.removeHandles(handles, { signal }));
    }
    return mesh;
  }
}

/** Another mesh, made of one that is not needed any more. */
async function madeOf(mesh: Mesh, make: () => Promise<Mesh>): Promise<Mesh> {
  try {
    return await make();
  } finally {
    mesh.dispose();
  }
}
