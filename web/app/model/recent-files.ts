// Files of earlier visits with their pictures: in the menu beside 'Open', and at the foot of the page as long as nothing
// was opened on this visit. The menu says which files can be kept, and which not.

import type { FileWithPath } from '../../src/kernel/index.js';
import { type GirthViewer, make } from '../../src/element/index.js';
import { byId } from '../widgets/dom.js';
import type { Files } from './drop.js';
import { failureWords } from '../widgets/failure-words.js';
import { handleOf, keepHandle } from './file-handles.js';
import { recentPicture } from './recent-picture.js';
import { type RecentFile, RecentStore, mostBytes } from './recent-store.js';

/** A file handle in browsers that ask the user before it is read again. */
interface AskableHandle extends FileSystemFileHandle {
  queryPermission?(wish: { mode: 'read' }): Promise<PermissionState>;
  requestPermission?(wish: { mode: 'read' }): Promise<PermissionState>;
}

/** How many are offered at the foot of the page. */
const mostAtFoot = 3;
const day = 86_400_000;

const contentOf = (file: File | FileWithPath): Blob => (file instanceof File ? file : file.content);
const nameOf = (file: File | FileWithPath): string =>
  file instanceof File ? file.name : file.path;

function bytesWords(bytes: number): string {
  return bytes < 1e5
    ? `${Math.max(1, Math.round(bytes / 1e3))} kB`
    : `${(bytes / 1e6).toFixed(1)} MB`;
}

/** The day in words, by the calendar. */
function whenWords(when: number): string {
  const midnight = (time: number): number => new Date(time).setHours(0, 0, 0, 0);
  const days = Math.round((midnight(Date.now()) - midnight(when)) / day);
  return ['today', 'yesterday'][Math.max(0, days)] ?? `${days} days ago`;
}

/** Why nothing was kept. */
function faultWords(error: unknown): string {
  const isFull = error instanceof DOMException && error.name === 'QuotaExceededError';
  return isFull
    ? 'There is no room left in this browser: the file was not kept.'
    : 'This browser keeps no files for this page.';
}

export class RecentFiles {
  readonly #store = new RecentStore();
  readonly #viewer: GirthViewer;
  readonly #openFiles: (files: Promise<Files>) => void;
  readonly #opener = byId('recent-open');
  readonly #sheet = byId('recent');
  readonly #foot = make('div', { role: 'group', 'aria-label': 'Recent files', class: 'recents' });
  readonly #list = make('ul');
  readonly #said = make('p', { class: 'hint', role: 'status' });
  readonly #clear = make('button', { type: 'button', class: 'plain' }, 'Forget all');
  /** The number of the file that is shown; undefined where it is none of them. */
  #shown: Promise<number | undefined> | undefined;
  /** The one whose picture with all of its colours is there. */
  #drawn: Promise<number | undefined> | undefined;

  constructor(viewer: GirthViewer, openFiles: (files: Promise<Files>) => void) {
    this.#viewer = viewer;
    this.#openFiles = openFiles;
    this.#sheet.append(this.#list, make('p', {}, this.#clear), this.#said);
    this.#clear.addEventListener('click', () => void this.#changeAnew(() => this.#store.clear()));
    this.#foot.hidden = true;
    byId('examples').prepend(this.#foot);
    void this.#refresh(true);
  }

  /** Files were opened, and are shown now. */
  opened(files: Files): void {
    this.#foot.hidden = true;
    this.#said.textContent = '';
    this.#shown = this.#keep(files);
    void this.draw();
  }

  /** Another model is shown. */
  left(): void {
    this.#shown = undefined;
  }

  /** Takes a picture of what is shown, where that is one of the files. */
  async draw(): Promise<void> {
    const shown = this.#shown;
    if (shown === this.#drawn) return;
    const id = await shown;
    if (id === undefined) return;
    // Where nothing can be drawn, there is no picture.
    const picture = await recentPicture(this.#viewer).catch(() => undefined);
    if (!picture || this.#shown !== shown) return;
    if (this.#viewer.info && this.#viewer.shareOf('igf') === 1) this.#drawn = shown;
    await this.#change(() => this.#store.setPicture(id, picture));
  }

  async #keep(files: Files): Promise<number | undefined> {
    const [first] = files;
    if (!first) return undefined;
    const bytes = files.reduce((sum, file) => sum + contentOf(file).size, 0);
    const more = files.length > 1 ? ` and ${files.length - 1} more` : '';
    const common = { name: `${nameOf(first)}${more}`, when: Date.now(), bytes };
    const handle = files.length === 1 && first instanceof File ? await handleOf(first) : undefined;
    let id: number | undefined;
    if (handle) {
      // Not all handles can be kept: of files in a private window, for example.
      id = await this.#store.add({ ...common, handle }).catch(() => undefined);
    }
    if (id === undefined && bytes > mostBytes) {
      this.#said.textContent = `${common.name} is too large to be kept: at most ${bytesWords(mostBytes)} are.`;
    } else if (id === undefined) {
      await this.#change(async () => (id = await this.#store.add({ ...common, copy: [...files] })));
    }
    await this.#refresh();
    return id;
  }

  /** Changes what somebody asks for: the earlier message is about something else. */
  async #changeAnew(act: () => Promise<unknown>): Promise<void> {
    this.#said.textContent = '';
    await this.#change(act);
  }

  /** Changes the kept files, and reports failures. An earlier message stays: it may not be read yet. */
  async #change(act: () => Promise<unknown>): Promise<void> {
    try {
      await act();
    } catch (error) {
      this.#said.textContent = faultWords(error);
    }
    await this.#refresh();
  }

  async #refresh(isFirst = false): Promise<void> {
    // Where nothing can be kept, there is nothing to show, and nobody has asked for it.
    const files = await this.#store.list().catch(() => []);
    const focused = this.#buttonsOf(document.activeElement?.closest('li'));
    const at = focused.findIndex((button) => button === document.activeElement);
    const id = focused[at]?.closest('li')?.dataset['id'];
    this.#list.replaceChildren(...files.map((file) => this.#row(file)));
    this.#clear.hidden = files.length === 0;
    this.#opener.hidden = files.length === 0 && this.#said.textContent === '';
    if (id !== undefined) {
      // The focus stays on its button, if that file is still there.
      const same = this.#buttonsOf(this.#list.querySelector(`li[data-id="${id}"]`))[at];
      (same ?? this.#list.querySelector('button') ?? this.#sheet).focus();
    }
    if (files.length === 0) this.#foot.hidden = true;
    if (!isFirst || files.length === 0) return;
    this.#foot.replaceChildren(
      ...files.slice(0, mostAtFoot).map((file) => this.#button(file, file.name)),
    );
    this.#foot.hidden = false;
  }

  /** The buttons of a row of the list. */
  #buttonsOf(row: Element | null | undefined): HTMLButtonElement[] {
    return row && this.#list.contains(row) ? [...row.querySelectorAll('button')] : [];
  }

  #row(file: RecentFile): HTMLElement {
    const { id, name, when, bytes, handle } = file;
    const about = [whenWords(when), bytesWords(bytes), handle ? 'read again' : 'a copy'].join(
      ' · ',
    );
    const forget = make('button', { type: 'button', 'aria-label': `Forget ${name}` }, '✕');
    forget.addEventListener('click', () => void this.#changeAnew(() => this.#store.remove(id)));
    const words = make('span', {}, make('b', {}, name), make('small', {}, about));
    return make('li', { 'data-id': String(id) }, this.#button(file, words), forget);
  }

  #button(file: RecentFile, words: HTMLElement | string): HTMLElement {
    const picture = make('canvas', { width: '144', height: '108', 'aria-hidden': 'true' });
    // Not as an image: policies of hosts may allow none that is made here.
    if (file.picture) {
      void createImageBitmap(file.picture).then(
        (bitmap) => picture.getContext('2d')!.drawImage(bitmap, 0, 0),
        () => undefined,
      );
    }
    const button = make('button', { type: 'button' }, picture, words);
    button.addEventListener('click', () => this.#open(file));
    return button;
  }

  /** Opens one; if it cannot be read again, says why. */
  #open({ name, handle, copy = [] }: RecentFile): void {
    this.#said.textContent = '';
    const read = handle ? readAgain(handle).then((file) => [file]) : Promise.resolve(copy);
    const found = read.then(
      (files) => {
        if (this.#sheet.matches(':popover-open')) this.#sheet.hidePopover();
        return files;
      },
      (error: unknown) => {
        const isGone = error instanceof DOMException && error.name === 'NotFoundError';
        const why = isGone ? 'it was moved or deleted' : failureWords(error);
        this.#said.textContent = `${name} could not be read again: ${why}.`;
        if (!this.#sheet.matches(':popover-open')) this.#sheet.showPopover();
        return [];
      },
    );
    this.#openFiles(found);
  }
}

/** The file as it is now; browsers may ask first. */
async function readAgain(handle: AskableHandle): Promise<File> {
  const wish = { mode: 'read' } as const;
  let state = (await handle.queryPermission?.(wish)) ?? 'granted';
  if (state === 'prompt') state = (await handle.requestPermission?.(wish)) ?? 'granted';
  if (state !== 'granted') throw new Error('the browser was not permitted to');
  return keepHandle(await handle.getFile(), handle);
}
