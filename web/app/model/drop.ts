// The whole window takes dropped files and folders.

import type { FileWithPath } from '../../src/kernel/index.js';
import { keepHandle } from './file-handles.js';

/** The files of a model, those in folders with their paths. */
export type Files = readonly (File | FileWithPath)[];

/** More files than this are not one model's: somebody has dropped the whole disk. */
const mostFiles = 2000;

/** A drop, as far as it is read here. */
export interface Dropped {
  readonly files: Iterable<File>;
  readonly items: Iterable<Pick<DataTransferItem, 'kind' | 'webkitGetAsEntry'>>;
}

/** An item in browsers that have file handles. */
interface ItemWithHandle {
  getAsFileSystemHandle?(): Promise<FileSystemHandle | null>;
}

/** Shows `curtain` while files are over the window and calls `open` when some are dropped: folders are still looked into. */
export function acceptDrops(curtain: HTMLElement, open: (files: Promise<Files>) => void): void {
  const carriesFiles = (event: DragEvent): boolean =>
    event.dataTransfer?.types.includes('Files') ?? false;
  const take = (dropped: Dropped): void => open(filesOf(dropped));
  // Entering a child comes before leaving its parent: count both.
  let depth = 0;
  window.addEventListener('dragenter', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    ++depth;
    curtain.hidden = false;
  });
  window.addEventListener('dragover', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = 'copy';
  });
  window.addEventListener('dragleave', (event) => {
    if (!carriesFiles(event)) return;
    depth = Math.max(0, depth - 1);
    curtain.hidden = depth === 0;
  });
  window.addEventListener('drop', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    depth = 0;
    curtain.hidden = true;
    take(event.dataTransfer!);
  });
  // Files that were dropped before are with `start.ts`.
  window.dispatchEvent(new CustomEvent('takedrops', { detail: take }));
}

/** The dropped files, those in folders with their paths. */
async function filesOf(dropped: Dropped): Promise<Files> {
  // Entries and files have to be asked for at once: afterwards the drop is forgotten.
  const files = [...dropped.files];
  const ofFiles = [...dropped.items].filter(({ kind }) => kind === 'file') as ItemWithHandle[];
  ofFiles.forEach((item, i) => {
    const handle = item.getAsFileSystemHandle?.();
    if (handle && files[i]) keepHandle(files[i], handle);
  });
  const entries = [...dropped.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  if (!entries.some((entry) => entry?.isDirectory)) return files;
  const found: FileWithPath[] = [];
  for (const entry of entries) if (entry) await collect(entry, found);
  return found;
}

async function collect(entry: FileSystemEntry, found: FileWithPath[]): Promise<void> {
  if (found.length >= mostFiles || entry.name.startsWith('.')) return;
  if (entry.isFile) {
    const content = await new Promise<File | undefined>((resolve) =>
      (entry as FileSystemFileEntry).file(resolve, () => resolve(undefined)),
    );
    if (content) found.push({ path: entry.fullPath.replace(/^\//, ''), content });
    return;
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  for (;;) {
    // A folder is handed out in portions of at most 100.
    const portion = await new Promise<FileSystemEntry[]>((resolve) =>
      reader.readEntries(resolve, () => resolve([])),
    );
    if (portion.length === 0) return;
    for (const inner of portion) await collect(inner, found);
  }
}
