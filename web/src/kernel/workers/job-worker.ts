// A worker for jobs: it reads models, and keeps surfaces to analyse, remesh and write them. What the latter takes is
// loaded with the first of them.

import createAnalysis, { type AnalysisModule, type JobSurface } from '../wasm/girth-analysis.mjs';
import createFiles, { type FilesModule } from '../wasm/girth-files.mjs';
import { failure, fieldsOf, GirthError } from '../types/errors.js';
import { FileSet, type SetFile } from '../unpack/file-set.js';
import { loadedModule } from './loading-failure.js';
import { moduleOptions, openedSurface, remeshedSurface } from './opened-surface.js';
import type { OpenedSurface, JobOperations } from '../types/protocol.js';
import { SurfaceStore } from './surface-store.js';
import type { FileWithPath, UnreadableModel } from '../types/types.js';
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

serveRequests<JobOperations>({
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

  remesh({ surface, faces, even, info }, report) {
    const made = checked(analysis.remesh(surfaces.get(surface), faces, even, progressTo(report)));
    return remeshedSurface(made, info);
  },

  smooth({ surface, steps, info }, report) {
    const made = checked(analysis.smooth(surfaces.get(surface), steps, progressTo(report)));
    return remeshedSurface(made, info);
  },

  carryBack({ surface, remeshed, values, kinds }) {
    return checked(
      analysis.carryBack(surfaces.get(surface), surfaces.get(remeshed), values, kinds),
    );
  },

  refinedGirth({ surface, request }, report) {
    return checked(analysis.refinedGirth(surfaces.get(surface), request, progressTo(report)));
  },

  difference({ surface, values, other, otherValues }) {
    return checked(
      analysis.difference(surfaces.get(surface), values, surfaces.get(other), otherValues),
    );
  },

  path({ surface, from, to }) {
    return checked(analysis.path(surfaces.get(surface), from, to));
  },

  vertexAreas({ surface }) {
    return checked(analysis.vertexAreas(surfaces.get(surface)));
  },

  tips({ surface, girth }) {
    return checked(analysis.tips(surfaces.get(surface), girth));
  },

  limbs({ surface, girth, stations }, report) {
    return checked(analysis.limbs(surfaces.get(surface), girth, stations, progressTo(report)));
  },

  necks({ surface, girth, minProminence }, report) {
    return checked(analysis.necks(surfaces.get(surface), girth, minProminence, progressTo(report)));
  },

  bottleneck({ surface, girth, from, to }, report) {
    const progress = progressTo(report);
    return checked(analysis.bottleneck(surfaces.get(surface), girth, from, to, progress));
  },

  profile({ surface, points, samples, crossings }, report) {
    const progress = progressTo(report);
    return checked(analysis.profile(surfaces.get(surface), points, samples, crossings, progress));
  },

  axis({ surface, profile }, report) {
    return checked(analysis.axis(surfaces.get(surface), profile, progressTo(report)));
  },

  handles({ surface, basePoints }, report) {
    return checked(analysis.handles(surfaces.get(surface), basePoints, progressTo(report)));
  },

  removeHandles({ surface, length, basePoints, info }, report) {
    const from = surfaces.get(surface);
    const { described, removal } = checked(
      analysis.removeHandles(from, length, basePoints, progressTo(report)),
    );
    return { opened: remeshedSurface(described, info), removal };
  },

  levelCurves({ surface, values, level }) {
    return checked(analysis.levelCurves(surfaces.get(surface), values, level));
  },

  cut({ surface, curves, cap }) {
    return checked(analysis.cut(surfaces.get(surface), curves, cap));
  },

  writeProfile({ surface, model, points, samples, crossings, format }, report) {
    const progress = progressTo(report);
    const from = surfaces.get(surface);
    return checked(
      analysis.writeProfile(from, model, points, samples, crossings, format, progress),
    );
  },

  writeStations({ surface, model, stations, format }) {
    return checked(analysis.writeStations(surfaces.get(surface), model, stations, format));
  },

  writeAxis({ surface, model, loops, format }) {
    return checked(analysis.writeAxis(surfaces.get(surface), model, loops, format));
  },

  writeCut({ surface, model, content, curves, cap, format }) {
    return checked(analysis.writeCut(surfaces.get(surface), model, content, curves, cap, format));
  },

  segments({ surface, fields, options }, report) {
    return checked(analysis.segments(surfaces.get(surface), fields, options, progressTo(report)));
  },

  writeSegments({ surface, model, content, fields, options, format }, report) {
    const progress = progressTo(report);
    const from = surfaces.get(surface);
    return checked(analysis.writeSegments(from, model, content, fields, options, format, progress));
  },

  thresholds({ surface, fields }) {
    return checked(analysis.suggestedThresholds(surfaces.get(surface), fields));
  },

  parts({ surface, fields, options }) {
    return checked(analysis.parts(surfaces.get(surface), fields, options));
  },

  maxima({ surface, values, minima }) {
    return checked(analysis.maxima(surfaces.get(surface), values, minima));
  },

  printCheck({ surface, fields, limits }, report) {
    return checked(analysis.printCheck(surfaces.get(surface), fields, limits, progressTo(report)));
  },

  writeFields({ surface, model, fields, format }) {
    return checked(analysis.writeFields(surfaces.get(surface), model, fields, format));
  },

  writeTips({ surface, model, girth, format }) {
    return checked(analysis.writeTips(surfaces.get(surface), model, girth, format));
  },

  writeLimbs({ surface, model, girth, stations, format }, report) {
    const progress = progressTo(report);
    const from = surfaces.get(surface);
    return checked(analysis.writeLimbs(from, model, girth, stations, format, progress));
  },

  writeParts({ surface, model, fields, options, format }) {
    return checked(analysis.writeParts(surfaces.get(surface), model, fields, options, format));
  },

  writeWeakPlaces({ surface, model, fields, limits, format }, report) {
    const progress = progressTo(report);
    const from = surfaces.get(surface);
    return checked(analysis.writeWeakPlaces(from, model, fields, limits, format, progress));
  },

  writeLoops({ surface, model, points, format }) {
    return checked(analysis.writeLoops(surfaces.get(surface), model, points, format));
  },

  drop({ surface }) {
    surfaces.drop(surface);
    return {};
  },
});
