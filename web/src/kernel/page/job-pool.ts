// Workers for jobs: reading a model, what is made of a surface, writing a file. Each job has a worker for
// itself while it runs. It can be ended at any moment without harm to anything else.
//
// Workers keep some things between jobs:
// - A worker keeps the surfaces that it was given, until their meshes are disposed of. A job goes to an idle
//   worker that has its surfaces, so that these are copied and built once, not once per job. A worker that
//   replaces one that was ended is given them again.
// - A module's memory never shrinks. `heavy` bounds what is kept without use: beside the surfaces of the
//   present job, a worker holds others of at most that many bytes (least recently used dropped first); a
//   worker that has had more bytes is ended as soon as it holds no surface, or has had no job for `rest`; a
//   job that passes more bytes through (a large file, a surface to remesh) has a new worker, which is ended
//   after it.
// - At most `mostJobs` workers hold surfaces, and at most one idle worker holds none.

import { cancelled, type GirthError } from '../types/errors.js';
import type { CommonOperations } from '../types/protocol.js';
import { bytesOf, type SurfaceSource } from './surface-source.js';
import { WorkerClient, type WorkerLike } from './worker-client.js';

export interface JobNeeds {
  /** Surfaces that the job refers to. */
  surfaces?: readonly SurfaceSource[];
  /** Bytes of further input, which does not stay in the worker. Default: 0. */
  passing?: number;
}

export interface JobPoolOptions {
  /** Jobs at a time: each may need several times the memory of a model. Default: 2. */
  mostJobs?: number;
  /** Bytes of input. Default: 8 MB, a closed surface of about 150,000 vertices. */
  heavy?: number;
  /** Milliseconds for which a worker is kept that takes much memory and has no job; Infinity: always. Default: 10 000. */
  rest?: number;
}

interface Member<T extends CommonOperations> {
  readonly client: WorkerClient<T>;
  /** The most bytes of input that its worker has had at a time. */
  most: number;
  /** Ends its worker when it has rested long enough. */
  timer?: ReturnType<typeof setTimeout> | undefined;
}

export class JobPool<T extends CommonOperations> {
  readonly #create: () => WorkerLike;
  readonly #mostJobs: number;
  readonly #heavy: number;
  readonly #rest: number;
  readonly #busy = new Set<Member<T>>();
  /** The most recently used first. */
  #idle: Member<T>[] = [];
  /** Surfaces whose lives this pool listens to. */
  readonly #followed = new Set<number>();
  #pending: (() => void)[] = [];
  #jobs = 0;
  #closed: GirthError | undefined;

  constructor(
    create: () => WorkerLike,
    { mostJobs = 2, heavy = 8 * 2 ** 20, rest = 10_000 }: JobPoolOptions = {},
  ) {
    this.#create = create;
    this.#mostJobs = mostJobs;
    this.#heavy = heavy;
    this.#rest = rest;
  }

  /** Starts a worker to have it ready. */
  async start(): Promise<void> {
    if (this.#idle.length === 0) this.#idle.push(this.#newMember());
    await this.#idle[0]!.client.start();
  }

  /** Runs a job as soon as fewer than `mostJobs` run. When the signal fires, its worker is ended. */
  async run<R>(
    signal: AbortSignal,
    { surfaces = [], passing = 0 }: JobNeeds,
    job: (worker: WorkerClient<T>) => Promise<R>,
  ): Promise<R> {
    while (this.#jobs >= this.#mostJobs)
      await new Promise<void>((start) => this.#pending.push(start));
    ++this.#jobs;
    let member: Member<T> | undefined;
    const stop = () => member?.client.terminate(this.#closed ?? cancelled());
    try {
      if (this.#closed) throw this.#closed;
      if (signal.aborted) throw cancelled('cancelled', signal.reason);
      member = this.#reserve(surfaces, passing);
      signal.addEventListener('abort', stop);
      return await job(member.client);
    } finally {
      signal.removeEventListener('abort', stop);
      --this.#jobs;
      this.#pending.shift()?.();
      if (member) {
        this.#busy.delete(member);
        if (this.#closed || signal.aborted || passing > this.#heavy) stop();
        else this.#keepIdle(member);
      }
    }
  }

  /** Ends all workers at once and for good. */
  terminate(error: GirthError): void {
    this.#closed = error;
    for (const { client, timer } of [...this.#idle, ...this.#busy]) {
      clearTimeout(timer);
      client.terminate(error);
    }
    this.#idle = [];
  }

  #newMember(): Member<T> {
    return { client: new WorkerClient(this.#create), most: 0 };
  }

  /** A worker for a job, with room for its surfaces. */
  #reserve(surfaces: readonly SurfaceSource[], passing: number): Member<T> {
    for (const surface of surfaces) this.#follow(surface);
    const needed = new Map(surfaces.map((surface) => [surface.number, bytesOf(surface)]));
    const bytes = sum(needed.values());
    const member = this.#chosen([...needed.keys()], bytes, passing) ?? this.#newMember();
    this.#idle = this.#idle.filter((one) => one !== member);
    clearTimeout(member.timer);
    this.#busy.add(member);
    let others = 0;
    for (const [number, held] of [...member.client.held].reverse()) {
      if (needed.has(number)) continue;
      if (others + held > this.#heavy) member.client.drop(number);
      else others += held;
    }
    member.most = Math.max(member.most, bytes + passing + others);
    return member;
  }

  /** The idle worker that suits a job best; undefined where a new one is to be made. */
  #chosen(surfaces: readonly number[], bytes: number, passing: number): Member<T> | undefined {
    const idle = this.#idle;
    if (passing > this.#heavy) return idle.find(isBlank);
    const known = ({ client }: Member<T>) => surfaces.filter((one) => client.knows(one)).length;
    const mostKnown = Math.max(0, ...idle.map(known));
    if (mostKnown > 0) return idle.find((member) => known(member) === mostKnown);
    const stayingLight = idle.find(
      (member) => isBlank(member) || heldBytes(member) + bytes + passing <= this.#heavy,
    );
    if (stayingLight) return stayingLight;
    return idle.length + this.#busy.size < this.#mostJobs ? undefined : idle.at(-1);
  }

  /** Keeps a worker for later jobs, or ends it. */
  #keepIdle(member: Member<T>): void {
    clearTimeout(member.timer);
    if (isBlank(member) && (member.most > this.#heavy || this.#idle.some(isBlank))) {
      member.client.terminate(cancelled());
      return;
    }
    this.#idle.unshift(member);
    if (member.most > this.#heavy && this.#rest < Infinity) {
      member.timer = afterwards(() => this.#end(member), this.#rest);
    }
  }

  #end(member: Member<T>): void {
    this.#idle = this.#idle.filter((one) => one !== member);
    member.client.terminate(cancelled());
  }

  #follow({ number, life }: SurfaceSource): void {
    if (this.#followed.has(number)) return;
    this.#followed.add(number);
    life.addEventListener('abort', () => this.#drop(number), { once: true });
  }

  #drop(surface: number): void {
    this.#followed.delete(surface);
    for (const { client } of this.#busy) client.drop(surface);
    for (const member of this.#idle.filter(({ client }) => client.knows(surface))) {
      member.client.drop(surface);
      this.#idle = this.#idle.filter((one) => one !== member);
      this.#keepIdle(member);
    }
  }
}

/** A timer for which no program in Node.js goes on running. */
function afterwards(what: () => void, milliseconds: number): ReturnType<typeof setTimeout> {
  const timer = setTimeout(what, milliseconds);
  (timer as { unref?: () => void }).unref?.();
  return timer;
}

const sum = (numbers: Iterable<number>) => [...numbers].reduce((total, one) => total + one, 0);

const heldBytes = ({ client }: Pick<Member<CommonOperations>, 'client'>) =>
  sum(client.held.values());

const isBlank = (member: Pick<Member<CommonOperations>, 'client'>) => member.client.held.size === 0;
