// Where one looks and how the surface is drawn, as the element's attributes, its bar and its keys have it.

import { type CameraView, type Stage, lookNames } from '../view/index.js';
import { attributeOf, controlsOf, isOn } from './attributes.js';
import { CanvasBar } from './canvas-bar.js';
import { press } from './keys.js';
import type { Presented } from './presented.js';
import { isMotionReduced } from './surroundings.js';
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
  /** From where the last model was seen. */
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
    return isKept;
  }

  /** An attribute of where one looks, or of how the surface is drawn, has changed. */
  follow(name: string): void {
    const { element } = this.#host;
    const presented = this.#host.presented();
    if (name === 'edges' || name === 'shading') this.#draw();
    if (name === 'up' && presented) presented.standing.wished = attributeOf(element, 'up');
    if (name === 'turn') this.#turning.update();
    this.#update();
  }

  /** After a frame. */
  place(): void {
    const stage = this.#host.stage();
    if (stage) this.#bar.place(stage);
  }

  /** What is computed, or how much motion is wished for, has changed. */
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

  /** Something was chosen on the bar: an attribute, so that the page can see it and keep it. */
  #choose(name: string, value: string | null): void {
    const { element } = this.#host;
    if (value === null) element.removeAttribute(name);
    else element.setAttribute(name, value);
    element.dispatchEvent(new CustomEvent('view'));
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
