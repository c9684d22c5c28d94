// The element before anything of it is needed: its attributes, its place on the page, and what stands there until
// the surface is drawn. It fetches the rest, `viewer-core.ts`, when the element comes near the view or is asked
// for something. Only what is light is imported here.

import type { GirthErrorFields, LoadOptions, MeshInfo, MeshSource } from '../kernel/types/types.js';
import { findLengthUnit } from '../kernel/types/length-units.js';
import type { ViewerState } from './attributes/attribute-types.js';
import {
  type AttributeName,
  attributeNames,
  attributeOf,
  faultOf,
} from './attributes/attributes.js';
import { make } from './controls/dom.js';
import type { GirthViewerEvents } from './events.js';
import { MessageBox } from './controls/message-box.js';
import { pageParsed } from './model/page-parsed.js';
import type { Presented } from './presented.js';
import { shellStyle } from './controls/shell-style.js';
import { attributesOf, stateNames, stateOf } from './attributes/state.js';
import type { ViewerCore } from './viewer-core.js';

/** How far outside of the view an element is near it, in CSS pixels. */
const nearness = 400;

/** The symbol of a unit of length; '' for none. */
const unitOf = (text: string | null): string => findLengthUnit(text ?? '')?.symbol ?? '';

/** The base class; a server, which has no elements, gets a class that nobody makes one of. */
const ElementOrNone = globalThis.HTMLElement ?? class {};

/** See `GirthViewer`, which adds what can be asked of the element. */
export abstract class ViewerShell extends ElementOrNone {
  /** The attributes that the element follows; see `GirthViewer`. */
  static readonly observedAttributes: readonly string[] = attributeNames;

  readonly #message = new MessageBox();
  readonly #poster = make('img', { alt: '' });
  readonly #stand = make('div', { class: 'poster', part: 'poster' });
  readonly #frame = make('div', { class: 'frame' }, this.#stand, this.#message.element);
  #isStandingIn = true;
  #fetching: Promise<ViewerCore> | undefined;
  #watching: IntersectionObserver | undefined;
  /** The core, which draws and computes; undefined until it is needed. */
  protected core: ViewerCore | undefined;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(shellStyle);
    root.adoptedStyleSheets = [sheet];
    this.#poster.hidden = true;
    this.#stand.append(make('slot', { name: 'poster' }, this.#poster));
    const caption = make('slot', { name: 'caption' });
    root.append(this.#frame, make('div', { class: 'figure-caption', part: 'caption' }, caption));
  }

  /** Called by the browser when the element comes onto a page. */
  connectedCallback(): void {
    // An element that was only moved is watched already.
    if (this.#watching) return;
    if (this.core) this.core.attach();
    this.#watching = new IntersectionObserver(
      (entries) => {
        if (!entries.at(-1)!.isIntersecting) return;
        this.#watching?.unobserve(this);
        void this.#start();
      },
      { rootMargin: `${nearness}px` },
    );
    this.#watching.observe(this);
    // The core can come while the page is busy with other things.
    if (attributeOf(this, 'loading') !== 'lazy') void import('./viewer-core.js').catch(() => 0);
  }

  /** Called by the browser when the element leaves its page: all work ends, and all memory is let go. */
  disconnectedCallback(): void {
    // An element that is moved is back before anything else happens.
    queueMicrotask(() => {
      if (this.isConnected || !this.#watching) return;
      this.#watching.disconnect();
      this.#watching = undefined;
      this.core?.detach();
      this.#setStandIn(true);
    });
  }

  /** Called by the browser when the element is moved as a whole: nothing changes. */
  connectedMoveCallback(): void {
    this.core?.stage?.invalidate();
  }

  /** Called by the browser when one of `observedAttributes` has changed. */
  attributeChangedCallback(name: string, before: string | null, value: string | null): void {
    if (before === value) return;
    const fault = value === null ? undefined : faultOf(name as AttributeName, value);
    if (fault) void pageParsed().then(() => this.#send('error', fault));
    if (name === 'poster') {
      this.#poster.hidden = !value;
      if (value) this.#poster.src = value;
      else this.#poster.removeAttribute('src');
    }
    this.core?.follow(name, value);
  }

  /** The model as it is drawn, once there is something to draw. */
  protected get presented(): Presented | undefined {
    return this.core?.presented;
  }

  /** The model that is shown; undefined before the first. */
  get info(): MeshInfo | undefined {
    return this.core?.info;
  }

  /** The symbol of the unit of lengths: the file's; where it states none, the attribute's; '' for none. */
  get unit(): string {
    return unitOf(this.info?.unit ?? '') || unitOf(attributeOf(this, 'unit'));
  }

  /** The unit that lengths are written in: the attribute's where it is one, otherwise ''. */
  get shownUnit(): string {
    return unitOf(attributeOf(this, 'shown-unit'));
  }

  /**
   * The state of the element, in the words of the attributes: `JSON.stringify` keeps it. Changes by
   * hand or by methods are in it; `src` only where it names the model that is shown.
   */
  get state(): ViewerState {
    const state = stateOf(this);
    this.core?.describe(state);
    return state;
  }

  /**
   * Shows what was kept: sets the attributes that it has and removes the others, but for `src`, without which the model
   * stays. Throws an error of the code INVALID_OPTION for what is no state; then nothing changes.
   */
  set state(state: ViewerState) {
    const texts = attributesOf(state);
    for (const name of stateNames) {
      const text = texts.get(name) ?? null;
      const before = this.getAttribute(name);
      if (name === 'src' && text === null) continue;
      if (text === null) this.removeAttribute(name);
      else this.setAttribute(name, text);
      // A change by hand since is taken back, although the attribute is the same.
      if (text === before) this.core?.followAgain(name, text);
    }
  }

  /**
   * Reads a model and shows it, grey at first; the field follows by itself. Where the file cannot
   * be used the model before stays, the element shows why, `error` is sent and the promise rejected.
   * A newer call ends an older one.
   */
  async load(
    source: MeshSource,
    options: Pick<LoadOptions, 'model' | 'prepare'> = {},
  ): Promise<MeshInfo> {
    const core = await this.needed();
    return core.load(source, options);
  }

  /** Does what a key means for the surface, as if it had the focus; false where it means nothing. */
  press(event: KeyboardEvent): boolean {
    return this.core?.press(event) ?? false;
  }

  /** Stops computing fields; what there is stays. */
  cancel(): void {
    this.core?.cancel();
  }

  /** The model as it is drawn; throws where none is. */
  protected require(): Presented {
    if (!this.core) throw new Error('no model is loaded');
    return this.core.require();
  }

  /** The drawn model, read by the kernel, so that it can compute; rejected where there is none. */
  protected async whole(): Promise<Presented> {
    this.require();
    return this.core!.whole();
  }

  /** The core, fetched now unless it is there. */
  protected needed(): Promise<ViewerCore> {
    this.#fetching ??= import('./viewer-core.js').then(
      ({ ViewerCore }) => {
        this.core = new ViewerCore(this.#host());
        if (this.isConnected) this.core.attach();
        return this.core;
      },
      (cause: unknown) => {
        this.#fetching = undefined;
        throw this.#report({
          code: 'PROGRAM_NOT_LOADED',
          element: -1,
          message: `a part of the viewer could not be fetched: ${String(cause)}`,
          hint: 'check the connection and that its files lie together, and reload the page',
        });
      },
    );
    return this.#fetching;
  }

  #host() {
    const hasPoster = () => this.#hasPoster;
    return {
      element: this,
      frame: this.#frame,
      message: this.#message,
      unitOf: () => this.unit,
      shownUnitOf: () => this.shownUnit,
      drawn: () => this.#setStandIn(false),
      undrawable: (error: GirthErrorFields) => void this.#report(error),
      get hasPoster() {
        return hasPoster();
      },
    };
  }

  async #start(): Promise<void> {
    // A failure has been reported already.
    await this.needed().catch(() => undefined);
  }

  /** Whether there is a picture to be seen in place of the surface. */
  get #hasPoster(): boolean {
    return !this.#poster.hidden || this.querySelector(':scope > [slot=poster]') !== null;
  }

  #setStandIn(isStandingIn: boolean): void {
    if (this.#isStandingIn === isStandingIn) return;
    this.#isStandingIn = isStandingIn;
    this.#stand.hidden = !isStandingIn;
  }

  /** Says what keeps the element from drawing, in words where no picture stands in for it. */
  #report(fields: GirthErrorFields): Error {
    if (!this.#hasPoster) this.#message.show('', fields, false);
    this.#send('error', fields);
    return Object.assign(new Error(fields.message), fields);
  }

  #send<Name extends keyof GirthViewerEvents>(
    name: Name,
    detail: GirthViewerEvents[Name]['detail'],
  ): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}
