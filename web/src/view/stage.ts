// The canvas and what is drawn on it: a surface, what lies on it, its shadow. The camera, the times of
// drawing and the way between canvas and surface are files of their own; this one composes them.
//
// The canvas takes the pointer. The picture lies behind it, on a canvas that belongs to the page's pool of WebGL
// contexts; as long as another stage has that, a picture is on the canvas itself.
//
// Points that come in or go out are in the surface's own coordinates.

import {
  type BufferGeometry,
  Group,
  Matrix4,
  type Object3D,
  PerspectiveCamera,
  Quaternion,
  Scene,
  Vector3,
} from 'three';
import type { FacePoint } from '../kernel/types/types.js';
import { CameraRig } from './camera-rig.js';
import {
  type CameraView,
  type Direction,
  fitDepth,
  fovFor,
  homeDirection,
  placeCamera,
  straightDirections,
} from './camera-view.js';
import type { Overlay } from './fat-lines.js';
import { type Points, fittedView, turned } from './fitted-view.js';
import { FrameScheduler } from './frame-scheduler.js';
import type { GroundShadow } from './ground-shadow.js';
import { Picker, type ScreenPoint } from './picker.js';
import { type Place, viewOfPlace } from './place-view.js';
import { type Borrower, type Drawer, renderers } from './renderer-pool.js';
import type { Graphics, Renderer } from './renderer.js';
import type { SectionPlane } from './section-plane.js';
import { Silhouette } from './silhouette.js';
import type { StraightName } from './straight-names.js';
import type { Surface } from './surface.js';
import { SurfaceSpace } from './surface-space.js';
import type { Rotation } from './up-axis.js';

/** So many vertices show from where a surface is seen whole. */
const enoughToFit = 60_000;

export interface StageEvents {
  /** Before a frame is drawn; returns true to ask for another one. */
  beforeFrame(): boolean;
  /** After a frame is drawn. */
  afterFrame(): void;
  /** The surface was touched: it is moved by hand, or pointed at. */
  touched(): void;
  /** The surface is seen from elsewhere than in the last frame; before this one is drawn. */
  moved(): void;
  /** The camera was moved and has come to rest. */
  rested(): void;
  /** The browser has taken the graphics away, or has given them back. */
  graphicsChanged(): void;
}

export class Stage implements Borrower {
  readonly #canvas: HTMLCanvasElement;
  readonly #events: StageEvents;
  /** Holds the canvas that is drawn on; closed, so that the page finds only the one that takes the pointer. */
  readonly #seat = document.createElement('div');
  readonly #seatRoot = this.#seat.attachShadow({ mode: 'closed' });
  #drawer: Drawer | undefined;
  #isResting = true;
  #ratio = 1;
  /** As it was when the stage was made. */
  readonly #atFirst: Graphics;
  readonly #scene = new Scene();
  readonly #space = new SurfaceSpace();
  readonly #onSurface = new Group();
  readonly #overlays = new Set<Overlay>();
  readonly #frames: FrameScheduler;
  readonly #rig: CameraRig;
  readonly #picker: Picker;
  /** Other stages, whose surfaces are to be seen as a whole from where this one's is. */
  companions: () => readonly Stage[] = () => [];
  #surface: Surface | undefined;
  #shadow: GroundShadow | undefined;
  #upright: Rotation = new Quaternion();
  #turnsAtHome = false;
  #isDisposed = false;
  #width = 1;
  #height = 1;

  constructor(canvas: HTMLCanvasElement, events: StageEvents) {
    this.#canvas = canvas;
    this.#events = events;
    this.#atFirst = renderers.check();
    Object.assign(this.#seat.style, { position: 'absolute', inset: '0', pointerEvents: 'none' });
    canvas.before(this.#seat);
    this.#scene.add(this.#space.group);
    this.#space.group.add(this.#onSurface);
    this.#frames = new FrameScheduler({
      begin: (now) => {
        const isChanging = events.beforeFrame();
        return this.#rig.fly(now) || isChanging;
      },
      isUnhurried: () => this.#rig.turning,
      advance: (seconds) => this.#rig.advance(seconds),
      draw: () => this.#draw(),
    });
    this.#rig = new CameraRig(canvas, {
      changed: () => this.#frames.invalidate(),
      stirred: () => this.#frames.look(),
      touched: () => events.touched(),
      moved: () => {
        if (this.#surface) events.moved();
      },
      rested: () => events.rested(),
    });
    this.#picker = new Picker(canvas, this.#rig.camera, this.#space);
  }

  /** Whether there is a picture; without one everything else works. */
  get graphics(): Graphics {
    return this.#drawer?.graphics ?? this.#atFirst;
  }

  /** Compiles an object's shaders beside the page's own work, so that its first frame is not late. */
  async prepare(object: Object3D): Promise<void> {
    await this.#held().compileAsync(object, this.#rig.camera, this.#scene);
  }

  /** Shows a surface from the standard direction, in place of the one before. */
  show(surface: Surface | undefined): void {
    this.#surface?.dispose();
    this.#surface = surface;
    if (surface) {
      this.#space.group.add(surface.object);
      surface.setPixelRatio(this.#ratio);
    }
    this.stand(new Quaternion());
  }

  /** Turns the surface upright, and looks at it from the standard direction; its shadow is gone. */
  stand(upright: Rotation): void {
    this.setShadow(undefined);
    this.#upright = upright;
    if (this.#surface) {
      this.#space.fit(this.#surface.bounds, upright);
      this.#surface.setUpright(upright);
      this.resetView();
    }
    this.invalidate();
  }

  /** How the surface is turned. */
  get upright(): Rotation {
    return this.#upright;
  }

  setShadow(shadow: GroundShadow | undefined): void {
    this.#shadow?.dispose();
    this.#shadow = shadow;
    if (shadow) this.#space.group.add(shadow.object);
    this.invalidate();
  }

  add(overlay: Overlay): void {
    overlay.setPixelRatio(this.#ratio);
    this.#overlays.add(overlay);
    this.#onSurface.add(overlay.object);
    this.invalidate();
  }

  remove(overlay: Overlay): void {
    this.#overlays.delete(overlay);
    overlay.dispose();
    this.invalidate();
  }

  /**
   * The canvas's size in CSS pixels, the heights at its top and bottom to keep free of the surface, and the
   * screen's pixels per CSS pixel.
   */
  resize(width: number, height: number, top: number, bottom: number, pixelRatio: number): void {
    this.#width = Math.max(1, width);
    this.#height = Math.max(1, height);
    this.#setRatio(Math.min(2, pixelRatio));
    this.#rig.fit(this.#width, this.#height, top, bottom);
    this.refit();
    // A picture that is out of view may be stretched.
    if (this.#drawer || !this.#isResting) this.#draw();
  }

  /** Nothing is drawn while resting, for example out of view. */
  rest(isResting: boolean): void {
    this.#isResting = isResting;
    this.#frames.rest(isResting);
  }

  /** Cuts away what lies in front of a plane; undefined: nothing. */
  cut(section: SectionPlane | undefined): void {
    if (this.#surface) this.#surface.section = section;
    this.invalidate();
  }

  /** Towards the eye, in the surface's coordinates. */
  get towardsEye(): [number, number, number] {
    return this.#space.directionToSurface(this.#rig.direction.clone()).toArray();
  }

  /** Asks for a frame. */
  invalidate(): void {
    this.#frames.invalidate();
  }

  /** Asks for a frame before long; many such requests share one. */
  invalidateSoon(): void {
    this.#frames.invalidateSoon();
  }

  /** Whether motion goes on after the hand has stopped. */
  setDamping(damping: boolean): void {
    this.#rig.damping = damping;
  }

  /** Turns slowly until touched. */
  set turning(turning: boolean) {
    this.#rig.turning = turning;
  }

  get turning(): boolean {
    return this.#rig.turning;
  }

  /** Ends the turning. */
  touch(): void {
    this.#rig.touch();
  }

  /** The point of the surface under a point of the window. */
  pick(clientX: number, clientY: number): FacePoint | undefined {
    return this.#surface && this.#picker.pick(this.#surface, clientX, clientY);
  }

  /** Where a point of the surface is on the canvas, whether it is hidden or not. */
  placeOf(point: Vector3): { x: number; y: number } {
    return this.#picker.place(point, this.#width, this.#height);
  }

  /** Where the camera is, in the surface's coordinates. */
  get eye(): Vector3 {
    return this.#picker.eye;
  }

  /** From the surface's coordinates into clip space, by columns, as of the last frame. */
  get clipMatrix(): readonly number[] {
    const { camera } = this.#rig;
    return new Matrix4()
      .multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse)
      .multiply(this.#space.group.matrixWorld)
      .toArray();
  }

  /** Where on the canvas the surface is, in cells of so many CSS pixels, as of the last frame. */
  silhouette(cell: number): Silhouette {
    const silhouette = new Silhouette(this.#width, this.#height, cell);
    this.#surface?.castOn(silhouette, this.clipMatrix, this.#width, this.#height);
    return silhouette;
  }

  /** Where a point of the surface is on the canvas. */
  project(point: Vector3): ScreenPoint {
    return this.#picker.project(this.#surface, point, this.#width, this.#height);
  }

  /** Whether there is room for the surface to turn where it is first seen. */
  set turnsAtHome(turns: boolean) {
    if (this.#turnsAtHome === turns) return;
    this.#turnsAtHome = turns;
    if (this.#rig.isHome) this.resetView();
  }

  /** Back to the standard direction, from where the surface is seen whole. */
  resetView(): void {
    const home = this.#home;
    if (home) this.#rig.reset(home);
  }

  /** The surface is seen whole again, from where it is seen, unless something else than its turning has moved the camera. */
  refit(): void {
    if (this.#rig.isHome) this.resetView();
    else if (this.#rig.hasOnlyTurned) {
      const whole = this.#wholeFrom(this.#rig.view);
      if (whole) this.#rig.refit(whole);
    }
  }

  get #home(): CameraView | undefined {
    return this.#wholeFrom(homeDirection);
  }

  /** From where the whole is seen in a direction; if it turns there, all the way round. */
  #wholeFrom(direction: Direction): CameraView | undefined {
    const points = this.#points;
    if (!points) return undefined;
    const seen = this.#turnsAtHome ? turned(points) : points;
    return fittedView(seen, direction, this.#rig.room);
  }

  /** Whether the camera is where `resetView` puts it. */
  get isHome(): boolean {
    return this.#rig.isHome;
  }

  /** Whether it turns, or is about to, and nothing else has moved the camera since. */
  get isTurning(): boolean {
    return this.#turnsAtHome && (this.#rig.isHome || this.#rig.hasOnlyTurned);
  }

  /** Looks straight at the whole surface: smoothly, or at once. */
  lookStraight(name: StraightName, atOnce: boolean): void {
    const points = this.#points;
    if (!points) return;
    this.#rig.flyTo(fittedView(points, straightDirections[name], this.#rig.room), atOnce);
  }

  /** Turns about a point of the surface from now on, and brings it into the middle. */
  turnAbout(point: Vector3, atOnce: boolean): void {
    this.#rig.flyTo({ ...this.#rig.view, target: this.#space.toScene(point).toArray() }, atOnce);
  }

  /** The directions of the file's axes on the screen: to the right, up, and towards the eye. */
  get axes(): Vector3[] {
    const back = this.#rig.camera.quaternion.clone().invert();
    return [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].map((axis) =>
      this.#space.directionToScene(axis).applyQuaternion(back),
    );
  }

  /** From where the surface is seen now; undefined where there is none. */
  get view(): CameraView | undefined {
    return this.#surface && this.#rig.view;
  }

  /** Looks from there at once; what lies beyond the limits of moving by hand is brought within. */
  lookFrom(view: CameraView): void {
    this.#rig.lookFrom(view);
  }

  /** Moves to where a place is seen well: smoothly, or at once. */
  flyTo(place: Place, atOnce: boolean): void {
    if (!this.#surface || place.points.length === 0) return;
    this.#rig.flyTo(this.#viewOf(place, this.#surface), atOnce);
  }

  /** Turns the camera about the surface, to the right and up, in radians. */
  orbit(right: number, up: number): void {
    this.#rig.orbit(right, up);
  }

  /** Multiplies the distance to the surface. */
  zoom(factor: number): void {
    this.#rig.zoom(factor);
  }

  /** CSS pixels for each unit of length, at the distance of what the camera looks at. */
  get pixelsPerUnit(): number {
    const surface = this.#surface;
    if (!surface) return 1;
    const half = Math.tan((this.#rig.camera.fov * Math.PI) / 360);
    return this.#height / (2 * half * this.#rig.view.distance * surface.bounds.radius);
  }

  /**
   * The picture as it is now, transparent where nothing is; `width` in pixels, as on the screen if undefined. `hasShadow`:
   * whether the ground has the shadow that it has on the screen.
   */
  picture(width?: number, hasShadow = true): HTMLCanvasElement {
    const ratio = this.#ratio;
    const shadow = hasShadow ? undefined : this.#shadow?.object;
    try {
      if (width !== undefined) this.#setRatio(width / this.#width);
      if (shadow) shadow.visible = false;
      this.#draw();
      return this.#copy();
    } finally {
      if (shadow) shadow.visible = true;
      if (width !== undefined) this.#setRatio(ratio);
      if (width !== undefined || shadow) this.#draw();
    }
  }

  #setRatio(ratio: number): void {
    this.#ratio = ratio;
    if (this.#drawer) this.#fit(this.#drawer.renderer);
    this.#surface?.setPixelRatio(ratio);
    for (const overlay of this.#overlays) overlay.setPixelRatio(ratio);
  }

  /**
   * A picture of a place of the surface, with `overlay` instead of what else is drawn on it. The canvas itself stays as
   * it is. Size in pixels.
   */
  pictureOf(
    place: Place,
    overlay: Overlay | undefined,
    width: number,
    height: number,
  ): HTMLCanvasElement {
    const [renderer, surface] = [this.#held(), this.#surface];
    if (!surface) throw new Error('no surface is shown');
    const camera = new PerspectiveCamera(fovFor(width, height), width / height);
    placeCamera(camera, this.#viewOf(place, surface));
    this.#onSurface.visible = false;
    if (this.#shadow) this.#shadow.object.visible = false;
    overlay?.setPixelRatio(1);
    if (overlay) this.#space.group.add(overlay.object);
    try {
      // Drawn and copied before the browser shows anything of it.
      renderer.setPixelRatio(1);
      renderer.setSize(width, height, false);
      surface.setPixelRatio(1);
      this.#render(camera);
      return this.#copy();
    } finally {
      overlay?.object.removeFromParent();
      this.#onSurface.visible = true;
      if (this.#shadow) this.#shadow.object.visible = true;
      surface.setPixelRatio(this.#ratio);
      this.#fit(renderer);
      this.#draw();
    }
  }

  dispose(): void {
    this.#isDisposed = true;
    this.#frames.stop();
    for (const overlay of this.#overlays) overlay.dispose();
    this.#overlays.clear();
    this.show(undefined);
    this.#rig.dispose();
    this.#seatRoot.replaceChildren();
    this.#seat.remove();
    this.#drawer = undefined;
    renderers.leave(this);
    this.#keepPicture(undefined);
  }

  // ---- the context

  get isResting(): boolean {
    return this.#isResting;
  }

  yield(): void {
    if (!this.#drawer) return;
    // The context keeps nothing beyond this task: drawn and copied at once.
    this.#render(this.#rig.camera);
    this.#keepPicture(this.#drawer.canvas);
    this.#seatRoot.replaceChildren();
    this.#drawer = undefined;
    // Geometries come back to the graphics memory with the next frame that draws them.
    this.#scene.traverse((object) => {
      if ('geometry' in object) (object.geometry as BufferGeometry).dispose();
    });
    renderers.giveBack(this);
  }

  graphicsChanged(): void {
    if (this.#isDisposed) return;
    this.invalidate();
    this.#events.graphicsChanged();
  }

  /** The renderer; borrowed now unless it is here. */
  #held(): Renderer {
    const drawer = renderers.lend(this);
    if (drawer !== this.#drawer) {
      this.#drawer = drawer;
      this.#fit(drawer.renderer);
      this.#seatRoot.replaceChildren(drawer.canvas);
      this.#keepPicture(undefined);
    }
    return drawer.renderer;
  }

  #fit(renderer: Renderer): void {
    renderer.setPixelRatio(this.#ratio);
    renderer.setSize(this.#width, this.#height, false);
  }

  /** Shows a copy of what was drawn, or lets what is drawn be seen. */
  #keepPicture(drawn: HTMLCanvasElement | undefined): void {
    const canvas = this.#canvas;
    // Also clears it.
    [canvas.width, canvas.height] = drawn ? [drawn.width, drawn.height] : [1, 1];
    if (drawn) canvas.getContext('2d')!.drawImage(drawn, 0, 0);
  }

  /** The points that are to be seen as a whole, in the scene's coordinates. */
  get #points(): Points | undefined {
    const own = this.points;
    if (!own) return undefined;
    const others = this.companions().flatMap((stage) => stage.points ?? []);
    return (see) => [own, ...others].forEach((points) => points(see));
  }

  /** The surface in the scene's coordinates; undefined where there is none. */
  get points(): Points | undefined {
    const surface = this.#surface;
    if (!surface) return undefined;
    const matrix = this.#space.group.matrixWorld;
    const point = new Vector3();
    return (see) =>
      surface.eachPosition((x, y, z) => {
        point.set(x, y, z).applyMatrix4(matrix);
        see(point.x, point.y, point.z);
      }, enoughToFit);
  }

  #viewOf(place: Place, surface: Surface): CameraView {
    return viewOfPlace(place, this.#rig.direction, surface, this.#space);
  }

  #copy(): HTMLCanvasElement {
    const { canvas } = this.#drawer!;
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    copy.getContext('2d')!.drawImage(canvas, 0, 0);
    return copy;
  }

  #draw(): void {
    this.#rig.drawn();
    this.#render(this.#rig.camera);
    this.#events.afterFrame();
  }

  #render(camera: PerspectiveCamera): void {
    fitDepth(camera);
    const renderer = this.#held();
    // A picture of a place shows it whole.
    const section = camera === this.#rig.camera ? this.#surface?.section : undefined;
    renderer.clippingPlanes = section ? [this.#space.planeOf(section)] : [];
    renderer.render(this.#scene, camera);
  }
}
