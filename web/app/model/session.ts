// Which model is on the page, where it came from, and what was done to it.

import type { HandleRemoval, MeshSource, PrepareOptions } from '../../src/kernel/index.js';
import { type GirthViewer, formatCount } from '../../src/element/index.js';
import { isOfSurface } from '../state/actions.js';
import type { PageState } from '../state/address-state.js';

/** A model that can be read again, to be prepared otherwise. */
export interface Opened {
  source: MeshSource;
  /** The name of the model in links: an example, an address, or a file that links cannot have. */
  link: Pick<PageState, 'model' | 'file'>;
  /** Which of several models that came together. */
  model?: string | undefined;
  prepare: PrepareOptions;
  /** The remeshing after reading: the wished faces, and words for it. */
  remeshed?: { faces: number; words: string } | undefined;
  /** Handles shorter than this, in model units, were taken away after remeshing. */
  handles?: number | undefined;
  /** The value of `handles` before handles were taken away last. */
  handlesBefore?: number | undefined;
  /** The wish that it is opened for (`Store.ask`). */
  wish?: number | undefined;
  /** Hands what was computed of it before to the surface that is shown, if it is that one; once. */
  adopt?: ((viewer: GirthViewer) => Promise<void> | void) | undefined;
}

/** The steps and wishes after reading: none yet. */
const asRead = {
  ...{ remeshed: undefined, handles: undefined, handlesBefore: undefined },
  ...{ wish: undefined, adopt: undefined },
};

/** Whether two are the same surface: read from the same, and prepared in the same way. */
export function isSameModel(one: Opened, other: Opened): boolean {
  const done = ({ source, model, prepare, remeshed, handles }: Opened): string =>
    JSON.stringify([filesIn(source), model, prepare, remeshed?.faces, handles]);
  const isSameSource = one.source === other.source || filesIn(one.source) !== undefined;
  return isSameSource && done(one) === done(other);
}

/** An address, or the names, sizes and dates of files; undefined for content that has none. */
function filesIn(source: MeshSource): unknown {
  if (typeof source === 'string') return source;
  const files = (Array.isArray(source) ? source : [source]) as readonly unknown[];
  const known = files.map((file) => {
    const { content = file, path = '' } = file as { content?: unknown; path?: string };
    if (!(content instanceof File)) return undefined;
    return [path, content.name, content.size, content.lastModified];
  });
  return known.includes(undefined) ? undefined : known;
}

export class Session {
  /** The model that is shown. */
  opened: Opened | undefined;
  /** The model that is shown as soon as the element has it. */
  #next: Opened | undefined;
  /** The model that is being read. */
  #reading: Opened | undefined;
  /** Files that were dropped or chosen on this visit, by the names that links have for them. */
  readonly #files = new Map<string, Opened>();
  readonly #viewer: GirthViewer;
  /** Takes what is computed of the shown surface; see `takeResults`. */
  readonly #takeResults: () => () => void;
  /** How many models were asked for. */
  #asked = 0;
  /** The number of the one that was opened last. */
  #latest = 0;

  /** `takeResults`: see there. */
  constructor(viewer: GirthViewer, takeResults: () => () => void) {
    this.#viewer = viewer;
    this.#takeResults = takeResults;
  }

  /** A number for a model that was asked for now, and whose files have to be found or looked into before it is opened. */
  ask(): number {
    return ++this.#asked;
  }

  /** Whether a model that was asked for later has been opened meanwhile: it stays. */
  isOvertaken(asked: number): boolean {
    return asked < this.#latest;
  }

  /**
   * Shows a model; what goes wrong is written on the surface by the element itself. False where that is so.
   * `asked`: its number. Default: it was asked for now.
   */
  async open(wanted: Opened, asked = this.ask()): Promise<boolean> {
    this.#latest = asked;
    const { source, model, prepare } = wanted;
    const { opened } = this;
    const isSame = opened?.source === source && opened.model === model;
    const adopt = wanted.adopt ?? (isSame ? this.#takeResults() : undefined);
    const opening = { ...wanted, adopt };
    this.#next = this.#reading = opening;
    const options = model === undefined ? { prepare } : { prepare, model };
    const isOpen = await this.#viewer.load(source, options).then(
      () => true,
      () => false,
    );
    if (this.#reading === opening) this.#reading = undefined;
    return isOpen;
  }

  /** Whether the surface can be remeshed: otherwise the model must be read again before. */
  get canRemesh(): boolean {
    const { opened } = this;
    return opened?.handles === undefined && (!opened?.remeshed || !!this.#viewer.original);
  }

  async remesh(faces: number): Promise<boolean> {
    const viewer = this.#viewer;
    const { opened } = this;
    if (!opened || !viewer.info) return false;
    const before = formatCount((viewer.original ?? viewer.info).faceCount);
    const words = `remeshed from ${before} to about ${formatCount(faces)} faces`;
    this.#next = { ...opened, remeshed: { faces, words } };
    return viewer.remesh(faces).then(
      () => true,
      () => false,
    );
  }

  /** Shows it without its short handles; undefined where that came to nothing. */
  async removeHandles(length: number, wish?: number): Promise<HandleRemoval | undefined> {
    const { opened } = this;
    if (!opened) return undefined;
    const { handles: before } = opened;
    const handles = Math.max(length, before ?? 0);
    const next = { ...opened, handles, handlesBefore: before, wish };
    this.#next = next;
    const removal = await this.#viewer.removeHandles(length).catch(() => undefined);
    if (this.opened !== next && this.#next === next) this.#next = opened;
    return removal;
  }

  /** Whether a link names the surface as it was before handles were taken away last. */
  isBefore({ handles, ...rest }: PageState): boolean {
    const { opened } = this;
    if (opened?.handles === undefined || !this.#viewer.removal) return false;
    return handles === opened.handlesBefore && this.isOf({ ...rest, handles: opened.handles });
  }

  /** Shows the surface with its handles again. */
  async restore(wish: number): Promise<boolean> {
    const { opened } = this;
    if (!opened) return false;
    this.#next = { ...opened, handles: opened.handlesBefore, handlesBefore: undefined, wish };
    return this.#viewer.restore().then(
      () => true,
      () => false,
    );
  }

  /** Opens the model again, prepared otherwise; false where that came to nothing. */
  async reopen(change: PrepareOptions, wish?: number): Promise<boolean> {
    const { opened } = this;
    if (!opened) return false;
    const prepare = { ...opened.prepare, ...change };
    return this.open({ ...opened, ...asRead, prepare, wish });
  }

  /** The file of that name, where it was opened before on this visit: no link can have it. */
  openedBefore(file: string): Opened | undefined {
    const before = this.#files.get(file);
    return before && { ...before, ...asRead };
  }

  /** How many times as large as its file the model is. */
  get scale(): number {
    return this.opened?.prepare.scale ?? 1;
  }

  /** The model as its file has it. */
  back(): void {
    if (this.opened) void this.open({ ...this.opened, ...asRead, prepare: {} });
  }

  /** Another of the models that came together. */
  choose(model: string): void {
    const { opened } = this;
    if (!opened) return;
    void this.open({ source: opened.source, link: { file: model }, model, prepare: {} });
  }

  /** Which of several models that came together is shown. */
  name(model: string): void {
    if (this.opened) this.opened = { ...this.opened, model, link: { file: model } };
  }

  /** The element shows what was asked for last; returns whether it is another model than before. */
  arrived(): boolean {
    const next = this.#next;
    const { opened } = this;
    this.opened = next;
    if (next?.link.file !== undefined) this.#files.set(next.link.file, next);
    return opened?.source !== next?.source || opened?.model !== next?.model;
  }

  /** Hands what came with the model to the surface that is shown. */
  async adopt(): Promise<void> {
    const { opened } = this;
    const adopt = opened?.adopt;
    if (!opened || !adopt) return;
    this.opened = { ...opened, adopt: undefined };
    await adopt(this.#viewer);
  }

  read(): PageState {
    const { opened } = this;
    if (!opened) return {};
    const { prepare, remeshed, handles, link } = opened;
    const state: PageState = { ...link };
    if (prepare.closeHoles) state.closed = true;
    if (prepare.weldDistance) state.weld = prepare.weldDistance;
    if (this.scale !== 1) state.scale = this.scale;
    if (prepare.components?.length) state.components = [...prepare.components];
    if (remeshed) state.faces = remeshed.faces;
    if (handles !== undefined) state.handles = handles;
    return state;
  }

  /** Whether a link names the surface that is shown, and stays, prepared in the same way. */
  isOf(state: PageState): boolean {
    return !this.#reading && isOfSurface(this.read(), state);
  }
}
