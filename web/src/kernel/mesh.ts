// A mesh as the page has it: what can be asked of it, and by whom it is answered.

import { failure } from './errors.js';
import {
  checkName,
  fieldRequest,
  isLength,
  isSpectral,
  spectralNote,
  spectralRequest,
  unitOf,
} from './field-request.js';
import { summaryOf } from './field-run.js';
import type { KernelOfWorkers } from './kernel.js';
import type {
  GirthAndDiameter,
  OpenedSurface,
  Report,
  StudiesOperations,
  JobOperations,
  WrittenModel,
} from './protocol.js';
import { checkedPoint } from './surface-point.js';
import type {
  CallOptions,
  ExportOptions,
  Field,
  FieldFormat,
  FieldName,
  FieldOptions,
  Loop,
  LoopFormat,
  Maximum,
  Mesh,
  NamedField,
  PartOptions,
  Parts,
  PartThresholds,
  PrintLimits,
  RemeshedMesh,
  SpectralFieldName,
  SpectralOptions,
  SurfacePoint,
  Tips,
  WatchedOptions,
  WeakPlace,
} from './types.js';
import type { SurfaceSource, WorkerClient } from './worker-client.js';

/** Units as files call them. */
const unitNames: Record<string, string | undefined> = {
  m: 'metre',
  mm: 'millimetre',
  cm: 'centimetre',
  in: 'inch',
  ft: 'foot',
  rad: 'radian',
};
function unitName(unit: string): string {
  const ofDensity = /^1\/(.+)²$/.exec(unit)?.[1];
  return ofDensity === undefined ? (unitNames[unit] ?? unit) : `${unitName(ofDensity)}^-2`;
}

/** Passes a worker's progress on, until it is no longer wanted. */
const progressOf =
  (signal: AbortSignal | undefined, onProgress: WatchedOptions['onProgress']) =>
  (report: Report) => {
    if (!signal?.aborted && 'progress' in report) onProgress?.(report.progress);
  };

const whole = ({ girth, diameter, smoothing = 0 }: PartOptions) => ({ girth, diameter, smoothing });

export class MeshOfWorkers implements Mesh {
  readonly info: Mesh['info'];
  readonly geometry: Mesh['geometry'];
  readonly vertexOfInput: Uint32Array;
  /** As the workers know it. */
  readonly surface: SurfaceSource;
  readonly #kernel: KernelOfWorkers;
  readonly #inputOfVertex: Uint32Array;
  readonly #life = new AbortController();
  /** Fires when the mesh is disposed of. */
  readonly life = this.#life.signal;

  constructor(kernel: KernelOfWorkers, opened: OpenedSurface & { number: number }) {
    const { number, info, arrays, origin, drawn, boundary, vertexOfInput, inputOfVertex } = opened;
    this.#kernel = kernel;
    this.surface = { number, arrays };
    this.info = info;
    this.geometry = { positions: drawn, indices: arrays.indices, boundary, origin };
    this.vertexOfInput = vertexOfInput;
    this.#inputOfVertex = inputOfVertex;
  }

  async field(name: FieldName, options: FieldOptions = {}): Promise<Field> {
    checkName(String(name));
    const field = isSpectral(name)
      ? await this.#spectralField(name, options)
      : await this.#kernel.field(
          this.surface,
          fieldRequest(name, options),
          this.#life.signal,
          options,
        );
    return { ...field, unit: unitOf(name, this.info.unit) };
  }

  async #spectralField(
    name: SpectralFieldName,
    { spectral, signal, onProgress }: FieldOptions,
  ): Promise<Omit<Field, 'unit'>> {
    const field = spectralRequest(name, spectral);
    const note = spectralNote(field);
    const { values, method } = await this.#makeSpectral(signal, (worker) =>
      worker.requestOn(
        this.surface,
        'spectralField',
        { field },
        { onReport: progressOf(signal, onProgress) },
      ),
    );
    const kinds = new Uint8Array(0);
    const { range, withoutValue } = summaryOf(values);
    onProgress?.(1);
    return { name, values, kinds, range, method, withoutValue, note };
  }

  async loop(point: SurfacePoint, options: CallOptions = {}): Promise<Loop> {
    const { unit } = this.info;
    const base = checkedPoint(point, this.info);
    const found = await this.#kernel.loop(this.surface, base, this.#life.signal, options);
    return { ...found, base, unit };
  }

  async vertexAreas({ signal }: CallOptions = {}): Promise<Float64Array> {
    const { arrays } = this.surface;
    const { areas } = await this.#make(signal, (worker) =>
      worker.request('vertexAreas', { arrays }),
    );
    return areas;
  }

  async tips(igf: Field, { signal }: CallOptions = {}): Promise<Tips> {
    const girth = this.#own(igf, 'igf');
    const { arrays } = this.surface;
    return this.#make(signal, (worker) => worker.request('tips', { arrays, girth }));
  }

  async suggestedThresholds(
    igf: Field,
    sdf: Field,
    { signal }: CallOptions = {},
  ): Promise<PartThresholds> {
    const fields = this.#girthAndDiameter(igf, sdf);
    const { arrays } = this.surface;
    return this.#make(signal, (worker) => worker.request('thresholds', { arrays, fields }));
  }

  async parts(
    igf: Field,
    sdf: Field,
    parts: PartOptions,
    { signal }: CallOptions = {},
  ): Promise<Parts> {
    const fields = this.#girthAndDiameter(igf, sdf);
    const options = whole(parts);
    const { arrays } = this.surface;
    return this.#make(signal, (worker) => worker.request('parts', { arrays, fields, options }));
  }

  async maxima(
    { values }: NamedField,
    { signal, minima = false }: CallOptions & { minima?: boolean } = {},
  ): Promise<Maximum[]> {
    this.#checkCount(values);
    const { arrays } = this.surface;
    const found = await this.#make(signal, (worker) =>
      worker.request('maxima', { arrays, values, minima }),
    );
    return found.maxima;
  }

  async heatMaxima({
    signal,
    onProgress,
    ...options
  }: WatchedOptions & SpectralOptions = {}): Promise<Maximum[]> {
    const field = spectralRequest('hks', options);
    const { maxima } = await this.#makeSpectral(signal, (worker) =>
      worker.requestOn(
        this.surface,
        'heatMaxima',
        { field },
        { onReport: progressOf(signal, onProgress) },
      ),
    );
    onProgress?.(1);
    return maxima;
  }

  async weakPlaces(
    igf: Field,
    sdf: Field,
    { tubeDiameter, wallThickness }: PrintLimits,
    { signal }: CallOptions = {},
  ): Promise<WeakPlace[]> {
    const fields = this.#girthAndDiameter(igf, sdf);
    const limits = { tubeDiameter, wallThickness };
    const { arrays } = this.surface;
    const { places } = await this.#make(signal, (worker) =>
      worker.request('weakPlaces', { arrays, fields, limits }),
    );
    return places;
  }

  exportField(field: Field, format: FieldFormat, options: ExportOptions = {}): Promise<Uint8Array> {
    return this.exportFields([field], format, options);
  }

  async exportFields(
    fields: readonly NamedField[],
    format: FieldFormat,
    { signal, unit }: ExportOptions = {},
  ): Promise<Uint8Array> {
    const written = fields.map((field): NamedField => {
      const { name, values, kinds = new Uint8Array(0), method = '' } = field;
      this.#checkCount(values);
      if (kinds.length > 0) this.#checkCount(kinds);
      const ofField = isLength(name) ? (unit ?? field.unit) : field.unit;
      return { name, values, kinds, method, unit: unitName(ofField) };
    });
    const length = fields.find(({ name }) => isLength(name));
    const model = this.#written(unit ?? length?.unit);
    const { bytes } = await this.#make(signal, (worker) =>
      worker.request('writeFields', { model, fields: written, format }),
    );
    return bytes;
  }

  async exportTips(
    igf: Field,
    format: 'json' | 'obj',
    { signal, unit }: ExportOptions = {},
  ): Promise<Uint8Array> {
    const girth = this.#own(igf, 'igf');
    const model = this.#written(unit);
    const { bytes } = await this.#make(signal, (worker) =>
      worker.request('writeTips', { model, girth, format }),
    );
    return bytes;
  }

  async exportParts(
    igf: Field,
    sdf: Field,
    parts: PartOptions,
    format: 'json',
    { signal, unit }: ExportOptions = {},
  ): Promise<Uint8Array> {
    const fields = this.#girthAndDiameter(igf, sdf);
    const options = whole(parts);
    const model = this.#written(unit);
    const { bytes } = await this.#make(signal, (worker) =>
      worker.request('writeParts', { model, fields, options, format }),
    );
    return bytes;
  }

  async exportWeakPlaces(
    igf: Field,
    sdf: Field,
    { tubeDiameter, wallThickness }: PrintLimits,
    format: 'json',
    { signal, unit }: ExportOptions = {},
  ): Promise<Uint8Array> {
    const fields = this.#girthAndDiameter(igf, sdf);
    const limits = { tubeDiameter, wallThickness };
    const model = this.#written(unit);
    const { bytes } = await this.#make(signal, (worker) =>
      worker.request('writeWeakPlaces', { model, fields, limits, format }),
    );
    return bytes;
  }

  async exportLoops(
    points: readonly SurfacePoint[],
    format: LoopFormat,
    { signal, unit }: ExportOptions = {},
  ): Promise<Uint8Array[]> {
    const checked = points.map((point) => checkedPoint(point, this.info));
    const { files } = await this.#make(signal, (worker) =>
      worker.request('writeLoops', { model: this.#written(unit), points: checked, format }),
    );
    return files;
  }

  async remesh(faces: number, { signal, onProgress }: WatchedOptions = {}): Promise<RemeshedMesh> {
    const { info } = this;
    const { arrays } = this.surface;
    const opened = await this.#make(signal, (worker) =>
      worker.request(
        'remesh',
        { arrays, faces, info },
        { onReport: progressOf(signal, onProgress) },
      ),
    );
    const mesh = this.#kernel.open(opened);
    const carryBack: RemeshedMesh['carryBack'] = async (values, options = {}) => {
      if (values.length !== mesh.info.vertexCount) {
        throw failure('USAGE', 'there is not one value for each vertex of the remeshed surface', {
          hint: 'carry back its own values',
        });
      }
      const remeshed = opened.arrays;
      const carried = await this.#make(options.signal, (worker) =>
        worker.request('carryBack', { original: arrays, remeshed, values }),
      );
      return carried.values;
    };
    return Object.assign(mesh, { carryBack });
  }

  async difference(
    field: Field,
    other: Mesh,
    otherField: Field,
    { signal }: CallOptions = {},
  ): Promise<number> {
    if (!(other instanceof MeshOfWorkers)) {
      throw failure('USAGE', 'the other mesh is not one of this package', {
        hint: 'load it with a kernel',
      });
    }
    const fields = [
      { ...this.surface.arrays, values: field.values },
      { ...other.surface.arrays, values: otherField.values },
    ] as const;
    const { difference } = await this.#make(signal, (worker) =>
      worker.request('difference', { fields }),
    );
    return difference;
  }

  #make<T>(
    signal: AbortSignal | undefined,
    job: (worker: WorkerClient<JobOperations>) => Promise<T>,
  ): Promise<T> {
    return this.#kernel.make(this.#bytes, [signal, this.#life.signal], job);
  }

  #makeSpectral<T>(
    signal: AbortSignal | undefined,
    job: (worker: WorkerClient<StudiesOperations>) => Promise<T>,
  ): Promise<T> {
    return this.#kernel.makeSpectral(this.#bytes, [signal, this.#life.signal], job);
  }

  get #bytes(): number {
    const { positions, indices } = this.surface.arrays;
    return positions.byteLength + indices.byteLength;
  }

  #checkCount(values: { length: number }): void {
    if (values.length === this.info.vertexCount) return;
    throw failure('USAGE', 'the field is not one of this mesh', {
      hint: 'use a field that was computed of this mesh',
    });
  }

  /** The values of a field of this mesh that is to be of a kind. */
  #own(field: Field, name: FieldName): Float64Array {
    if (field.name !== name) {
      throw failure('USAGE', `the field is '${String(field.name)}', not '${name}'`, {
        hint: `compute '${name}' first`,
      });
    }
    this.#checkCount(field.values);
    return field.values;
  }

  #girthAndDiameter(igf: Field, sdf: Field): GirthAndDiameter {
    return { girth: this.#own(igf, 'igf'), diameter: this.#own(sdf, 'sdf') };
  }

  #written(unit = this.info.unit): WrittenModel {
    const { vertexOfInput, info, surface } = this;
    const inputOfVertex = this.#inputOfVertex;
    const { name } = info;
    return { ...surface.arrays, vertexOfInput, inputOfVertex, name, unit: unitName(unit) };
  }

  dispose(): void {
    if (this.#life.signal.aborted) return;
    this.#life.abort('the mesh has been disposed of');
    this.#kernel.drop(this.surface.number);
  }
}
