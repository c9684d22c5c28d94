// The element's states: what is shown, read and computed, and who disposes of what, without a browser.

import { beforeEach, expect, test, vi } from 'vitest';
import { Lifecycle } from '../../../web/src/element/lifecycle.js';
import { Work } from '../../../web/src/element/work.js';

/** A mesh that knows how often it was disposed of. */
class FakeMesh {
  disposed = 0;
  constructor(readonly name: string) {}
  dispose(): void {
    ++this.disposed;
  }
}

interface Shown {
  mesh: FakeMesh;
}

/** A promise that is kept or broken from outside. */
function deferred<Value>() {
  let resolve!: (value: Value) => void;
  let reject!: (error: unknown) => void;
  const promise = new Promise<Value>((keep, fail) => {
    resolve = keep;
    reject = fail;
  });
  return { promise, resolve, reject };
}

const events: string[] = [];
let preparing: Promise<unknown>;
let life: Lifecycle<FakeMesh, Shown, Shown, { mesh: FakeMesh }, 'igf' | 'kind', 'igf'>;

beforeEach(() => {
  events.length = 0;
  preparing = Promise.resolve();
  const work = new Work({ showWork: () => undefined, endWork: () => undefined });
  life = new Lifecycle(work, {
    prepare: async (mesh) => {
      await preparing;
      return { mesh };
    },
    present: ({ mesh }) => {
      events.push(`show ${mesh.name}`);
      return { mesh };
    },
    presented: ({ mesh }) => {
      expect(life.shown?.mesh).toBe(mesh);
    },
    drop: ({ mesh }, keepsMesh) => {
      expect(life.shown).toBe(undefined);
      events.push(`drop ${mesh.name}`);
      if (!keepsMesh) mesh.dispose();
    },
    failed: (name, error) => {
      events.push(`failed ${name}: ${(error as Error).message}`);
    },
  });
});

/** Asks for a model whose reading ends when the test says so, however little it heeds its end. */
function ask(name: string, origin?: { mesh: FakeMesh }, mesh = new FakeMesh(name)) {
  const read = deferred<FakeMesh>();
  let signal!: AbortSignal;
  const done = life.load({
    words: 'Reading …',
    name,
    read: (watched) => {
      ({ signal } = watched);
      return read.promise;
    },
    origin,
  });
  const outcome = done.then(
    () => 'shown',
    (error: Error) => error.message,
  );
  return { ...read, mesh, outcome, signal, arrive: () => read.resolve(mesh) };
}

async function shown(name: string, origin?: { mesh: FakeMesh }): Promise<FakeMesh> {
  const { mesh, outcome, arrive } = ask(name, origin);
  arrive();
  expect(await outcome).toBe('shown');
  return mesh;
}

test('from nothing to a model, and to another one', async () => {
  expect(life.phase).toBe('detached');
  life.attach();
  expect(life.phase).toBe('empty');
  const a = ask('a');
  expect(life.phase).toBe('loading');
  a.arrive();
  expect(await a.outcome).toBe('shown');
  expect(life.phase).toBe('shown');
  const b = ask('b');
  expect(life.phase).toBe('replacing');
  expect(life.shown?.mesh).toBe(a.mesh);
  b.arrive();
  await b.outcome;
  expect(life.phase).toBe('shown');
  expect(events).toEqual(['show a', 'drop a', 'show b']);
  expect([a.mesh.disposed, b.mesh.disposed]).toEqual([1, 0]);
});

test('a model that cannot be read leaves the one before', async () => {
  life.attach();
  const a = await shown('a');
  const b = ask('b');
  b.reject(new Error('no model'));
  expect(await b.outcome).toBe('no model');
  expect(life.phase).toBe('shown');
  expect(life.shown?.mesh).toBe(a);
  expect(events).toEqual(['show a', 'failed b: no model']);
});

test('a model that cannot be drawn is disposed of', async () => {
  life.attach();
  preparing = Promise.reject(new Error('too large'));
  const a = ask('a');
  a.arrive();
  expect(await a.outcome).toBe('too large');
  expect(life.phase).toBe('empty');
  expect(a.mesh.disposed).toBe(1);
  expect(events).toEqual(['failed a: too large']);
});

test('a second load ends the first, and what that still brings is disposed of in silence', async () => {
  life.attach();
  const [a, b] = [ask('a'), ask('b')];
  expect([a.signal.aborted, b.signal.aborted]).toEqual([true, false]);
  b.arrive();
  await b.outcome;
  a.arrive();
  expect(await a.outcome).not.toBe('shown');
  expect(a.mesh.disposed).toBe(1);
  expect(events).toEqual(['show b']);
  expect(life.phase).toBe('shown');
});

test('a second load that comes while the first is made ready to draw', async () => {
  life.attach();
  const ready = deferred<void>();
  preparing = ready.promise;
  const a = ask('a');
  a.arrive();
  await Promise.resolve();
  preparing = Promise.resolve();
  const b = ask('b');
  ready.resolve();
  expect(await a.outcome).not.toBe('shown');
  expect(a.mesh.disposed).toBe(1);
  expect(life.phase).toBe('loading');
  b.arrive();
  expect(await b.outcome).toBe('shown');
  expect(events).toEqual(['show b']);
});

test('a cancelled load says nothing, and what was shown stays', async () => {
  life.attach();
  const a = await shown('a');
  const b = ask('b');
  life.cancelLoad();
  expect(life.phase).toBe('shown');
  b.reject(new Error('cancelled'));
  await b.outcome;
  expect(events).toEqual(['show a']);
  expect(a.disposed).toBe(0);
  life.cancelLoad();
  expect(life.phase).toBe('shown');
});

test('taken off its page in mid-load: nothing is shown, and nothing stays', async () => {
  life.attach();
  const a = await shown('a');
  const b = ask('b');
  life.detach();
  expect(life.phase).toBe('detached');
  expect(b.signal.aborted).toBe(true);
  b.arrive();
  expect(await b.outcome).not.toBe('shown');
  expect([a.disposed, b.mesh.disposed]).toEqual([1, 1]);
  expect(events).toEqual(['show a', 'drop a']);
  life.attach();
  expect(life.phase).toBe('empty');
  await shown('c');
  expect(life.phase).toBe('shown');
});

test('a load that is asked for before the element is on a page', async () => {
  const a = ask('a');
  life.attach();
  a.arrive();
  expect(await a.outcome).toBe('shown');
  life.detach();
  const b = ask('b');
  b.arrive();
  expect(await b.outcome).toBe('the element is no longer on a page');
  expect(b.mesh.disposed).toBe(1);
});

test('a mesh that others are made of is disposed of when the last of them goes', async () => {
  life.attach();
  const file = await shown('file');
  const first = await shown('first', { mesh: file });
  expect(file.disposed).toBe(0);
  expect(life.origin?.mesh).toBe(file);
  const second = await shown('second', { mesh: file });
  expect([file.disposed, first.disposed]).toEqual([0, 1]);
  await shown('other');
  expect([file.disposed, second.disposed]).toEqual([1, 1]);
  expect(life.origin).toBe(undefined);
  expect(events.filter((event) => event.startsWith('drop'))).toEqual([
    'drop file',
    'drop first',
    'drop second',
  ]);
});

test('with a remeshed surface both meshes go when the element does', async () => {
  life.attach();
  const file = await shown('file');
  const made = await shown('made', { mesh: file });
  life.detach();
  expect([file.disposed, made.disposed]).toEqual([1, 1]);
});

test('what a surface was made of is shown again', async () => {
  life.attach();
  const file = await shown('file');
  const made = await shown('made', { mesh: file });
  // Not before it is there: the surface that was made stays, and so does what it was made of.
  const late = ask('file', undefined, file);
  life.cancelLoad();
  late.arrive();
  expect(await late.outcome).not.toBe('shown');
  expect([file.disposed, made.disposed]).toEqual([0, 0]);
  const again = ask('file', undefined, file);
  again.arrive();
  expect(await again.outcome).toBe('shown');
  expect(life.shown?.mesh).toBe(file);
  expect(life.origin).toBe(undefined);
  expect([file.disposed, made.disposed]).toEqual([0, 1]);
  life.detach();
  expect(file.disposed).toBe(1);
});

test('a load that brings what is shown already changes nothing', async () => {
  life.attach();
  const file = await shown('file');
  const same = ask('file', { mesh: file }, file);
  same.arrive();
  expect(await same.outcome).toBe('shown');
  expect([life.phase, life.shown?.mesh, life.origin, file.disposed]).toEqual([
    'shown',
    file,
    undefined,
    0,
  ]);
  expect(events).toEqual(['show file']);
});

test('nothing is computed before it is in view', async () => {
  life.attach();
  await shown('a');
  const [compute, paint] = [vi.fn(() => Promise.resolve()), vi.fn()];
  const coloured = life.colour('igf', compute, paint);
  await Promise.resolve();
  expect(life.colouring).toBe('pending');
  expect(compute).not.toHaveBeenCalled();
  life.setInView(true);
  await coloured;
  expect(life.colouring).toBe('done');
  expect(paint).toHaveBeenCalledTimes(1);
});

test('only the newest wish is painted', async () => {
  life.attach();
  life.setInView(true);
  await shown('a');
  const slow = deferred<void>();
  const [late, paint] = [vi.fn(), vi.fn()];
  const first = life.colour('igf', () => slow.promise, late);
  await life.colour('kind', () => Promise.resolve(), paint);
  slow.resolve();
  await first;
  expect(late).not.toHaveBeenCalled();
  expect(paint).toHaveBeenCalledTimes(1);
  expect(life.colouring).toBe('done');
});

test('colours of a model that is gone are not painted, and their failure is no news', async () => {
  life.attach();
  life.setInView(true);
  await shown('a');
  const [kept, broken] = [deferred<void>(), deferred<void>()];
  const paint = vi.fn();
  const both = [
    life.colour('igf', () => kept.promise, paint),
    life.colour('igf', () => broken.promise, paint),
  ];
  await Promise.resolve();
  await shown('b');
  kept.resolve();
  broken.reject(new Error('gone'));
  await Promise.all(both);
  expect(paint).not.toHaveBeenCalled();
  expect(events).toEqual(['show a', 'drop a', 'show b']);
  expect(life.colouring).toBe('none');
});

test('a field that fails is told to the host', async () => {
  life.attach();
  life.setInView(true);
  await shown('a');
  await life.colour('igf', () => Promise.reject(new Error('no field')), vi.fn());
  expect(life.colouring).toBe('failed');
  expect(events.at(-1)).toBe('failed : no field');
});

test('a field that was halted is resumed, once', async () => {
  life.attach();
  life.setInView(true);
  await shown('a');
  const cancelled = () => {
    life.halt('igf');
    return Promise.reject(new Error('cancelled'));
  };
  await life.colour('igf', cancelled, vi.fn());
  expect(life.colouring).toBe('halted');
  const compute = vi.fn(() => Promise.resolve());
  expect(await life.resume(compute)).toBe(true);
  expect(compute).toHaveBeenCalledWith({ mesh: life.shown!.mesh }, 'igf');
  expect(await life.resume(compute)).toBe(false);
  expect(compute).toHaveBeenCalledTimes(1);
});

test('what was halted is forgotten with its model', async () => {
  life.attach();
  await shown('a');
  life.halt('igf');
  await shown('b');
  const compute = vi.fn(() => Promise.resolve());
  expect(await life.resume(compute)).toBe(false);
  expect(compute).not.toHaveBeenCalled();
});

test('resumed and halted once more, it stays so', async () => {
  life.attach();
  await shown('a');
  life.halt('igf');
  expect(await life.resume(() => Promise.reject(new Error('cancelled')))).toBe(false);
});
