// One model on the stage: its surface, and what is computed of it.

import { linked } from '../../kernel/page/abort.js';
import { failure } from '../../kernel/types/errors.js';
import type {
  Field,
  FieldName,
  Limbs,
  Maximum,
  Mesh,
  PartOptions,
  Parts,
  PartThresholds,
  PrintCheck,
  PrintFields,
  PrintLimits,
  SpectralOptions,
  Tips,
  WatchedOptions,
} from '../../kernel/types/types.js';
import {
  Surface,
  type UpAxis,
  buildAdjacency,
  inSlices,
  nextTask,
  splitCreases,
  upAxisOf,
} from '../../view/index.js';
import { Fields, type FieldsHost } from './fields.js';
import { type FileContent, onlySurface } from './file-content.js';

/** Sizes that the 32-bit numbers of drawing can hold, with room for what is computed of them. */
const drawnSizes = [1e-30, 1e30] as const;
/** Edges sharper than this stay visible as creases, in radians. */
const creaseAngle = (38 * Math.PI) / 180;

export class Model {
  /** Aborted when the model goes. */
  readonly life = new AbortController();
  readonly #kept = new Map<string, Promise<unknown>>();
  readonly mesh: Mesh;
  readonly surface: Surface;
  readonly fields: Fields;
  /** The content of the model's file besides the surface. */
  readonly file: FileContent;
  /** The way up that fits it. */
  readonly fitting: UpAxis;

  /** Made by `Model.of`. */
  constructor(mesh: Mesh, surface: Surface, fields: Fields, file: FileContent, fitting: UpAxis) {
    this.mesh = mesh;
    this.file = file;
    this.fitting = fitting;
    this.surface = surface;
    this.fields = fields;
  }

  /** Makes a mesh ready to draw, in slices of time. `girth`: that, where it is known already. */
  static async of(
    mesh: Mesh,
    host: FieldsHost,
    signal: AbortSignal,
    file: FileContent = onlySurface,
    girth?: Field,
  ): Promise<Model> {
    const { positions, indices, boundary } = mesh.geometry;
    checkSize(Math.max(...mesh.info.size));
    const adjacency = await inSlices(
      buildAdjacency(positions.length / 3, indices, boundary),
      signal,
    );
    const creased = await inSlices(splitCreases(positions, indices, creaseAngle), signal);
    const fitting = upAxisOf(null, mesh.info.format, positions, indices);
    await nextTask();
    signal.throwIfAborted();
    const surface = new Surface(positions, indices, boundary, adjacency, creased);
    const fields = new Fields(mesh, adjacency, host, file.fields, girth);
    // The next task puts the surface on the stage, and tells the page.
    await nextTask();
    signal.throwIfAborted();
    return new Model(mesh, surface, fields, file, fitting);
  }

  /** The girth is to be another one: results that were made of it no longer count. */
  forgetGirth(): void {
    this.fields.forget('igf');
    for (const name of this.#kept.keys()) if (name !== 'areas') this.#kept.delete(name);
  }

  /** The area that each vertex stands for. */
  areas(): Promise<Float64Array> {
    return this.#once('areas', () => this.mesh.vertexAreas(this.#watched));
  }

  tips(): Promise<Tips> {
    const { tips } = this.file;
    if (tips && this.file.isAll) return Promise.resolve(tips);
    return this.#once('tips', async () =>
      this.mesh.tips(await this.fields.compute('igf'), this.#watched),
    );
  }

  /** The limbs that the tips end; of several calls at a time, the first one has the progress and can stop it. */
  limbs({ signal, onProgress }: WatchedOptions = {}): Promise<Limbs> {
    return this.#once('limbs', async () => {
      const igf = await this.fields.compute('igf');
      const either = linked([this.life.signal, signal]);
      try {
        return await this.mesh.limbs(igf, {
          signal: either.signal,
          ...(onProgress ? { onProgress } : {}),
        });
      } finally {
        either.release();
      }
    });
  }

  /** The maxima of a field, or its minima, most persistent first. */
  maxima(name: FieldName, minima: boolean): Promise<Maximum[]> {
    const which = JSON.stringify(this.fields.spectralOf(name) ?? {});
    return this.#once(`${name} ${which} ${minima ? 'minima' : 'maxima'}`, async () =>
      this.mesh.maxima(await this.fields.compute(name), { ...this.#watched, minima }),
    );
  }

  /** The places where heat stays longest, most persistent first. */
  heatMaxima(options: SpectralOptions): Promise<Maximum[]> {
    return this.#once(`heat maxima ${JSON.stringify(options)}`, () =>
      this.mesh.heatMaxima({ ...options, ...this.#watched }),
    );
  }

  /** Thresholds to start from. */
  suggestedThresholds(): Promise<PartThresholds> {
    return this.#once('thresholds', async () => {
      const { igf, sdf } = await this.girthAndDiameter();
      return this.mesh.suggestedThresholds(igf, sdf, this.#watched);
    });
  }

  async parts(options: PartOptions): Promise<Parts> {
    const { igf, sdf } = await this.girthAndDiameter();
    return this.mesh.parts(igf, sdf, options, this.#watched);
  }

  async printCheck(limits: PrintLimits): Promise<PrintCheck> {
    return this.mesh.printCheck(await this.printFields(limits), limits, this.#watched);
  }

  /** The fields that limits need. */
  async printFields({ tubeDiameter, wallThickness }: PrintLimits): Promise<PrintFields> {
    const [igf, thickness] = await Promise.all([
      tubeDiameter > 0 ? this.fields.compute('igf') : undefined,
      wallThickness > 0 ? this.fields.compute('thickness') : undefined,
    ]);
    return { ...(igf && { igf }), ...(thickness && { thickness }) };
  }

  async girthAndDiameter() {
    const [igf, sdf] = await Promise.all([this.fields.compute('igf'), this.fields.compute('sdf')]);
    return { igf, sdf };
  }

  /**
   * Ends all work on the model and lets go of its memory, but for the mesh where that is kept; the
   * stage disposes of the surface.
   */
  dispose(keepsMesh = false): void {
    this.fields.cancel();
    this.life.abort();
    if (!keepsMesh) this.mesh.dispose();
  }

  get #watched(): { signal: AbortSignal } {
    return { signal: this.life.signal };
  }

  /** Computes something once; again where it failed or was cancelled. */
  #once<Answer>(name: string, compute: () => Promise<Answer>): Promise<Answer> {
    const there = this.#kept.get(name) as Promise<Answer> | undefined;
    if (there) return there;
    const promise = compute();
    this.#kept.set(name, promise);
    promise.catch(() => this.#kept.delete(name));
    return promise;
  }
}

function checkSize(size: number): void {
  const [least, most] = drawnSizes;
  if (size >= least && size <= most) return;
  const digits = Math.abs(Math.floor(Math.log10(most)));
  const words =
    size > most
      ? `too large to be drawn: its size has more than ${digits} digits`
      : `too small to be drawn: its size begins with ${digits} zeros or more`;
  throw failure('LIMIT_EXCEEDED', `the surface is ${words}`, {
    hint: 'export the model in another unit',
  });
}
