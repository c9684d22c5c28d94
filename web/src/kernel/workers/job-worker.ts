// A worker for jobs: it reads models, and keeps surfaces to analyse, remesh and write them. The module for the latter
// is loaded with the first of them.

import createAnalysis, { type AnalysisModule, type JobSurface } from '../wasm/girth-analysis.mjs';
import createFiles, { type Described, type FilesModule } from '../wasm/girth-files.mjs';
import { failure, fieldsOf, GirthError } from '../types/errors.js';
import { FileSet, type SetFile } from '../unpack/file-set.js';
import { loadedModule } from './loading-failure.js';
import { forwards } from './forwards.js';
import { moduleOptions, openedSurface, remeshedSurface } from './opened-surface.js';
import { analysing, makingSurfaces } from '../types/operations/analysis.js';
import type { JobOperations } from '../types/operations/job.js';
import { serving } from '../types/operations/serving.js';
import type { OpenedSurface } from '../types/protocol.js';
import { SurfaceStore } from './surface-store.js';
import type { FileWithPath, MeshInfo, UnreadableModel } from '../types/types.js';
import { unpackIfCompressed } from '../unpack/unpack.js';
import { workerFiles } from './worker-files.js';
import { checked, progressTo, serveRequests } from './worker-loop.js';

let files: FilesModule;
/** There as soon as there is a surface. */
let analysis: AnalysisModule;
const surfaces = new SurfaceStore<JobSurface>();

/** A file must fit into one array, and that into the module's memory. */
const mostBytes = 2 ** 31 - 1;

function asSetFile({ path, content }: FileWithPath): SetFile {
  const bytes = () => {
    if (content.size > mostBytes) {
      throw failure('LIMIT_EXCEEDED', `${path} has ${(content.size / 1e9).toFixed(1)} GB`, {
        hint: 'use a smaller model: files of 2 GB and more do not fit into the memory of a WebAssembly module; the command reads them',
      });
    }
    try {
      return workerFiles.bytesOf(content);
    } catch (cause) {
      throw failure('FILE_UNREADABLE', `${path} cannot be read`, { cause });
    }
  };
  return { path, size: content.size, bytes };
}

/** The first of several models that can be read, with those before it and their errors. */
async function firstReadable(
  models: readonly string[],
  read: (path: string, unreadable: UnreadableModel[]) => Promise<OpenedSurface>,
): Promise<OpenedSurface> {
  const unreadable: UnreadableModel[] = [];
  for (const path of models) {
    try {
      return await read(path, unreadable);
    } catch (thrown) {
      const error = fieldsOf(thrown);
      // These failures concern the worker, not the model.
      if (/^(OUT_OF_MEMORY|PROGRAM_NOT_LOADED|INTERNAL)$/.test(error.code)) throw thrown;
      unreadable.push({ model: path, error });
    }
  }
  const [{ model, error }] = unreadable as [UnreadableModel];
  const message = `none of the ${models.length} models can be used; ${model}: ${error.message}`;
  throw new GirthError({ ...error, message });
}

/** A surface that was made of another one, whose `info` is given, as the page receives it. */
function opened<M extends { described: Described }>({ described, ...rest }: M, info: MeshInfo) {
  return { opened: remeshedSurface(described, info), ...rest };
}

const functions = () => analysis;
const makers = forwards(makingSurfaces, functions, surfaces);

serveRequests<JobOperations>(surfaces, {
  async start() {
    files = await loadedModule(() => createFiles(), import.meta.url);
    return {};
  },

  async read({ files: given, address, model, prepare }, report) {
    const set = new FileSet(given.map(asSetFile));
    let reported = 0;
    // Progress must not fall where one model follows another that cannot be read.
    const neverFalling = (progress: number) => {
      if (progress > reported) report({ progress: (reported = progress) });
    };
    const read = async (path: string, unreadable: UnreadableModel[]): Promise<OpenedSurface> => {
      const chosen = set.model(path);
      const name = chosen.path.slice(chosen.path.lastIndexOf('/') + 1);
      const resource = (name: string) =>
        set.resource(chosen.path, name)?.bytes() ??
        (address === undefined ? undefined : workerFiles.beside(address, name));
      const unpacked = await unpackIfCompressed(chosen.bytes(), resource);
      const prepared = checked(
        files.readSurface(
          unpacked.bytes,
          name,
          unpacked.resource,
          moduleOptions(prepare),
          neverFalling,
        ),
      );
      return openedSurface(prepared, { name, models: set.models, unreadable });
    };
    if (model !== undefined || set.models.length === 1) return read(model ?? set.models[0]!, []);
    return firstReadable(set.models, read);
  },

  take({ arrays, prepare }, report) {
    const { positions, indices } = arrays;
    const prepared = checked(
      files.surfaceFromArrays(positions, indices, moduleOptions(prepare), progressTo(report)),
    );
    return openedSurface(prepared, { name: '', models: [], unreadable: [] });
  },

  async adopt({ surface, arrays }) {
    analysis ??= await loadedModule(() => createAnalysis(), import.meta.url);
    const { positions, indices, vertexOfInput, inputOfVertex } = arrays;
    const made = analysis.jobSurface(positions, indices, vertexOfInput, inputOfVertex);
    surfaces.add(surface, checked(made).surface);
    return {};
  },

  ...forwards({ ...analysing, ...serving }, functions, surfaces),
  remesh: ({ info, ...args }, report) => opened(makers.remesh(args, report), info),
  smooth: ({ info, ...args }, report) => opened(makers.smooth(args, report), info),
  removeHandles: ({ info, ...args }, report) => opened(makers.removeHandles(args, report), info),
});
