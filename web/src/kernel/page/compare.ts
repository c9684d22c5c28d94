// Comparing shapes by descriptors: first the fields of each shape, two shapes at a time, then the distances.

import { fieldsOf, GirthError } from '../types/errors.js';
import type { JobPool } from './job-pool.js';
import type { StudiesOperations } from '../types/operations/studies.js';
import type { Report, StudyFields } from '../types/protocol.js';
import type { SurfaceSource } from './surface-source.js';
import type { CompareOptions, Comparison } from '../types/types.js';

/** Groups of fields that have been computed, by how the surface was prepared and their name. */
const known = new WeakMap<SurfaceSource, Map<string, StudyFields>>();

/** The share of the work that the fields are. */
const fieldsShare = 0.95;

export async function compareShapes(
  pool: JobPool<StudiesOperations>,
  surfaces: readonly SurfaceSource[],
  { descriptors, faces = 10_000, smooth = 0, onProgress }: CompareOptions,
  signal: AbortSignal,
): Promise<Comparison> {
  const { groups } = await pool.run(signal, {}, (worker) =>
    worker.request('fieldGroups', { descriptors }),
  );
  const shares = surfaces.map(() => 0);
  let reported = 0;
  const report = (progress: number) => {
    if (signal.aborted || progress <= reported) return;
    reported = progress;
    onProgress?.(progress);
  };
  const fieldsOfSurface = async (surface: SurfaceSource, place: number): Promise<StudyFields[]> => {
    const found: StudyFields[] = [];
    for (const group of groups) {
      found.push(
        await studyFields(pool, surface, { group, faces, smooth }, signal, (share) => {
          shares[place] = (found.length + share) / groups.length;
          report((fieldsShare * shares.reduce((sum, one) => sum + one, 0)) / surfaces.length);
        }),
      );
    }
    return found;
  };
  const outcomes = await Promise.allSettled(surfaces.map(fieldsOfSurface));

  const failed: Comparison['failed'] = [];
  const places: number[] = [];
  const models: StudyFields[][] = [];
  outcomes.forEach((outcome, shape) => {
    if (outcome.status === 'rejected') {
      failed.push({ shape, error: fieldsOf(outcome.reason) });
      return;
    }
    places.push(shape);
    models.push(outcome.value);
  });
  if (models.length === 0 && failed.length > 0) throw new GirthError(failed[0]!.error);
  const passing = models.flat().reduce((sum, { fields }) => sum + bytesOf(fields), 0);
  const { matrices } = await pool.run(signal, { passing }, (worker) =>
    worker.request('compare', { models, descriptors }),
  );
  report(1);
  return {
    matrices: descriptors.map((descriptor, d) => ({
      descriptor,
      distances: spread(matrices[d]!, places, surfaces.length),
    })),
    failed,
  };
}

async function studyFields(
  pool: JobPool<StudiesOperations>,
  surface: SurfaceSource,
  wanted: { group: string; faces: number; smooth: number },
  signal: AbortSignal,
  onProgress: (share: number) => void,
): Promise<StudyFields> {
  let ofSurface = known.get(surface);
  if (!ofSurface) known.set(surface, (ofSurface = new Map<string, StudyFields>()));
  const key = `${wanted.faces} ${wanted.smooth} ${wanted.group}`;
  let fields = ofSurface.get(key);
  if (!fields) {
    const onReport = (report: Report) => 'progress' in report && onProgress(report.progress);
    fields = await pool.run(signal, { surfaces: [surface] }, (worker) =>
      worker.requestOn(surface, 'studyFields', wanted, { onReport }),
    );
    ofSurface.set(key, fields);
  }
  onProgress(1);
  return fields;
}

const bytesOf = (fields: StudyFields['fields']) =>
  fields.reduce((sum, { values }) => sum + values.byteLength, 0);

/** A matrix of some shapes as a matrix of all, NaN for the others. */
function spread(matrix: Float64Array, places: readonly number[], count: number): Float64Array {
  const whole = new Float64Array(count * count).fill(NaN);
  places.forEach((i, row) => {
    places.forEach((k, column) => {
      whole[i * count + k] = matrix[row * places.length + column]!;
    });
  });
  return whole;
}
