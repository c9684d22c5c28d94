// A kernel and its workers. Nothing is computed on the page's own thread.

import { linked, untilAborted } from './abort.js';
import { BarcodeRun } from './barcodes.js';
import { checkCalls, wrongOption } from './checked-options.js';
import { compareShapes } from './compare.js';
import { disposal } from '../types/disposal.js';
import { cancelled, failure, fieldsOf, GirthError } from '../types/errors.js';
import { barcodeRequest, hasKinds } from '../types/field-request.js';
import { FieldRun, summaryOf, type FieldEngine } from './field-run.js';
import { JobPool, type JobNeeds } from './job-pool.js';
import { LoopQueue, type PointArguments, type PointOperation } from './loop-queue.js';
import { MeshOfWorkers, progressOf } from './mesh.js';
import type { MeshHost } from './mesh-host.js';
import { page, type Platform } from './platform.js';
import { PoolEngine } from './pool-engine.js';
import { callOptionNames, kernelOptionNames } from '../types/option-names.js';
import type { JobOperations } from '../types/operations/job.js';
import type { StudiesOperations } from '../types/operations/studies.js';
import type {
  CommonOperations,
  FieldRequest,
  FoundRefined,
  RefinedRequest,
  Report,
  SingleOperations,
  SurfaceArrays,
  ThreadsOperations,
} from '../types/protocol.js';
import { contentOf, sizeOf, type ContentAt } from './source.js';
import type { SurfaceSource } from './surface-source.js';
import { ThreadsEngine } from './threads-engine.js';
import { Turns } from './turns.js';
import type {
  CallOptions,
  CompareOptions,
  Comparison,
  Field,
  FieldOptions,
  Kernel,
  KernelOptions,
  LoadOptions,
  Mesh,
  MeshSource,
  WatchedOptions,
} from '../types/types.js';
import { WorkerClient } from './worker-client.js';
import { moduleWorkers, workersIn, type WorkerFactory } from './workers.js';

/** More workers would cost more memory than they save time. */
const mostThreads = 8;

/**
 * Starts the workers, and waits until one of them can read models. Rejected with a GirthError of code
 * PROGRAM_NOT_LOADED where there are no workers or no WebAssembly or a part of the package cannot be fetched (its
 * hint says what to allow), OUT_OF_MEMORY where the memory does not suffice, USAGE where `base` is no address.
 */
export async function createKernel(options: KernelOptions = {}): Promise<Kernel> {
  const { base } = options;
  return openKernel(options, base === undefined ? moduleWorkers : workersIn(base));
}

/** `createKernel` with workers of the caller's choice, on a page or elsewhere. */
export async function openKernel(
  options: KernelOptions,
  factory: WorkerFactory,
  platform: Platform = page,
): Promise<KernelOfWorkers> {
  const wrong = wrongOption(options, kernelOptionNames);
  if (wrong) throw wrong;
  const threads = threadsOf(options.threads, platform.cores);
  const models = new JobPool<JobOperations>(() => factory.job());
  // One job at a time, since the next one may need the same spectrum. Any surface's spectrum is heavy, and takes longer to
  // compute than its memory is worth.
  const spectral = new JobPool<StudiesOperations>(() => factory.studies(), {
    mostJobs: 1,
    heavy: 0,
    rest: Infinity,
  });
  const comparing = new JobPool<StudiesOperations>(() => factory.studies());
  const pools = { models, spectral, comparing };
  const single = () => new WorkerClient<SingleOperations>(() => factory.single());
  const interactive = single();
  const { contentAt, sharesMemory } = platform;
  if (options.mode === 'threads' && !sharesMemory) {
    warnOnce(
      'Girth: this page is not cross-origin isolated; a pool of workers is used instead of threads.',
    );
  }

  let host: WorkerClient<ThreadsOperations> | undefined;
  if (sharesMemory && options.mode !== 'pool') {
    host = new WorkerClient<ThreadsOperations>(() => factory.threads(), threads);
  }
  try {
    const [, hostFailure] = await Promise.all([
      models.start(),
      host?.start().then(
        () => undefined,
        (thrown: unknown) => fieldsOf(thrown),
      ),
    ]);
    if (host && !hostFailure) {
      const engine = new ThreadsEngine(host, threads);
      void interactive.start().catch(() => undefined);
      const workers = [host];
      return new KernelOfWorkers(
        'threads',
        threads,
        pools,
        interactive,
        workers,
        engine,
        contentAt,
        single,
      );
    }
    if (hostFailure) {
      warnOnce(
        `Girth: threads are not available (${hostFailure.message}); a pool of workers is used.`,
      );
    }
  } catch (thrown) {
    const error = new GirthError(fieldsOf(thrown), { cause: thrown });
    host?.terminate(error);
    models.terminate(error);
    throw error;
  }

  const pool = Array.from({ length: threads }, single);
  // They load while the page fetches its model. A failure is reported when they are needed.
  for (const worker of [interactive, ...pool]) void worker.start().catch(() => undefined);
  const engine = new PoolEngine(pool);
  return new KernelOfWorkers('pool', threads, pools, interactive, pool, engine, contentAt, single);
}

function threadsOf(wanted: number | 'auto' = 'auto', cores: number): number {
  const many = wanted === 'auto' ? cores : wanted;
  const whole = Number.isFinite(many) ? Math.floor(many) : 1;
  return Math.max(1, wanted === 'auto' ? Math.min(whole, mostThreads) : Math.min(whole, 64));
}

const warned = new Set<string>();
function warnOnce(text: string): void {
  if (warned.has(text)) return;
  warned.add(text);
  console.warn(text);
}

/** Workers for jobs: on models and surfaces, on spectra, and on comparisons. */
interface JobPools {
  models: JobPool<JobOperations>;
  spectral: JobPool<StudiesOperations>;
  comparing: JobPool<StudiesOperations>;
}

type AnyWorker = Pick<WorkerClient<SingleOperations>, 'drop' | 'terminate'>;

/** The last number of a surface, among all kernels of the page: a mesh of one can be compared with those of another. */
let lastSurface = 0;

export class KernelOfWorkers implements Kernel, MeshHost {
  readonly mode: 'threads' | 'pool';
  readonly threads: number;
  readonly #pools: JobPools;
  readonly #interactive: WorkerClient<SingleOperations>;
  readonly #workers: readonly AnyWorker[];
  readonly #engine: FieldEngine;
  readonly #loops: LoopQueue;
  readonly #contentAt: ContentAt;
  readonly #life = new AbortController();
  readonly #turns = new Turns();
  /** Makes a worker for urgent fields while all others do what cannot pause. */
  readonly #aside: () => WorkerClient<SingleOperations>;

  static {
    checkCalls(this.prototype, callOptionNames.Kernel);
  }

  constructor(
    mode: 'threads' | 'pool',
    threads: number,
    pools: JobPools,
    interactive: WorkerClient<SingleOperations>,
    computing: readonly AnyWorker[],
    engine: FieldEngine,
    contentAt: ContentAt,
    aside: () => WorkerClient<SingleOperations>,
  ) {
    this.#aside = aside;
    this.mode = mode;
    this.threads = threads;
    this.#pools = pools;
    this.#interactive = interactive;
    this.#workers = [interactive, ...computing];
    this.#engine = engine;
    this.#loops = new LoopQueue(interactive);
    this.#contentAt = contentAt;
  }

  async load(source: MeshSource, options: LoadOptions = {}): Promise<Mesh> {
    const { model, prepare = {}, onProgress } = options;
    const opened = await this.#work([options.signal], async (signal) => {
      const content = await contentOf(source, signal, this.#contentAt);
      return this.#pools.models.run(signal, { passing: sizeOf(content) }, (worker) => {
        const onReport = (report: Report) => {
          if (!signal.aborted && 'progress' in report) onProgress?.(report.progress);
        };
        if ('arrays' in content) {
          const { positions, indices } = content.arrays;
          const transfer = [positions.buffer, indices.buffer];
          return worker.request('take', { ...content, prepare }, { transfer, onReport });
        }
        const chosen = model === undefined ? {} : { model };
        return worker.request('read', { ...content, ...chosen, prepare }, { onReport });
      });
    });
    return new MeshOfWorkers(this, opened);
  }

  introduce(arrays: SurfaceArrays, life: AbortSignal): SurfaceSource {
    const surface = { number: ++lastSurface, arrays, life };
    // The first loop need not wait for it then. A failure is reported to those who ask for a loop.
    void this.#interactive.adopt(surface).catch(() => undefined);
    return surface;
  }

  field(
    surface: SurfaceSource,
    request: FieldRequest,
    options: FieldOptions,
  ): Promise<Omit<Field, 'unit'>> {
    const run = new FieldRun(surface.arrays.positions.length / 3, hasKinds(request), options);
    return this.#work([options.signal, surface.life], async (signal) => {
      await this.#compute(surface, request, run, signal, options);
      const { values, kinds } = run;
      const { range, withoutValue } = summaryOf(values);
      const about = await this.#interactive.requestOn(surface, 'about', {
        field: request,
        withoutValue,
      });
      const { name } = request;
      const persistence = Number(request.persistence ?? 0);
      if (name === 'barcode') throw failure('USAGE', 'barcodes are no field');
      const found = { name, values, kinds, range, withoutValue, ...about };
      return persistence === 0 ? found : { ...found, persistence };
    });
  }

  barcodes(
    surface: SurfaceSource,
    maxPersistence: number,
    options: WatchedOptions,
  ): Promise<BarcodeRun> {
    const run = new BarcodeRun(surface.arrays.positions.length / 3, options);
    return this.#work([options.signal, surface.life], async (signal) => {
      await this.#compute(surface, barcodeRequest(maxPersistence), run, signal, options);
      return run;
    });
  }

  /** Computes a field in its turn. `asked`: the signal of who has asked for it. */
  async #compute(
    surface: SurfaceSource,
    request: FieldRequest,
    run: FieldRun,
    signal: AbortSignal,
    { signal: asked, urgent = false }: FieldOptions,
  ): Promise<void> {
    // An aborted caller keeps what is finished; a disposed mesh does not.
    signal.addEventListener('abort', () => {
      if (asked?.aborted && !surface.life.aborted) run.flush();
    });
    if (urgent && this.#turns.isHeld) return this.#computeAside(surface, request, run, signal);
    for (let again = false; !run.complete; again = true) {
      const turn = await this.#turns.take({ isUrgent: urgent, canPause: true }, again);
      const either = linked([signal, turn.pause]);
      try {
        if (signal.aborted) throw cancelled();
        await this.#engine.compute(surface, request, run, either.signal);
      } catch (thrown) {
        // A worker that took too long to pause has been ended: its part is computed again.
        if (signal.aborted || !turn.pause.aborted) throw thrown;
      } finally {
        either.release();
        turn.end();
      }
      if (signal.aborted) throw cancelled();
      run.flush();
    }
  }

  /** Computes a field with a worker of its own, beside what cannot pause. */
  async #computeAside(
    surface: SurfaceSource,
    request: FieldRequest,
    run: FieldRun,
    signal: AbortSignal,
  ): Promise<void> {
    const worker = this.#aside();
    const end = () => worker.terminate(cancelled());
    signal.addEventListener('abort', end);
    try {
      await new PoolEngine([worker]).compute(surface, request, run, signal);
    } finally {
      signal.removeEventListener('abort', end);
      end();
    }
    if (signal.aborted) throw cancelled();
  }

  refined(
    surface: SurfaceSource,
    request: RefinedRequest,
    { signal: asked, onProgress }: WatchedOptions,
    alone: (signal: AbortSignal) => Promise<FoundRefined>,
  ): Promise<FoundRefined> {
    const engine = this.#engine;
    return this.#work([asked, surface.life], async (signal) => {
      if (!engine.refined) return alone(signal);
      const onReport = progressOf(signal, onProgress);
      const turn = await this.#turns.take({ isUrgent: false, canPause: false });
      try {
        if (signal.aborted) throw cancelled();
        return await engine.refined(surface, request, onReport, signal);
      } finally {
        turn.end();
      }
    });
  }

  job<R>(
    needs: JobNeeds,
    signal: AbortSignal | undefined,
    job: (worker: WorkerClient<JobOperations>) => Promise<R>,
  ): Promise<R> {
    return this.#run(this.#pools.models, needs, signal, job);
  }

  spectralJob<R>(
    needs: JobNeeds,
    signal: AbortSignal | undefined,
    job: (worker: WorkerClient<StudiesOperations>) => Promise<R>,
  ): Promise<R> {
    return this.#run(this.#pools.spectral, needs, signal, job);
  }

  async compare(meshes: readonly Mesh[], options: CompareOptions): Promise<Comparison> {
    const surfaces = meshes.map((mesh) => {
      if (mesh instanceof MeshOfWorkers) return mesh.surface;
      throw failure('USAGE', 'one of the meshes is not of this package', {
        hint: 'load it with a kernel',
      });
    });
    const lives = surfaces.map(({ life }) => life);
    return this.#work([options.signal, ...lives], (signal) =>
      compareShapes(this.#pools.comparing, surfaces, options, signal),
    );
  }

  atPoint<K extends PointOperation>(
    surface: SurfaceSource,
    operation: K,
    args: PointArguments<K>,
    options: CallOptions,
  ) {
    return this.#work([options.signal, surface.life], (signal) =>
      this.#loops.answer(surface, operation, args, signal),
    );
  }

  drop(surface: number): void {
    for (const worker of this.#workers) worker.drop(surface);
  }

  dispose(): void {
    const reason = 'the kernel has been disposed of';
    this.#life.abort(reason);
    const { models, spectral, comparing } = this.#pools;
    for (const one of [models, spectral, comparing, ...this.#workers]) {
      one.terminate(cancelled(reason));
    }
  }

  [disposal](): void {
    this.dispose();
  }

  #run<T extends CommonOperations, R>(
    pool: JobPool<T>,
    needs: JobNeeds,
    signal: AbortSignal | undefined,
    job: (worker: WorkerClient<T>) => Promise<R>,
  ): Promise<R> {
    const lives = (needs.surfaces ?? []).map(({ life }) => life);
    return this.#work([signal, ...lives], (whole) => pool.run(whole, needs, job));
  }

  /** Runs work that ends with CANCELLED when a signal fires or the kernel is disposed of. */
  async #work<T>(
    signals: (AbortSignal | undefined)[],
    work: (signal: AbortSignal) => Promise<T>,
  ): Promise<T> {
    const { signal, release } = linked([...signals, this.#life.signal]);
    try {
      return await untilAborted(
        signal.aborted ? new Promise<T>(() => undefined) : work(signal),
        signal,
      );
    } catch (thrown) {
      throw thrown instanceof GirthError
        ? thrown
        : new GirthError(fieldsOf(thrown), { cause: thrown });
    } finally {
      release();
    }
  }
}
