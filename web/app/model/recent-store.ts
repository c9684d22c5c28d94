// Files that were opened on this browser, for later visits: by handles where the system has given such, otherwise as copies,
// which are bounded. All of it stays in this browser's database for the page.

import type { FileWithPath } from '../../src/kernel/index.js';

/** A file, or several that belong together, as it is kept. */
export interface RecentFile {
  id: number;
  name: string;
  /** The time of the last opening: milliseconds as of `Date.now`. */
  when: number;
  /** The size of all files together. */
  bytes: number;
  /** The surface as it looked. */
  picture?: Blob;
  /** Either where it is to be read again, or a copy; several have paths. */
  handle?: FileSystemFileHandle;
  copy?: (File | FileWithPath)[];
}

/** Bytes of all copies together, and how many files are known. */
export const mostBytes = 50_000_000;
const mostFiles = 12;

/** Which of files, the newest first, have to go so that the others are few and small enough. */
export function beyondBounds(
  files: readonly Pick<RecentFile, 'id' | 'bytes' | 'copy'>[],
  bounds = { bytes: mostBytes, files: mostFiles },
): number[] {
  let bytes = 0;
  let count = 0;
  return files
    .filter((file) => {
      const size = file.copy ? file.bytes : 0;
      if (count >= bounds.files || bytes + size > bounds.bytes) return true;
      bytes += size;
      ++count;
      return false;
    })
    .map(({ id }) => id);
}

const storeName = 'files';

function settled<Type>(request: IDBRequest<Type>): Promise<Type> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error('nothing was kept'));
  });
}

/** Every call throws what the browser throws: nothing may be kept, or there is no room. */
export class RecentStore {
  #opening: Promise<IDBDatabase> | undefined;

  #open(): Promise<IDBDatabase> {
    this.#opening ??= (async () => {
      const request = indexedDB.open('girth-recent', 1);
      request.onupgradeneeded = () =>
        request.result.createObjectStore(storeName, { keyPath: 'id', autoIncrement: true });
      return settled(request);
    })();
    return this.#opening;
  }

  /** Does something and waits until it is written. */
  async #change(act: (files: IDBObjectStore) => IDBRequest): Promise<unknown> {
    const transaction = (await this.#open()).transaction(storeName, 'readwrite');
    const written = new Promise<void>((resolve, reject) => {
      transaction.oncomplete = () => resolve();
      transaction.onabort = () => reject(transaction.error ?? new Error('nothing was kept'));
    });
    const asked = settled(act(transaction.objectStore(storeName)) as IDBRequest<unknown>);
    await Promise.all([asked, written]);
    return asked;
  }

  /** The newest first. */
  async list(): Promise<RecentFile[]> {
    const transaction = (await this.#open()).transaction(storeName);
    const request = transaction.objectStore(storeName).getAll() as IDBRequest<RecentFile[]>;
    return (await settled(request)).sort((a, b) => b.when - a.when);
  }

  /** Keeps a file in place of one of that name; returns its number. Older ones go where there are too many. */
  async add(file: Omit<RecentFile, 'id'>): Promise<number> {
    const before = (await this.list()).find(({ name }) => name === file.name);
    const { picture } = before ?? {};
    const whole = {
      ...(before ? { id: before.id } : {}),
      ...(picture ? { picture } : {}),
      ...file,
    };
    const id = (await this.#change((files) => files.put(whole))) as number;
    for (const old of beyondBounds(await this.list())) await this.remove(old);
    return id;
  }

  async setPicture(id: number, picture: Blob): Promise<void> {
    const file = (await this.list()).find((file) => file.id === id);
    if (file) await this.#change((files) => files.put({ ...file, picture }));
  }

  async remove(id: number): Promise<void> {
    await this.#change((files) => files.delete(id));
  }

  async clear(): Promise<void> {
    await this.#change((files) => files.clear());
  }
}
