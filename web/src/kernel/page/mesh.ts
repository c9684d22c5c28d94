// A mesh on the page: it checks what is asked of it, and passes it to the workers.

import { type Analyses, analysisLists } from '../types/analyses.js';
import { defaults } from '../types/defaults.js';
import { disposal } from '../types/disposal.js';
import { failure } from '../types/errors.js';
import {
  checkName,
  fieldRequest,
  isLength,
  isSpectral,
  spectralNote,
  spectralRequest,
} from '../types/field-request.js';
import { alsoNamed } from '../types/older-names.js';
import { callOptionNames } from '../types/option-names.js';
import { checkCalls } from './checked-options.js';
import { summaryOf } from './field-run.js';
import { kindOf } from './found.js';
import type { MeshHost } from './mesh-host.js';
import type { JobOperations } from '../types/operations/job.js';
import type { StudiesOperations } from '../types/operations/studies.js';
import type {
  Answer,
  Arguments,
  FileContent,
  FoundBesides,
  GirthAndDiameter,
  OpenedSurface,
  PlacedStation,
  PrintArrays,
  Report,
  SegmentRequest,
  SurfaceWithInput,
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
  ModelFormat,
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
  WriteOptions,
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

const whole = ({ girth, shapeDiameter, smoothing = 0 }: PartOptions) => ({
  girth,
  shapeDiameter,
  smoothing,
});

const divided = ({
  girth,
  shapeDiameter,
  minProminence = 0,
  smoothing = 0,
}: SegmentOptions): SegmentRequest => ({ girth, shapeDiameter, minProminence, smoothing });

/** Has a call for each analysis: they are all alike, and made below. */
const MeshWithAnalyses = class {} as new () => Analyses;

export class MeshOfWorkers extends MeshWithAnalyses implements Mesh {
  readonly info: Mesh['info'];
  readonly geometry: Mesh['geometry'];
  readonly vertexOfInput: Uint32Array;
  /** As the workers for fields and loops know it. */
  readonly surface: SurfaceSource;
  /** As the workers for jobs know it. */
  readonly #jobSurface: SurfaceSource<SurfaceWithInput>;
  /** The content of the file besides the surface. */
  readonly #content: FileContent;
  /** Data that files of a result need, by the result that this mesh gave. */
  readonly #besides = new WeakMap<object, FoundBesides>();
  readonly #host: MeshHost;
  readonly #life = new AbortController();

  static {
    for (const analysis of Object.keys(analysisLists) as (keyof Analyses)[]) {
      this.prototype[analysis] = async function (
        this: MeshOfWorkers,
        { signal, onProgress, ...wanted }: WatchedOptions,
      ): Promise<never> {
        return (await this.#ask('analyse', { analysis, wanted }, { signal, onProgress })) as never;
      };
    }
    checkCalls(this.prototype, callOptionNames.Mesh);
  }

  constructor(host: MeshHost, opened: OpenedSurface) {
    super();
    const { info, arrays, origin, drawn, boundary, vertexOfInput, inputOfVertex } = opened;
    this.#host = host;
    this.#content = opened.content;
    this.surface = host.introduce(arrays, this.#life.signal);
    this.#jobSurface = { ...this.surface, arrays: { ...arrays, vertexOfInput, inputOfVertex } };
    this.info = info;
    const geometry = { positions: drawn, indices: arrays.indices, boundary, origin };
    this.geometry = alsoNamed(geometry, { walls: 'boundary' });
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
    { spectral, ...watched }: FieldOptions,
  ): Promise<Omit<Field, 'unit'>> {
    const signature = spectralRequest(name, spectral);
    const note = spectralNote(signature);
    const { values, method } = await this.#askSpectral('spectralField', { signature }, watched);
    const kinds = new Uint8Array(0);
    const { range, withoutValue } = summaryOf(values);
    watched.onProgress?.(1);
    return { name, values, kinds, range, method, withoutValue, note };
  }

  async refinedGirth({
    coarseFaces = defaults.coarseFaces,
    audit = defaults.audit,
    seed = defaults.seed,
    ...options
  }: RefinedOptions = {}): Promise<RefinedGirth> {
    const request = { coarseFaces, audit, seed };
    const alone = (signal: AbortSignal) =>
      this.#ask('refinedGirth', { request }, { ...options, signal });
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
    options: CallOptions = {},
  ): Promise<SurfacePath> {
    const found = await this.#ask('path', this.#ends(from, to), options);
    return { ...found, unit: this.info.unit };
  }

  async vertexAreas(options: CallOptions = {}): Promise<Float64Array> {
    return (await this.#ask('vertexAreas', {}, options)).areas;
  }

  async tips(igf: Field, options: CallOptions = {}): Promise<Tips> {
    const girth = this.#own(igf, 'igf');
    const { linePoints, ...tips } = await this.#ask('tips', { girth }, options);
    return this.#found(tips, { linePoints, persistence: igf.persistence });
  }

  async limbs(
    igf: Field,
    { stations = defaults.stations, ...options }: LimbOptions = {},
  ): Promise<Limbs> {
    const girth = this.#own(igf, 'igf');
    const limbs = await this.#ask('limbs', { girth, stations }, options);
    return this.#found(limbs, { persistence: igf.persistence });
  }

  async necks(igf: Field, { minProminence = 0, ...options }: NeckOptions = {}): Promise<Necks> {
    return this.#ask('necks', { girth: this.#own(igf, 'igf'), minProminence }, options);
  }

  async bottleneck(
    igf: Field,
    from: SurfacePoint,
    to: SurfacePoint,
    options: WatchedOptions = {},
  ): Promise<Bottleneck> {
    const girth = this.#own(igf, 'igf');
    if (igf.persistence) {
      throw failure('USAGE', 'the girth has a persistence', {
        hint: 'compute it without: bottlenecks need the plain girth',
      });
    }
    return this.#ask('bottleneck', { girth, ...this.#ends(from, to) }, options);
  }

  async profile(
    points: readonly SurfacePoint[],
    { signal, onProgress, ...options }: ProfileOptions = {},
  ): Promise<Profile> {
    const { unit } = this.info;
    const args = { points: this.#checked(points), ...profilePlaces, ...options };
    const found = await this.#ask('profile', args, { signal, onProgress });
    return { ...found, unit };
  }

  async axis({ profile }: Pick<Limb, 'profile'>, options: WatchedOptions = {}): Promise<LimbAxis> {
    const stations = profile.map(({ distance, least, place }): PlacedStation => {
      return place === undefined
        ? { distance, least }
        : { distance, least, place: checkedPoint(place, this.info) };
    });
    const found = await this.#ask('axis', { profile: stations }, options);
    return { ...found, unit: this.info.unit };
  }

  async exportProfile(
    given: readonly SurfacePoint[] | Profile | LimbAxis,
    format: 'csv' | 'json' | 'obj' | 'glb',
    { unit, ...options }: ExportOptions & ProfileOptions = {},
  ): Promise<Uint8Array> {
    const isMeasured = 'stations' in given || 'loops' in given;
    const along = isMeasured ? given : await this.profile(given, options);
    return this.write(along, format, { unit, signal: options.signal });
  }

  async write(
    found: object,
    format: string,
    { unit, profiles = false, ...options }: WriteOptions = {},
  ): Promise<Uint8Array> {
    const besides = this.#besides.get(found) ?? {};
    const { name, hasFaces } = kindOf(found, besides);
    const model = this.#written(unit, besides.persistence);
    const content = hasFaces && this.#content;
    const written = {
      ...besides,
      kind: name,
      result: this.#checkedAlong(found),
      profiles,
      ...(content && { content }),
    };
    const passing = content ? this.#contentSize() : 0;
    return (await this.#ask('writeFound', { model, found: written, format }, options, { passing }))
      .bytes;
  }

  /** Gives the result back, and keeps the data that its files need besides. */
  #found<Found extends object>(found: Found, besides: FoundBesides): Found {
    this.#besides.set(found, besides);
    return found;
  }

  /** The result with the places of a profile, or the points of an axis, checked, as callers may have made them. */
  #checkedAlong(found: Partial<Pick<Profile, 'stations'> & Pick<LimbAxis, 'loops'>>): object {
    const { stations, loops } = found;
    return {
      ...found,
      ...(stations && {
        stations: stations.map((station) => ({
          ...station,
          point: checkedPoint(station.place, this.info),
        })),
      }),
      ...(loops && {
        loops: loops.map((loop) => ({ ...loop, points: this.#checked(loop.points) })),
      }),
    };
  }

  async handles({
    basePoints = defaults.basePoints,
    ...options
  }: HandleOptions = {}): Promise<Handles> {
    return this.#ask('handles', { basePoints }, options);
  }

  async removeHandles(
    length: number,
    { basePoints = defaults.basePoints, ...options }: HandleOptions = {},
  ): Promise<RepairedMesh> {
    const passing = bytesOf(this.#jobSurface);
    const args = { length, basePoints, info: this.info };
    const { opened, removal } = await this.#ask('removeHandles', args, options, { passing });
    return Object.assign(new MeshOfWorkers(this.#host, opened), { removal });
  }

  async levelCurves(
    { values }: NamedField,
    level: number,
    options: CallOptions = {},
  ): Promise<LevelCurve[]> {
    this.#checkCount(values);
    return (await this.#ask('levelCurves', { values, level }, options)).curves;
  }

  async cut(
    curves: readonly (readonly SurfacePoint[])[],
    { cap = false, ...options }: CutOptions = {},
  ): Promise<Cut> {
    return this.#ask('cut', { curves: curves.map((curve) => this.#checked(curve)), cap }, options);
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
    const { files } = await this.#ask('writeCut', args, { signal }, { passing });
    return files;
  }

  #checked(points: readonly SurfacePoint[]): SurfacePoint[] {
    return points.map((point) => checkedPoint(point, this.info));
  }

  #ends(from: SurfacePoint, to: SurfacePoint) {
    return { from: checkedPoint(from, this.info), to: checkedPoint(to, this.info) };
  }

  async segments(igf: Field, sdf: Field, options: SegmentOptions = {}): Promise<Segments> {
    const args = { fields: this.#girthAndDiameter(igf, sdf), division: divided(options) };
    const { by, ...segments } = await this.#ask('segments', args, options);
    return this.#found(segments, { by });
  }

  async exportSegments(
    igf: Field,
    sdf: Field,
    format: 'csv' | 'json' | 'glb',
    { unit, ...options }: ExportOptions & SegmentOptions = {},
  ): Promise<Uint8Array> {
    const segments = await this.segments(igf, sdf, options);
    return this.write(segments, format, { unit, signal: options.signal });
  }

  #contentSize(): number {
    const { inputOfFace, rowOfCorner, values } = this.#content;
    return sizeOf([inputOfFace, rowOfCorner, values]);
  }

  async suggestedThresholds(
    igf: Field,
    sdf: Field,
    options: CallOptions = {},
  ): Promise<PartThresholds> {
    const args = { fields: this.#girthAndDiameter(igf, sdf) };
    const suggested = await this.#ask('suggestedThresholds', args, options);
    return alsoNamed(suggested, { thickness: 'shapeDiameter' });
  }

  async parts(
    igf: Field,
    sdf: Field,
    parts: PartOptions,
    options: CallOptions = {},
  ): Promise<Parts> {
    const args = { fields: this.#girthAndDiameter(igf, sdf), options: whole(parts) };
    const found = await this.#ask('parts', args, options);
    for (const part of found.parts) alsoNamed(part, { medianThickness: 'medianShapeDiameter' });
    return this.#found(found, { options: args.options, persistence: igf.persistence });
  }

  async maxima(
    { values }: NamedField,
    { minima = false, ...options }: MaximaOptions = {},
  ): Promise<Maximum[]> {
    this.#checkCount(values);
    return (await this.#ask('maxima', { values, minima }, options)).maxima;
  }

  async heatMaxima(options: WatchedOptions & SpectralOptions = {}): Promise<Maximum[]> {
    const signature = spectralRequest('hks', options);
    const { maxima } = await this.#askSpectral('heatMaxima', { signature }, options);
    options.onProgress?.(1);
    return maxima;
  }

  async printCheck(
    given: PrintFields,
    limited: PrintLimits,
    options: WatchedOptions = {},
  ): Promise<PrintCheck> {
    const limits = wholeLimits(limited);
    const printed = this.#printed(given, limits);
    const check = await this.#ask('printCheck', { printed, limits }, options);
    return this.#found(check, { limits, persistence: given.igf?.persistence });
  }

  async exportModel(
    format: ModelFormat,
    { signal, unit }: ExportOptions = {},
  ): Promise<Uint8Array> {
    const model = this.#written(unit);
    return (await this.#ask('writeModel', { model, format }, { signal })).bytes;
  }

  exportField(field: Field, format: FieldFormat, options: ExportOptions = {}): Promise<Uint8Array> {
    return this.exportFields([field], format, options);
  }

  async exportFields(
    fields: readonly NamedField[],
    format: FieldFormat,
    { signal, unit }: ExportOptions = {},
  ): Promise<Uint8Array> {
    const named = fields.map((field): NamedField => {
      const none = new Uint8Array(0);
      const { name, values, kinds = none, states = none, method = '' } = field;
      this.#checkCount(values);
      for (const codes of [kinds, states]) if (codes.length > 0) this.#checkCount(codes);
      const ofField = isLength(name) ? (unit ?? field.unit) : field.unit;
      return { name, values, kinds, states, method, unit: unitName(ofField) };
    });
    const length = fields.find(({ name }) => isLength(name));
    const model = this.#written(unit ?? length?.unit);
    return (await this.#ask('writeFields', { model, named, format }, { signal })).bytes;
  }

  async exportTips(
    igf: Field,
    format: 'json' | 'obj',
    options: ExportOptions = {},
  ): Promise<Uint8Array> {
    return this.write(await this.tips(igf, { signal: options.signal }), format, options);
  }

  async exportLimbs(
    igf: Field,
    format: 'json' | 'csv',
    { unit, ...options }: ExportOptions & LimbOptions = {},
  ): Promise<Uint8Array> {
    const limbs = await this.limbs(igf, options);
    return this.write(limbs, format, { unit, signal: options.signal });
  }

  async exportParts(
    igf: Field,
    sdf: Field,
    parts: PartOptions,
    format: 'json',
    options: ExportOptions = {},
  ): Promise<Uint8Array> {
    const { signal } = options;
    return this.write(await this.parts(igf, sdf, parts, { signal }), format, options);
  }

  async exportWeakPlaces(
    given: PrintFields,
    limits: PrintLimits,
    format: 'json',
    options: ExportOptions = {},
  ): Promise<Uint8Array> {
    const { signal } = options;
    return this.write(await this.printCheck(given, limits, { signal }), format, options);
  }

  async exportLoops(
    points: readonly SurfacePoint[],
    format: LoopFormat,
    { signal, unit, persistence }: ExportOptions & LoopOptions = {},
  ): Promise<Uint8Array[]> {
    const checked = points.map((point) => checkedPoint(point, this.info));
    const args = { model: this.#written(unit, persistence), points: checked, format };
    return (await this.#ask('writeLoops', args, { signal })).files;
  }

  async remesh(
    faces: number,
    { even = false, ...options }: RemeshOptions = {},
  ): Promise<RemeshedMesh> {
    const passing = bytesOf(this.#jobSurface);
    const args = { faces, even, info: this.info };
    const { opened } = await this.#ask('remesh', args, options, { passing });
    const mesh = new MeshOfWorkers(this.#host, opened);
    const none = new Uint8Array(0);
    const carrying = {
      carryBack: async (values: Float64Array, options: CallOptions = {}) =>
        (await this.#carryBack(mesh, values, none, options)).values,
      carryField: async (field: Field, options: CallOptions = {}) => {
        const { values, kinds, method: by = '' } = field;
        const carried = await this.#carryBack(mesh, values, kinds, options);
        const method = by && by.replace(/(?=,|$)/, ` on ${mesh.info.faceCount} faces`);
        return { ...field, ...carried, ...summaryOf(carried.values), method };
      },
    };
    checkCalls(carrying, callOptionNames.RemeshedMesh);
    return Object.assign(mesh, carrying);
  }

  async smooth(steps: number, options: WatchedOptions = {}): Promise<Mesh> {
    const passing = bytesOf(this.#jobSurface);
    const args = { steps, info: this.info };
    const { opened } = await this.#ask('smooth', args, options, { passing });
    return new MeshOfWorkers(this.#host, opened);
  }

  async #carryBack(
    remeshed: MeshOfWorkers,
    values: Float64Array,
    kinds: Uint8Array,
    options: CallOptions,
  ): Promise<Pick<Field, 'values' | 'kinds'>> {
    if (values.length !== remeshed.info.vertexCount) {
      throw failure('USAGE', 'there is not one value for each vertex of the remeshed surface', {
        hint: 'carry back its own values',
      });
    }
    const args = { remeshed: remeshed.surface.number, values, kinds };
    return this.#ask('carryBack', args, options, { other: remeshed });
  }

  async difference(
    field: Field,
    other: Mesh,
    otherField: Field,
    options: CallOptions = {},
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
    return (await this.#ask('difference', args, options, { other })).difference;
  }

  /** A job on this surface. The number of another one may be among the arguments. */
  #ask<K extends keyof JobOperations>(
    operation: K,
    args: Omit<Arguments<JobOperations, K>, 'surface'>,
    { signal, onProgress }: WatchedOptions,
    { other = this, passing = 0 }: { other?: MeshOfWorkers; passing?: number } = {},
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
    { signal, onProgress }: WatchedOptions,
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

  /** The values of the fields that the limits need. */
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

  [disposal](): void {
    this.dispose();
  }
}
