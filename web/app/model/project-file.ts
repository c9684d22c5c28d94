// A project as one file, `NAME.girth.zip`: the model's files, what the page showed of it, and what was computed. It is a zip:
// `girth-project.json` describes it, `model/` has the files as they were opened, `results/` the fields as arrays of
// numbers of 64 bits (little-endian), one for each vertex of the surface. Whatever opens zips with a model in them opens it, too.

import {
  type Field,
  type FieldName,
  type FileWithPath,
  type GirthAudit,
  GirthError,
  type Loop,
  type LoopKind,
  type MeshGeometry,
  type RefinedGirth,
  type ZipFile,
  readZip,
  unitName,
} from '../../src/kernel/index.js';
import { isFieldName, readPoint, writePoint } from '../../src/element/index.js';
import { type PageState, readState, writeState } from '../state/address-state.js';

const manifestName = 'girth-project.json';
const format = 'girth-project';
const version = 1;
/** Bytes of the manifest, at most. */
const mostOfManifest = 64_000_000;

/** The content of a project. */
export interface Project {
  /** The model's name, as links have it. */
  name: string;
  /** The model's files as they were opened; several have paths. */
  files: readonly FileWithPath[];
  /** Which of several models in them. */
  model: string | undefined;
  /** The state that was shown, with how the model was prepared. */
  state: PageState;
}

/** The results that were computed of a surface. */
export interface Results {
  fields: readonly Field[];
  loops: readonly Loop[];
}

/** A project that was read: its results are those of the surface that it was saved with, and of no other. */
export interface SavedProject extends Project {
  /** The results, if a surface is the one that they are of. Errors: MALFORMED_FILE, LIMIT_EXCEEDED. */
  resultsFor(geometry: MeshGeometry): Results | undefined;
}

/** Identifies a surface by its numbers: FNV-1a of their words. */
export function surfaceKey({ positions, indices }: MeshGeometry): string {
  let hash = 0x811c9dc5;
  for (const numbers of [positions, indices]) {
    const words = new Uint32Array(numbers.buffer, numbers.byteOffset, numbers.length);
    for (const word of words) hash = Math.imul(hash ^ word, 0x01000193) >>> 0;
  }
  return `${positions.length / 3} ${indices.length / 3} ${hash.toString(16)}`;
}

/** The bytes of a project. `geometry` is the surface that the results are of. */
export async function writeProject(
  { name, files, model, state }: Project,
  geometry: MeshGeometry,
  { fields, loops }: Results,
): Promise<Uint8Array> {
  const { zipSync } = await import('fflate');
  const { file: _file, model: _model, values: _values, ...shown } = state;
  void [_file, _model, _values];
  const manifest = {
    format,
    version,
    name,
    ...(model === undefined ? {} : { model }),
    state: writeState(shown),
    surface: surfaceKey(geometry),
    fields: fields.map((field) => {
      const { name, unit, method, note, persistence } = field;
      return {
        ...{ name, unit, method, note },
        ...(persistence ? { persistence } : {}),
        ...(isRefined(field) ? refinementAbout(field) : {}),
      };
    }),
    loops: loops.map(({ length, kind, base, polyline, midpoint, angle, unit }) => ({
      ...{ length, kind, midpoint, angle, unit },
      base: writePoint(base),
      polyline: [...polyline],
    })),
  };
  const entries: Record<string, Uint8Array> = {
    [manifestName]: new TextEncoder().encode(JSON.stringify(manifest)),
  };
  for (const { path, content } of files) {
    entries[`model/${path}`] = new Uint8Array(await content.arrayBuffer());
  }
  for (const field of fields) {
    const { name, values, kinds } = field;
    entries[valuesPath(name)] = littleEndian(values);
    if (kinds.length > 0) entries[kindsPath(name)] = kinds;
    if (isRefined(field)) entries[statesPath] = field.states;
  }
  return zipSync(entries);
}

const valuesPath = (name: FieldName): string => `results/${name}.f64`;
const kindsPath = (name: FieldName): string => `results/${name}-kinds.u8`;
const statesPath = 'results/igf-states.u8';

const isRefined = (field: Field): field is RefinedGirth => 'states' in field;

function littleEndian(values: Float64Array): Uint8Array {
  const view = new DataView(new ArrayBuffer(8 * values.length));
  values.forEach((value, i) => view.setFloat64(8 * i, value, true));
  return new Uint8Array(view.buffer);
}

/** The files of a zip; none where it cannot be read, which is explained to whoever opens it as a model. */
function filesIn(archive: Uint8Array): ZipFile[] {
  try {
    return readZip(archive);
  } catch {
    return [];
  }
}

/**
 * The project in a zip; undefined where it is none. Errors: MALFORMED_FILE, LIMIT_EXCEEDED,
 * UNSUPPORTED_FEATURE for a newer version.
 */
export function readProject(archive: Uint8Array): SavedProject | undefined {
  const all = filesIn(archive);
  const entry = all.find(({ path }) => path === manifestName);
  if (!entry) return undefined;
  if (entry.size > mostOfManifest) throw fault('LIMIT_EXCEEDED', `${manifestName} is too large`);
  const manifest = parsed(entry.bytes());
  if (manifest['version'] !== version) {
    throw fault('UNSUPPORTED_FEATURE', 'it was saved by a newer version', 'reload the page');
  }
  const name = textOf(manifest['name'], 'name');
  const files = all
    .filter(({ path }) => path.startsWith('model/'))
    .map((file) => ({
      path: file.path.slice('model/'.length),
      content: new Blob([file.bytes()]),
    }));
  if (files.length === 0) throw fault('MALFORMED_FILE', 'it has no model in it');
  const surface = textOf(manifest['surface'], 'surface');
  const fields = listOf(manifest['fields'], 'fields');
  const loops = listOf(manifest['loops'], 'loops');
  return {
    name,
    files,
    model: manifest['model'] === undefined ? undefined : textOf(manifest['model'], 'model'),
    state: { ...readState(textOf(manifest['state'], 'state')), file: name },
    resultsFor: (geometry) => {
      if (surfaceKey(geometry) !== surface) return undefined;
      const bytesOf = (path: string, size: number): Uint8Array<ArrayBuffer> => {
        const found = all.find((one) => one.path === path);
        if (found?.size !== size) throw fault('MALFORMED_FILE', `${path} has the wrong size`);
        return found.bytes();
      };
      const count = geometry.positions.length / 3;
      return {
        fields: fields.map((one) => fieldOf(objectOf(one, 'fields'), count, bytesOf)),
        loops: loops.map((one) => loopOf(objectOf(one, 'loops'))),
      };
    },
  };
}

function fieldOf(
  about: Json,
  count: number,
  bytesOf: (path: string, size: number) => Uint8Array<ArrayBuffer>,
): Field {
  const name = textOf(about['name'], 'a field’s name');
  if (!isFieldName(name)) throw fault('MALFORMED_FILE', `there is no field ${name.slice(0, 40)}`);
  const bytes = bytesOf(valuesPath(name), 8 * count);
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const values = Float64Array.from({ length: count }, (_, i) => view.getFloat64(8 * i, true));
  const kinds = name === 'igf' ? bytesOf(kindsPath(name), count) : new Uint8Array(0);
  const isNumber = values.every((value) => Number.isNaN(value) || Number.isFinite(value));
  if (!isNumber || kinds.some((kind) => kind > 2)) {
    throw fault('MALFORMED_FILE', `the values of ${name} are invalid`);
  }
  let [low, high, withoutValue] = [Infinity, -Infinity, 0];
  for (const value of values) {
    if (Number.isNaN(value)) ++withoutValue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  const persistence = numberOf(about['persistence'] ?? 0, 'persistence');
  return {
    ...{ name, values, kinds, withoutValue },
    range: low <= high ? [low, high] : [NaN, NaN],
    unit: unitName(textOf(about['unit'], 'unit')),
    method: textOf(about['method'], 'method'),
    note: textOf(about['note'], 'note'),
    ...(persistence > 0 ? { persistence } : {}),
    ...(about['audit'] === undefined ? {} : refinement(about, bytesOf(statesPath, count))),
  };
}

/** The facts that a project has of a refined girth besides; its states are a file of their own. */
function refinementAbout({ audit, coarseFaces, leanFaces }: RefinedGirth): object {
  return { audit, coarseFaces, leanFaces };
}

/** The parts that a refined girth has besides. */
function refinement(
  about: Json,
  states: Uint8Array,
): Pick<RefinedGirth, 'states' | 'audit' | 'coarseFaces' | 'leanFaces'> {
  if (states.some((state) => state > 2)) throw fault('MALFORMED_FILE', 'a state is invalid');
  const audit = objectOf(about['audit'], 'audit');
  const of = (name: keyof GirthAudit): number => numberOf(audit[name], `the audit’s ${name}`);
  return {
    states,
    audit: {
      ...{ vertices: of('vertices'), equal: of('equal'), median: of('median') },
      ...{ atLeast: of('atLeast'), atMost: of('atMost') },
      ...{ percentile95: of('percentile95'), greatest: of('greatest') },
    },
    coarseFaces: numberOf(about['coarseFaces'], 'coarseFaces'),
    leanFaces: numberOf(about['leanFaces'], 'leanFaces'),
  };
}

const loopKinds: readonly LoopKind[] = ['loop', 'antipodal', 'unresolved'];

function loopOf(about: Json): Loop {
  const base = readPoint(textOf(about['base'], 'base'));
  const kind = loopKinds.find((one) => one === about['kind']);
  const [x, y, z] = listOf(about['midpoint'], 'midpoint').map((one) => numberOf(one, 'midpoint'));
  const polyline = Float32Array.from(listOf(about['polyline'], 'polyline'), (one) =>
    numberOf(one, 'polyline'),
  );
  if (base === undefined || kind === undefined || z === undefined || polyline.length % 3 !== 0) {
    throw fault('MALFORMED_FILE', 'a loop is invalid');
  }
  return {
    ...{ base, kind, polyline, points: [], midpoint: [x!, y!, z] },
    length: numberOf(about['length'], 'length'),
    // JSON has no NaN.
    angle: about['angle'] === null ? NaN : numberOf(about['angle'], 'angle'),
    unit: unitName(textOf(about['unit'], 'unit')),
  };
}

// ---- what nobody has checked

type Json = Record<string, unknown>;

function parsed(bytes: Uint8Array): Json {
  let read: unknown;
  try {
    read = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw fault('MALFORMED_FILE', `${manifestName} is no JSON`);
  }
  const manifest = objectOf(read, manifestName);
  if (manifest['format'] !== format) throw fault('MALFORMED_FILE', `${manifestName} is another`);
  return manifest;
}

function objectOf(value: unknown, what: string): Json {
  const isObject = typeof value === 'object' && value !== null && !Array.isArray(value);
  if (!isObject) throw fault('MALFORMED_FILE', `${what} is no object`);
  return value as Json;
}

function listOf(value: unknown, what: string): unknown[] {
  if (!Array.isArray(value)) throw fault('MALFORMED_FILE', `${what} is no list`);
  return value;
}

function textOf(value: unknown, what: string): string {
  if (typeof value !== 'string') throw fault('MALFORMED_FILE', `${what} is no text`);
  return value;
}

function numberOf(value: unknown, what: string): number {
  const isNumber = typeof value === 'number' && Number.isFinite(value);
  if (!isNumber) throw fault('MALFORMED_FILE', `${what} is no number`);
  return value;
}

function fault(
  code: string,
  words: string,
  hint = 'save the project again, or drop the model alone',
): GirthError {
  return new GirthError({
    code,
    element: -1,
    message: `the project cannot be read: ${words}`,
    hint,
  });
}
