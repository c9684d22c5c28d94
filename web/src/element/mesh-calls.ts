// Calls that `<girth-viewer>` passes on to the mesh that the kernel has read. Each ends with the model; fields that it
// needs are computed first.

import type {
  Barcode,
  BarcodeOptions,
  Bottleneck,
  CallOptions,
  Cut,
  CutFormat,
  CutOptions,
  Field,
  FieldFormat,
  FieldName,
  FormatOf,
  HandleOptions,
  Handles,
  LevelCurve,
  Limb,
  LimbAxis,
  Limbs,
  Loop,
  LoopFormat,
  Maximum,
  Mesh,
  MeshGeometry,
  ModelFormat,
  NamedField,
  NeckOptions,
  Necks,
  PartOptions,
  Parts,
  PartThresholds,
  PrintCheck,
  PrintLimits,
  Profile,
  ProfileOptions,
  SegmentOptions,
  Segments,
  SpectralOptions,
  SurfacePath,
  SurfacePoint,
  Tips,
  WatchedOptions,
  WriteOptions,
} from '../kernel/types/types.js';
import type { CombinedName } from '../view/index.js';
import { isFieldName } from '../view/field-words.js';
import type { Fields } from './model/fields.js';
import type { LoopsOnSurface } from './surface/loops-on-surface.js';
import type { Model } from './model/model.js';
import { ViewerShell } from './viewer-shell.js';

/** Parts of the shown model that calls need. */
interface Asked {
  model: Model;
  mesh: Mesh;
  fields: Fields;
  loops: LoopsOnSurface;
  /** Fires when the model goes. */
  signal: AbortSignal;
}

/** See `GirthViewer`, which adds what is drawn. */
export abstract class MeshCalls extends ViewerShell {
  async #ask<Answer>(ask: (asked: Asked) => Answer | Promise<Answer>): Promise<Answer> {
    const { model, loops } = await this.whole();
    const { mesh, fields, life } = model;
    return ask({ model, mesh, fields, loops, signal: life.signal });
  }

  /** The vertex of the surface for each vertex of the file; 0xFFFFFFFF where no face uses it. */
  get vertexOfInput(): Uint32Array {
    return this.require().model.mesh.vertexOfInput;
  }

  /** The surface that is drawn: do not modify its arrays. */
  get geometry(): MeshGeometry {
    return this.require().model.mesh.geometry;
  }

  /**
   * The mesh that is shown, to be asked for all that the kernel computes; read by it first where that has not been done
   * yet. Rejected where no model is shown. It is the element's: do not dispose of it.
   */
  get mesh(): Promise<Mesh> {
    return this.#ask(({ mesh }) => mesh);
  }

  /** A whole field; computed now, in view of the user, unless it is there. Cancelling rejects. */
  async fieldOf(name: FieldName): Promise<Field> {
    if (!isFieldName(name)) throw new RangeError(`no field is called ${String(name)}`);
    const { fields, file } = this.require().model;
    const given = fields.givenOf(name);
    if (file.isAll && given) return { ...given, name };
    return this.#ask(({ fields }) => fields.compute(name));
  }

  /** The area that each vertex of the surface stands for. */
  async areas(): Promise<Float64Array> {
    return this.require().model.areas();
  }

  /** The tips; the girth is computed first unless it is there. */
  async tips(): Promise<Tips> {
    const { model } = this.require();
    return model.file.tips ? model.tips() : this.#ask((whole) => whole.model.tips());
  }

  /**
   * The limbs that the tips end, and how thick they are all along; the girth is computed first unless it is
   * there. The first of several calls at a time has the progress and can stop it.
   */
  limbs(options: WatchedOptions = {}): Promise<Limbs> {
    return this.#ask(({ model }) => model.limbs(options));
  }

  /** Where a field is greatest, or least, among its surroundings; most persistent first. */
  maxima(name: FieldName, options: { minima?: boolean } = {}): Promise<Maximum[]> {
    return this.#ask(({ model }) => model.maxima(name, options.minima ?? false));
  }

  /** Where heat stays longest, most persistent first: the paper's comparison with the tips. */
  heatMaxima(options: SpectralOptions = {}): Promise<Maximum[]> {
    return this.#ask(({ model }) => model.heatMaxima(options));
  }

  /** Thresholds to start from; girth and shape diameter are computed first. */
  suggestedThresholds(): Promise<PartThresholds> {
    return this.#ask(({ model }) => model.suggestedThresholds());
  }

  /** Tubes, plates and body as connected parts; girth and shape diameter are computed first. */
  parts(options: PartOptions): Promise<Parts> {
    return this.#ask(({ model }) => model.parts(options));
  }

  /**
   * Places too thin to print or too close together, and the least scale without any; the fields that the
   * limits need are computed first.
   */
  printCheck(limits: PrintLimits): Promise<PrintCheck> {
    return this.#ask(({ model }) => model.printCheck(limits));
  }

  /** The exact loop at a vertex of the surface, or at a point of one of its faces. */
  loop(point: SurfacePoint): Promise<Loop> {
    return this.#ask(({ mesh, fields, signal }) =>
      mesh.loop(point, { signal, persistence: fields.persistence }),
    );
  }

  /** The saddles of the distance from a point, those that `persistence` passes over too. */
  barcode(point: SurfacePoint, options: BarcodeOptions = {}): Promise<Barcode> {
    return this.#ask(({ mesh, signal }) => mesh.barcode(point, { signal, ...options }));
  }

  /** The shortest path between two points, and how far they are apart in space. */
  path(from: SurfacePoint, to: SurfacePoint): Promise<SurfacePath> {
    return this.#ask(({ mesh, signal }) => mesh.path(from, to, { signal }));
  }

  /**
   * The places that are narrower than all around them; the girth is computed first unless it is there.
   * @experimental
   */
  necks(options: NeckOptions = {}): Promise<Necks> {
    return this.#ask(async ({ mesh, fields, signal }) =>
      mesh.necks(await fields.compute('igf'), { signal, ...options }),
    );
  }

  /**
   * The narrowest place on the widest way from one point to another; the girth is computed first unless it is there.
   * @experimental
   */
  bottleneck(
    from: SurfacePoint,
    to: SurfacePoint,
    options: WatchedOptions = {},
  ): Promise<Bottleneck> {
    return this.#ask(async ({ mesh, fields, signal }) =>
      mesh.bottleneck(await fields.girth(signal), from, to, { signal, ...options }),
    );
  }

  /**
   * The girth along the shortest path through two points or more.
   * @experimental
   */
  profile(points: readonly SurfacePoint[], options: ProfileOptions = {}): Promise<Profile> {
    return this.#ask(({ mesh, signal }) => mesh.profile(points, { signal, ...options }));
  }

  /**
   * The girth along the axis of a limb, with the loops that are swept along it.
   * @experimental
   */
  axis(limb: Pick<Limb, 'profile'>, options: WatchedOptions = {}): Promise<LimbAxis> {
    return this.#ask(({ mesh, signal }) => mesh.axis(limb, { signal, ...options }));
  }

  /**
   * Short loops round the surface's handles and through its holes.
   * @experimental
   */
  handles(options: HandleOptions = {}): Promise<Handles> {
    return this.#ask(({ mesh, signal }) => mesh.handles({ signal, ...options }));
  }

  /**
   * Where the girth has one value; it is computed first unless it is there.
   * @experimental
   */
  levelCurves(girth: number, options: CallOptions = {}): Promise<LevelCurve[]> {
    return this.#ask(async ({ mesh, fields, signal }) =>
      mesh.levelCurves(await fields.compute('igf'), girth, { signal, ...options }),
    );
  }

  /**
   * The parts of the surface, cut along curves; what is shown stays whole.
   * @experimental
   */
  cut(curves: readonly (readonly SurfacePoint[])[], options: CutOptions = {}): Promise<Cut> {
    return this.#ask(({ mesh, signal }) => mesh.cut(curves, { signal, ...options }));
  }

  /**
   * The parts that the surface falls into at its necks, and the kind of each; girth and shape diameter are computed
   * first. The shown surface stays whole.
   * @experimental
   */
  segments(options: SegmentOptions = {}): Promise<Segments> {
    return this.#ask(async ({ model, mesh, signal }) => {
      const { igf, sdf } = await model.girthAndDiameter();
      return mesh.segments(igf, sdf, { signal, ...options });
    });
  }

  /** The surface as a file's content, without values: see `Mesh.exportModel`. Lengths are in the element's unit. */
  exportModel(format: ModelFormat): Promise<Uint8Array> {
    return this.#ask(({ mesh, signal }) => mesh.exportModel(format, { signal, unit: this.unit }));
  }

  /** A field, or two in one, as a file's content; computed first unless it is there. */
  async exportField(
    format: FieldFormat,
    name: FieldName | CombinedName = 'igf',
  ): Promise<Uint8Array> {
    return this.exportFields([name], format);
  }

  /** Several fields in one file, also such as were not computed here; NPY takes only one. */
  exportFields(
    fields: readonly (FieldName | CombinedName | NamedField)[],
    format: FieldFormat,
  ): Promise<Uint8Array> {
    return this.#ask(async ({ mesh, fields: known, signal }) => {
      const { unit } = this;
      const whole = await Promise.all(
        fields.map(async (field) => {
          if (typeof field !== 'string') return field;
          if (isFieldName(field)) return this.fieldOf(field);
          return known.combinedToWrite(field, unit);
        }),
      );
      return mesh.exportFields(whole, format, { signal, unit });
    });
  }

  /**
   * A result of this surface as a file's content, as it was found: see `Mesh.write`.
   * @experimental
   */
  write<Found extends object>(
    found: Found,
    format: FormatOf<Found>,
    options: Omit<WriteOptions, 'unit'> = {},
  ): Promise<Uint8Array> {
    return this.#ask(({ mesh, signal }) =>
      mesh.write(found, format, { signal, unit: this.unit, ...options }),
    );
  }

  /** The tips as a file's content. */
  exportTips(format: 'json' | 'obj'): Promise<Uint8Array> {
    return this.#ask(async ({ model }) => this.write(await model.tips(), format));
  }

  /** The limbs as a file's content: everything, or a row for each. */
  exportLimbs(format: 'json' | 'csv'): Promise<Uint8Array> {
    return this.#ask(async ({ model }) => this.write(await model.limbs(), format));
  }

  /** The parts as a file's content. */
  exportParts(options: PartOptions, format: 'json'): Promise<Uint8Array> {
    return this.#ask(async ({ model }) => this.write(await model.parts(options), format));
  }

  /** The answer of the print check as a file's content. */
  exportWeakPlaces(limits: PrintLimits, format: 'json'): Promise<Uint8Array> {
    return this.#ask(async ({ model }) => this.write(await model.printCheck(limits), format));
  }

  /**
   * The parts of the surface, cut along curves, as files: one, or with 'stl' and 'ply' one for each part.
   * @experimental
   */
  exportCut(
    curves: readonly (readonly SurfacePoint[])[],
    format: CutFormat,
    options: CutOptions = {},
  ): Promise<Uint8Array[]> {
    return this.#ask(({ mesh, signal }) =>
      mesh.exportCut(curves, format, { signal, unit: this.unit, ...options }),
    );
  }

  /**
   * The segments as a file's content: a label for each face, everything, or a node for each segment.
   * @experimental
   */
  exportSegments(
    format: 'csv' | 'json' | 'glb',
    options: SegmentOptions = {},
  ): Promise<Uint8Array> {
    return this.#ask(async () => this.write(await this.segments(options), format));
  }

  /**
   * The girth along the shortest path through points, or what was measured along a path or an axis, as a file's content: a
   * row for each place, or everything; the loops of an axis also as lines.
   * @experimental
   */
  exportProfile<Along extends readonly SurfacePoint[] | Profile | LimbAxis>(
    along: Along,
    format: 'csv' | 'json' | (Along extends LimbAxis ? 'obj' | 'glb' : never),
    options: ProfileOptions = {},
  ): Promise<Uint8Array> {
    return this.#ask(({ mesh, signal }) =>
      mesh.exportProfile(along as LimbAxis, format, { signal, unit: this.unit, ...options }),
    );
  }

  /** The pinned loops, oldest first, a file's content for each. */
  exportLoops(format: LoopFormat): Promise<Uint8Array[]> {
    return this.#ask(({ mesh, fields, loops, signal }) => {
      const points = loops.pinned.map(({ loop }) => loop.base);
      const { persistence } = fields;
      return mesh.exportLoops(points, format, { signal, unit: this.unit, persistence });
    });
  }
}
