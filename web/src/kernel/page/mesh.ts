// A mesh on the page: it checks what is asked of it, and passes it to the workers.

import { defaults } from '../types/defaults.js';
import { failure } from '../types/errors.js';
import {
  checkName,
  fieldRequest,
  isLength,
  isSpectral,
  spectralNote,
  spectralRequest,
} from '../types/field-request.js';
import { summaryOf } from './field-run.js';
import type { MeshHost } from './mesh-host.js';
import type {
  Answer,
  Arguments,
  FileContent,
  GirthAndDiameter,
  JobOperations,
  OpenedSurface,
  PlacedStation,
  PrintArrays,
  Report,
  SegmentRequest,
  StudiesOperations,
  SurfaceWithInput,
  WrittenLoop,
  WrittenModel,
} from '../types/protocol.js';
import { checkedPoint, unpackedPoints } from './surface-point.js';
import { bytesOf, sizeOf, type SurfaceSource } from './surface-source.js';
import type {
  Barcode,
  BarcodeOptions,
  Barcodes,
  BarcodesOptions,
  Bottleneck,
  CallOptions,
  Cut,
  CutFormat,
  CutOptions,
  ExportOptions,
  Field,
  FieldFormat,
  FieldName,
  FieldOptions,
  HandleOptions,
  Handles,
  LevelCurve,
  Limb,
  LimbAxis,
  LimbOptions,
  Limbs,
  Loop,
  LoopFormat,
  LoopOptions,
  MaximaOptions,
  Maximum,
  Mesh,
  NamedField,
  NeckOptions,
  Necks,
  PartOptions,
  Parts,
  PartThresholds,
  PathStation,
  PrintCheck,
  PrintFields,
  PrintLimits,
  Profile,
  ProfileOptions,
  RefinedGirth,
  RefinedOptions,
  RemeshedMesh,
  RemeshOptions,
  RepairedMesh,
  SaddleBar,
  SegmentOptions,
  Segments,
  SpectralFieldName,
  SpectralOptions,
  SurfacePath,
  SurfacePoint,
  Tips,
  WatchedOptions,
} from '../types/types.js';
import { unitName, unitOf } from '../types/units.js';

/** Passes a worker's progress on until the signal fires. */
export const progressOf =
  (signal: AbortSignal | undefined, onProgress: WatchedOptions['onProgress']) =>
  (report: Report) => {
    if (!signal?.aborted && 'progress' in report) onProgress?.(report.progress);
  };

const wholeLimits = ({ tubeDiameter, wallThickness, gap = 0 }: PrintLimits) => ({
  tubeDiameter,
  wallThickness,
  gap,
});

/** Places of a profile, unless others are asked for. */
const profilePlaces = { samples: defaults.samples, crossings: true };

const whole = ({ girth, thickness, smoothing = 0 }: PartOptions) => ({
  girth,
  thickness,
  smoothing,
});

const divided = ({
  girth,
  thickness,
  minProminence = 0,
  smoothing = 0,
}: SegmentOptions): SegmentRequest => ({ girth, thickness, minProminence, smoothing });

export class MeshOfWorkers implements Mesh {
  readonly info: Mesh['info'];
  readonly geometry: Mesh['geometry'];
  readonly vertexOfInput: Uint32Array;
  /** As the workers for fields and loops know it. */
  readonly surface: SurfaceSource;
  /** As the workers for jobs know it. */
  readonly #jobSurface: SurfaceSource<SurfaceWithInput>;
  /** What the file has besides. */
  readonly #content: FileContent;
  readonly #host: MeshHost;
  readonly #life = new AbortController();

  constructor(host: MeshHost, opened: OpenedSurface) {
    const { info, arrays, origin, drawn, boundary, vertexOfInput, inputOfVertex } = opened;
    this.#host = host;
    this.#content = opened.content;
    this.surface = host.introduce(arrays, this.#life.signal);
    this.#jobSurface = { ...this.surface, arrays: { ...arrays, vertexOfInput, inputOfVertex } };
    this.info = info;
    this.geometry = { positions: drawn, indices: arrays.indices, boundary, origin };
    this.vertexOfInput = vertexOfInput;
  }

  async field(name: FieldName, options: FieldOptions = {}): Promise<Field> {
    checkName(String(name));
    const field = isSpectral(name)
      ? await this.#spectralField(name, options)
      : await this.#host.field(this.surface, fieldRequest(name, options), options);
    return { ...field, unit: unitOf(name, this.info.unit) };
  }

  async #spectralField(
    name: SpectralFieldName,
    { spectral, signal, onProgress }: FieldOptions,
  ): Promise<Omit<Field, 'unit'>> {
    const field = spectralRequest(name, spectral);
    const note = spectralNote(field);
    const { values, method } = await this.#askSpectral(
      'spectralField',
      { field },
      signal,
      onProgress,
    );
    const kinds = new Uint8Array(0);
    const { range, withoutValue } = summaryOf(values);
    onProgress?.(1);
    return { name, values, kinds, range, method, withoutValue, note };
  }

  async refinedGirth({
    coarseFaces = defaults.coarseFaces,
    audit = defaults.audit,
    seed = defaults.seed,
    ...options
  }: RefinedOptions = {}): Promise<RefinedGirth> {
    const request = { coarseFaces, audit, seed };
    const { onProgress } = options;
    const alone = (signal: AbortSignal) =>
      this.#ask('refinedGirth', { request }, signal, { onProgress });
    const found = await this.#host.refined(this.surface, request, options, alone);
    const { unit } = this.info;
    return { name: 'igf', method: 'refined', unit, ...summaryOf(found.values), ...found };
  }

  async loop(
    point: SurfacePoint,
    { persistence = 0, ...options }: LoopOptions = {},
  ): Promise<Loop> {
    const { unit } = this.info;
    const base = checkedPoint(point, this.info);
    const args = { point: base, persistence };
    const found = await this.#host.atPoint(this.surface, 'loop', args, options);
    return { ...found, points: unpackedPoints(found.points), base, unit };
  }

  async barcode(
    point: SurfacePoint,
    {
      maxPersistence = Infinity,
      maxSaddles = Infinity,
      loops: withLoops = false,
      ...options
    }: BarcodeOptions = {},
  ): Promise<Barcode> {
    const { unit } = this.info;
    const base = checkedPoint(point, this.info);
    const args = { point: base, maxPersistence, maxSaddles, loops: withLoops };
    const found = await this.#host.atPoint(this.surface, 'barcode', args, options);
    const bars = Array.from({ length: found.bars.length / 2 }, (_, i): SaddleBar => {
      return { birth: found.bars[2 * i]!, death: found.bars[2 * i + 1]! };
    });
    const loops = found.loops.map((loop): Loop => {
      return { ...loop, points: unpackedPoints(loop.points), base, unit };
    });
    const rest = { length: found.rest, kind: found.restKind };
    return { bars, loops, maxPersistence, rest, unit };
  }

  async barcodes({ maxPersistence, ...options }: BarcodesOptions): Promise<Barcodes> {
    const run = await this.#host.barcodes(this.surface, maxPersistence, options);
    return run.barcodes(maxPersistence, this.info.unit);
  }

  async path(
    from: SurfacePoint,
    to: SurfacePoint,
    { signal }: CallOptions = {},
  ): Promise<SurfacePath> {
    const { unit } = this.info;
    const [start, end] = [from, to].map((point) => checkedPoint(point, this.info));
    const found = await this.#ask('path', { from: start!, to: end! }, signal);
    return { ...found, unit };
  }

  async vertexAreas({ signal }: CallOptions = {}): Promise<Float64Array> {
    const { areas } = await this.#ask('vertexAreas', {}, signal);
    return areas;
  }

  async tips(igf: Field, { signal }: CallOptions = {}): Promise<Tips> {
    const girth = this.#own(igf, 'igf');
    return this.#ask('tips', { girth }, signal);
  }

  async limbs(
    igf: Field,
    { signal, onProgress, stations = defaults.stations }: LimbOptions = {},
  ): Promise<Limbs> {
    const girth = this.#own(igf, 'igf');
    return this.#ask('limbs', { girth, stations }, signal, { onProgress });
  }

  async necks(
    igf: Field,
    { signal, onProgress, minProminence = 0 }: NeckOptions = {},
  ): Promise<Necks> {
    const girth = this.#own(igf, 'igf');
    return this.#ask('necks', { girth, minProminence }, signal, { onProgress });
  }

  async bottleneck(
    igf: Field,
    from: SurfacePoint,
    to: SurfacePoint,
    { signal, onProgress }: WatchedOptions = {},
  ): Promise<Bottleneck> {
    const girth = this.#own(igf, 'igf');
    if (igf.persistence) {
      throw failure('USAGE', 'the girth is one with a persistence', {
        hint: 'compute it without: a bottleneck is one of the girth itself',
      });
    }
    const [start, end] = [from, to].map((point) => checkedPoint(point, this.info));
    const args = { girth, from: start!, to: end! };
    return this.#ask('bottleneck', args, signal, { onProgress });
  }

  async profile(
    points: readonly SurfacePoint[],
    { signal, onProgress, ...options }: ProfileOptions = {},
  ): Promise<Profile> {
    const { unit } = this.info;
    const args = { points: this.#checked(points), ...profilePlaces, ...options };
    const found = await this.#ask('profile', args, signal, { onProgress });
    return { ...found, unit };
  }

  async axis(
    { profile }: Pick<Limb, 'profile'>,
    { signal, onProgress }: WatchedOptions = {},
  ): Promise<LimbAxis> {
    const { unit } = this.info;
    const stations = profile.map(({ distance, least, place }): PlacedStation => {
      return place === undefined
        ? { distance, least }
        : { distance, least, place: checkedPoint(place, this.info) };
    });
    const found = await this.#ask('axis', { profile: stations }, signal, { onProgress });
    return { ...found, unit };
  }

  async exportProfile(
    given: readonly SurfacePoint[] | Profile | LimbAxis,
    format: 'csv' | 'json' | 'obj' | 'glb',
    { signal, unit, onProgress, ...options }: ExportOptions & ProfileOptions = {},
  ): Promise<Uint8Array> {
    const model = this.#written(unit);
    if ('loops' in given) {
      const loops = given.loops.map((loop): WrittenLoop => {
        const { distance, along, girth, centre, area } = loop;
        return { distance, along, girth, centre, area, points: this.#checked(loop.points) };
      });
      return (await this.#ask('writeAxis', { model, loops, format }, signal)).bytes;
    }
    if ('stations' in given) {
      const stations = given.stations.map(({ place, ...station }): PathStation => {
        return { ...station, place: checkedPoint(place, this.info) };
      });
      return (await this.#ask('writeStations', { model, stations, format }, signal)).bytes;
    }
    const points = this.#checked(given);
    const args = { model, points, ...profilePlaces, ...options, format };
    return (await this.#ask('writeProfile', args, signal, { onProgress })).bytes;
  }

  async handles({
    signal,
    onProgress,
    basePoints = defaults.basePoints,
  }: HandleOptions = {}): Promise<Handles> {
    return this.#ask('handles', { basePoints }, signal, { onProgress });
  }

  async removeHandles(
    length: number,
    { signal, onProgress, basePoints = defaults.basePoints }: HandleOptions = {},
  ): Promise<RepairedMesh> {
    const passing = bytesOf(this.#jobSurface);
    const args = { length, basePoints, info: this.info };
    const watched = { onProgress, passing };
    const { opened, removal } = await this.#ask('removeHandles', args, signal, watched);
    return Object.assign(new MeshOfWorkers(this.#host, opened), { removal });
  }

  async levelCurves(
    { values }: NamedField,
    level: number,
    { signal }: CallOptions = {},
  ): Promise<LevelCurve[]> {
    this.#checkCount(values);
    const { curves } = await this.#ask('levelCurves', { values, level }, signal);
    return curves;
  }

  async cut(
    curves: readonly (readonly SurfacePoint[])[],
    { signal, cap = false }: CutOptions = {},
  ): Promise<Cut> {
    return this.#ask('cut', { curves: curves.map((curve) => this.#checked(curve)), cap }, signal);
  }

  async exportCut(
    curves: readonly (readonly SurfacePoint[])[],
    format: CutFormat,
    { signal, unit, cap = false }: ExportOptions & CutOptions = {},
  ): Promise<Uint8Array[]> {
    const content = this.#content;
    const passing = this.#contentSize();
    const model = this.#written(unit);
    const args = {
      model,
      content,
      curves: curves.map((curve) => this.#checked(curve)),
      cap,
      format,
    };
    const { files } = await this.#ask('writeCut', args, signal, { passing });
    return files;
  }

  #checked(points: readonly SurfacePoint[]): SurfacePoint[] {
    return points.map((point) => checkedPoint(point, this.info));
  }

  async segments(
    igf: Field,
    sdf: Field,
    { signal, onProgress, ...options }: SegmentOptions = {},
  ): Promise<Segments> {
    const args = { fields: this.#girthAndDiameter(igf, sdf), options: divided(options) };
    return this.#ask('segments', args, signal, { onProgress });
  }

  async exportSegments(
    igf: Field,
    sdf: Field,
    format: 'csv' | 'json' | 'glb',
    { signal, onProgress, unit, ...options }: ExportOptions & SegmentOptions = {},
  ): Promise<Uint8Array> {
    const fields = this.#girthAndDiameter(igf, sdf);
    const [model, content] = [this.#written(unit), this.#content];
    const args = { model, content, fields, options: divided(options), format };
    const passing = this.#contentSize();
    const { bytes } = await this.#ask('writeSegments', args, signal, { onProgress, passing });
    return bytes;
  }

  #contentSize(): number {
    const { inputOfFace, rowOfCorner, values } = this.#content;
    return sizeOf([inputOfFace, rowOfCorner, values]);
  }

  async suggestedThresholds(
    igf: Field,
    sdf: Field,
    { signal }: CallOptions = {},
  ): Promise<PartThresholds> {
    const fields = this.#girthAndDiameter(igf, sdf);
    return this.#ask('thresholds', { fields }, signal);
  }

  async parts(
    igf: Field,
    sdf: Field,
    parts: PartOptions,
    { signal }: CallOptions = {},
  ): Promise<Parts> {
    const fields = this.#girthAndDiameter(igf, sdf);
    return this.#ask('parts', { fields, options: whole(parts) }, signal);
  }

  async maxima(
    { values }: NamedField,
    { signal, minima = false }: MaximaOptions = {},
  ): Promise<Maximum[]> {
    this.#checkCount(values);
    const { maxima } = await this.#ask('maxima', { values, minima }, signal);
    return maxima;
  }

  async heatMaxima({
    signal,
    onProgress,
    ...options
  }: WatchedOptions & SpectralOptions = {}): Promise<Maximum[]> {
    const field = spectralRequest('hks', options);
    const { maxima } = await this.#askSpectral('heatMaxima', { field }, signal, onProgress);
    onProgress?.(1);
    return maxima;
  }

  async printCheck(
    given: PrintFields,
    limited: PrintLimits,
    { signal, onProgress }: WatchedOptions = {},
  ): Promise<PrintCheck> {
    const limits = wholeLimits(limited);
    const args = { fields: this.#printed(given, limits), limits };
    return this.#ask('printCheck', args, signal, { onProgress });
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
      const none = new Uint8Array(0);
      const { name, values, kinds = none, states = none, method = '' } = field;
      this.#checkCount(values);
      for (const codes of [kinds, states]) if (codes.length > 0) this.#checkCount(codes);
      const ofField = isLength(name) ? (unit ?? field.unit) : field.unit;
      return { name, values, kinds, states, method, unit: unitName(ofField) };
    });
    const length = fields.find(({ name }) => isLength(name));
    const model = this.#written(unit ?? length?.unit);
    const args = { model, fields: written, format };
    const { bytes } = await this.#ask('writeFields', args, signal);
    return bytes;
  }

  async exportTips(
    igf: Field,
    format: 'json' | 'obj',
    { signal, unit }: ExportOptions = {},
  ): Promise<Uint8Array> {
    const girth = this.#own(igf, 'igf');
    const model = this.#written(unit, igf.persistence);
    const { bytes } = await this.#ask('writeTips', { model, girth, format }, signal);
    return bytes;
  }

  async exportLimbs(
    igf: Field,
    format: 'json' | 'csv',
    { signal, unit, onProgress, stations = defaults.stations }: ExportOptions & LimbOptions = {},
  ): Promise<Uint8Array> {
    const girth = this.#own(igf, 'igf');
    const args = { model: this.#written(unit, igf.persistence), girth, stations, format };
    const { bytes } = await this.#ask('writeLimbs', args, signal, { onProgress });
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
    const model = this.#written(unit, igf.persistence);
    const { bytes } = await this.#ask('writeParts', { model, fields, options, format }, signal);
    return bytes;
  }

  async exportWeakPlaces(
    given: PrintFields,
    limited: PrintLimits,
    format: 'json',
    { signal, unit }: ExportOptions = {},
  ): Promise<Uint8Array> {
    const limits = wholeLimits(limited);
    const fields = this.#printed(given, limits);
    const model = this.#written(unit, given.igf?.persistence);
    const { bytes } = await this.#ask('writeWeakPlaces', { model, fields, limits, format }, signal);
    return bytes;
  }

  async exportLoops(
    points: readonly SurfacePoint[],
    format: LoopFormat,
    { signal, unit, persistence }: ExportOptions & LoopOptions = {},
  ): Promise<Uint8Array[]> {
    const checked = points.map((point) => checkedPoint(point, this.info));
    const args = { model: this.#written(unit, persistence), points: checked, format };
    const { files } = await this.#ask('writeLoops', args, signal);
    return files;
  }

  async remesh(
    faces: number,
    { even = false, signal, onProgress }: RemeshOptions = {},
  ): Promise<RemeshedMesh> {
    const passing = bytesOf(this.#jobSurface);
    const args = { faces, even, info: this.info };
    const opened = await this.#ask('remesh', args, signal, { onProgress, passing });
    const mesh = new MeshOfWorkers(this.#host, opened);
    const none = new Uint8Array(0);
    return Object.assign(mesh, {
      carryBack: async (values: Float64Array, options: CallOptions = {}) =>
        (await this.#carryBack(mesh, values, none, options)).values,
      carryField: async (field: Field, options: CallOptions = {}) => {
        const { values, kinds, method: by = '' } = field;
        const carried = await this.#carryBack(mesh, values, kinds, options);
        const method = by && by.replace(/(?=,|$)/, ` on ${mesh.info.faceCount} faces`);
        return { ...field, ...carried, ...summaryOf(carried.values), method };
      },
    });
  }

  async smooth(steps: number, { signal, onProgress }: WatchedOptions = {}): Promise<Mesh> {
    const passing = bytesOf(this.#jobSurface);
    const opened = await this.#ask('smooth', { steps, info: this.info }, signal, {
      onProgress,
      passing,
    });
    return new MeshOfWorkers(this.#host, opened);
  }

  async #carryBack(
    remeshed: MeshOfWorkers,
    values: Float64Array,
    kinds: Uint8Array,
    { signal }: CallOptions,
  ): Promise<Pick<Field, 'values' | 'kinds'>> {
    if (values.length !== remeshed.info.vertexCount) {
      throw failure('USAGE', 'there is not one value for each vertex of the remeshed surface', {
        hint: 'carry back its own values',
      });
    }
    const args = { remeshed: remeshed.surface.number, values, kinds };
    return this.#ask('carryBack', args, signal, { other: remeshed });
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
    this.#checkCount(field.values);
    other.#checkCount(otherField.values);
    const args = {
      values: field.values,
      other: other.surface.number,
      otherValues: otherField.values,
    };
    const { difference } = await this.#ask('difference', args, signal, { other });
    return difference;
  }

  /** A job on this surface. The number of another one may be among the arguments. */
  #ask<K extends keyof JobOperations>(
    operation: K,
    args: Omit<Arguments<JobOperations, K>, 'surface'>,
    signal: AbortSignal | undefined,
    {
      other = this,
      onProgress,
      passing = 0,
    }: { other?: MeshOfWorkers; passing?: number } & Pick<WatchedOptions, 'onProgress'> = {},
  ): Promise<Answer<JobOperations, K>> {
    const onReport = progressOf(signal, onProgress);
    const surface = this.#jobSurface;
    const surfaces = [surface, ...(other === this ? [] : [other.#jobSurface])];
    return this.#host.job({ surfaces, passing }, signal, async (worker) => {
      for (const one of surfaces.slice(1)) await worker.adopt(one);
      return worker.requestOn(surface, operation, args, { onReport });
    });
  }

  #askSpectral<K extends 'spectralField' | 'heatMaxima'>(
    operation: K,
    args: Omit<Arguments<StudiesOperations, K>, 'surface'>,
    signal: AbortSignal | undefined,
    onProgress: WatchedOptions['onProgress'],
  ): Promise<Answer<StudiesOperations, K>> {
    const { surface } = this;
    const onReport = progressOf(signal, onProgress);
    return this.#host.spectralJob({ surfaces: [surface] }, signal, (worker) =>
      worker.requestOn(surface, operation, args, { onReport }),
    );
  }

  #checkCount(values: { length: number }): void {
    if (values.length === this.info.vertexCount) return;
    throw failure('USAGE', 'the field is not one of this mesh', {
      hint: 'use a field that was computed of this mesh',
    });
  }

  /** The values of the field `name` of this mesh; USAGE for another one. */
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

  /** What the limits need of the fields. */
  #printed({ igf, thickness }: PrintFields, limits: Required<PrintLimits>): PrintArrays {
    const values = (field: Field | undefined, name: FieldName, isNeeded: boolean) => {
      if (field) return this.#own(field, name);
      if (!isNeeded) return new Float64Array(0);
      throw failure('USAGE', `the field '${name}' is missing`, { hint: `compute '${name}' first` });
    };
    return {
      girth: values(igf, 'igf', limits.tubeDiameter > 0),
      thickness: values(thickness, 'thickness', limits.wallThickness > 0),
    };
  }

  #written(unit = this.info.unit, persistence = 0): WrittenModel {
    return { name: this.info.name, unit: unitName(unit), persistence };
  }

  dispose(): void {
    if (this.#life.signal.aborted) return;
    this.#life.abort('the mesh has been disposed of');
    this.#host.drop(this.surface.number);
  }
}
