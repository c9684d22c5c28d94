// Controls of the view and of how the surface is drawn, by attributes, the bar and keys.

import { type CameraView, type Stage, formatLength, lookNames } from '../../view/index.js';
import { attributeOf, controlsOf, isOn } from '../attributes/attributes.js';
import { CanvasBar, button, icon } from './canvas-bar.js';
import { make } from './dom.js';
import { press } from './keys.js';
import type { Presented } from '../presented.js';
import type { SectionTool } from './section-tool.js';
import { parseSection } from '../attributes/section-words.js';
import { isMotionReduced } from '../surface/surroundings.js';
import { Turning } from './turning.js';

export interface ControlsHost {
  /** The element with the attributes. */
  readonly element: HTMLElement;
  stage(): Stage | undefined;
  presented(): Presented | undefined;
}

export class CanvasControls {
  readonly #host: ControlsHost;
  readonly #bar: CanvasBar;
  readonly #turning: Turning;
  /** The tool that cuts the surface, once it is asked for or there is a bar to ask on. */
  #section: SectionTool | undefined;
  #isFetching = false;
  /** The view of the last model. */
  #view: CameraView | undefined;

  constructor(host: ControlsHost) {
    this.#host = host;
    const { element } = host;
    this.#bar = new CanvasBar({
      home: () => host.stage()?.resetView(),
      lookStraight: (name) => host.stage()?.lookStraight(name, isMotionReduced()),
      setUp: (name) => this.#choose('up', name),
      setLook: (name) => this.#choose('shading', name === 'smooth' ? null : name),
      setEdges: (shown) => this.#choose('edges', shown ? '' : null),
      keepView: (kept) => this.#choose('keep-view', kept ? '' : null),
      toggleTurning: () => this.#turning.toggle(),
    });
    this.#turning = new Turning({
      stage: () => host.stage(),
      isWished: () => isOn(element, 'turn'),
      isBusy: () => host.presented()?.model.fields.computing !== undefined,
      ended: () => element.dispatchEvent(new CustomEvent('touch')),
      changed: (isTurning) => this.#bar.showTurning(isTurning),
    });
    this.#update();
  }

  /** The bar. */
  get element(): HTMLElement {
    return this.#bar.element;
  }

  /** The canvas is on a page, until the signal. */
  attach(canvas: HTMLCanvasElement, signal: AbortSignal): void {
    this.#turning.listen(this.#bar.turn, signal);
    canvas.addEventListener('pointerdown', () => this.#bar.close(), { signal });
    canvas.addEventListener('keydown', (event) => this.press(event), { signal });
  }

  /** The model that is presented goes. */
  leave(): void {
    this.#view = this.#host.stage()?.view;
  }

  /** Another model is presented; returns whether it is seen from where the one before was. */
  greet(): boolean {
    const isKept = this.#view !== undefined && isOn(this.#host.element, 'keep-view');
    if (isKept) this.#host.stage()?.lookFrom(this.#view!);
    this.#draw();
    this.#update();
    void this.#cut();
    return isKept;
  }

  /** An attribute of where one looks, or of how the surface is drawn, has changed. */
  follow(name: string): void {
    const { element } = this.#host;
    const presented = this.#host.presented();
    if (name === 'edges' || name === 'shading') this.#draw();
    if (name === 'up' && presented) presented.standing.wished = attributeOf(element, 'up');
    if (name === 'turn') this.#turning.update();
    if (name === 'section' || name === 'controls') void this.#cut();
    this.#update();
  }

  /** Places the bar after a frame. */
  place(): void {
    const stage = this.#host.stage();
    if (stage) this.#bar.place(stage);
  }

  /** Lets the turning follow a change in computing, or in the system's wish for less motion. */
  updateTurning(): void {
    this.#turning.update();
  }

  /** The surface was moved or pointed at. */
  touched(): void {
    this.#turning.end();
  }

  /** Does what a key means for the surface; false where it means nothing. */
  press(event: KeyboardEvent): boolean {
    const [stage, presented] = [this.#host.stage(), this.#host.presented()];
    if (!stage || !presented || !press(event, stage, presented.loops, isMotionReduced()))
      return false;
    event.preventDefault();
    return true;
  }

  /**
   * Something was chosen on the bar: an attribute, so that the page can see it and keep it; not yet, while the hand is
   * moving.
   */
  #choose(name: string, value: string | null, isMoving = false): void {
    const { element } = this.#host;
    if (value === null) element.removeAttribute(name);
    else element.setAttribute(name, value);
    if (!isMoving) element.dispatchEvent(new CustomEvent('view'));
  }

  /** Cuts the surface as the attribute asks for. */
  async #cut(): Promise<void> {
    const { element } = this.#host;
    if (!this.#section) {
      const isNeeded = controlsOf(element) === 'full' || attributeOf(element, 'section') !== null;
      if (!isNeeded || this.#isFetching) return;
      this.#isFetching = true;
      const { SectionTool } = await import('./section-tool.js');
      this.#section = new SectionTool({
        stage: () => this.#host.stage(),
        surface: () => this.#host.presented()?.model.surface,
        kit: { make, button, icon },
        root: element.shadowRoot!,
        lengthWords: (length) => formatLength(length, this.#host.presented()!.lengthFormat),
        origin: () => this.#host.presented()!.model.mesh.geometry.origin,
        wished: () => parseSection(attributeOf(element, 'section') ?? ''),
        choose: (text, isMoving) => this.#choose('section', text, isMoving),
      });
      this.#bar.add(this.#section.opener, this.#section.menu);
    }
    if (this.#host.presented()) this.#section.update();
  }

  get #look() {
    const wished = attributeOf(this.#host.element, 'shading');
    return lookNames.find((name) => name === wished) ?? 'smooth';
  }

  #draw(): void {
    const surface = this.#host.presented()?.model.surface;
    surface?.setLook(this.#look);
    surface?.showEdges(isOn(this.#host.element, 'edges'));
  }

  #update(): void {
    const [bar, { element }] = [this.#bar, this.#host];
    const presented = this.#host.presented();
    const controls = controlsOf(element);
    bar.show(controls === 'full', controls === 'full' || isOn(element, 'turn'));
    bar.showLook(this.#look, isOn(element, 'edges'));
    bar.showKept(isOn(element, 'keep-view'));
    if (presented) bar.showUp(presented.standing.axis, presented.standing.fitting);
  }
}
