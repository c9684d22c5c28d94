// Files that were given together: which of them are models, and which of them a model refers to.

import { failure } from '../types/errors.js';
import { isZip, readZip, safePath } from './zip.js';

/** A file of the set. Its bytes are read when they are needed. */
export interface SetFile {
  /** Relative to the set, with '/' between folders. */
  path: string;
  size: number;
  bytes(): Uint8Array<ArrayBuffer>;
}

const modelEnding = /\.(glb|gltf|obj|off|ply|stl)$/i;
const zipEnding = /\.zip$/i;
/** Files with these endings accompany models. */
const otherEnding = /\.(bin|bmp|gif|jpe?g|ktx2?|md|mtl|pdf|png|txt|webp|tiff?|tga)$/i;

/** Whether a file begins like a model, whatever its name. */
export function looksLikeModel(head: Uint8Array): boolean {
  const text = String.fromCharCode(...head.subarray(0, 256));
  return (
    /^(glTF|ply\r?\n|solid\s|(ST)?(C)?(N)?4?n?OFF\s)/.test(text) ||
    (/^[\s\ufeffï»¿]*\{/.test(text) && text.includes('"'))
  );
}

/** Orders paths by the number of folders, then by name; numbers in names by their value. */
function compare(a: string, b: string): number {
  const depth = (path: string) => path.split('/').length;
  return depth(a) - depth(b) || a.localeCompare(b, 'en', { numeric: true });
}

export class FileSet {
  readonly #files: SetFile[];
  /** The paths of the models; the first is the one to open. */
  readonly models: string[];

  /** Replaces zips by the files in them, but not zips in zips. */
  constructor(given: readonly SetFile[]) {
    const several = given.length > 1;
    this.#files = given.flatMap((file) => {
      const opens = zipEnding.test(file.path) || (!several && !modelEnding.test(file.path));
      return opens ? expanded(file, several ? `${file.path}/` : '') : [file];
    });
    this.models = modelsAmong(this.#files, given);
  }

  /** The model of that path. */
  model(path: string): SetFile {
    const file = this.models.includes(path) && this.#files.find((one) => one.path === path);
    if (!file) {
      const hint = `choose one of: ${this.models.slice(0, 8).join(', ')}`;
      throw failure('FILE_NOT_FOUND', `there is no model '${path}' among the files`, { hint });
    }
    return file;
  }

  /**
   * The file that a model refers to by a relative name. Upper and lower case may differ. Where the set has
   * no folders, folders in the name are ignored.
   */
  resource(model: string, name: string): SetFile | undefined {
    const inside = safePath(name);
    if (inside === undefined) return undefined;
    const path = model.slice(0, model.lastIndexOf('/') + 1) + inside;
    const like = (wanted: string) => {
      const lower = wanted.toLowerCase();
      return this.#files.find((one) => one.path.toLowerCase() === lower);
    };
    const found = this.#files.find((one) => one.path === path) ?? like(path);
    if (found || this.#files.some((one) => one.path.includes('/'))) return found;
    return like(inside.slice(inside.lastIndexOf('/') + 1));
  }
}

function modelsAmong(files: readonly SetFile[], given: readonly SetFile[]): string[] {
  const paths = (some: readonly SetFile[]) => some.map(({ path }) => path).sort(compare);
  const named = files.filter(({ path }) => modelEnding.test(path));
  if (named.length > 0) return paths(named);
  // The reader decides about a single file.
  if (given.length === 1 && files.length === 1 && files[0] === given[0]) return paths(files);
  const alike = files.filter(
    (file) =>
      file.size > 0 &&
      !otherEnding.test(file.path) &&
      !zipEnding.test(file.path) &&
      looksLikeModel(file.bytes()),
  );
  if (alike.length > 0) return paths(alike);
  // Most likely a model of another format, which the reader names.
  const other = files.filter(({ path }) => !otherEnding.test(path));
  if (other.length > 0) return [other.reduce((a, b) => (b.size > a.size ? b : a)).path];
  const message =
    files.length === 1
      ? `${files[0]!.path} is no model`
      : files.length === 0
        ? `there is no file in ${given[0]!.path}`
        : `none of the ${files.length} files is a model`;
  throw failure('UNKNOWN_FORMAT', message);
}

/** The files in a zip. A file that is no zip stands for itself. */
function expanded(file: SetFile, prefix: string): SetFile[] {
  const archive = file.bytes();
  if (!isZip(archive)) return [file];
  return readZip(archive).map((inner) => ({ ...inner, path: prefix + inner.path }));
}
