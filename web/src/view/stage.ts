// The scene, the camera and the canvas. Draws only when something has changed.
//
// The scene's unit is the surface's radius and its origin the middle of the surface, so that the camera,
// its limits and the shaders' 32-bit numbers meet the same sizes whether a file counts in micrometres or in
// kilometres. Points that come in or go out are in the surface's own coordinates.

import {
  Group,
  type Object3D,
  PerspectiveCamera,
  Quaternion,
  Raycaster,
  Scene,
  Sphere,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { FacePoint } from '../kernel/types.js';
import { bestDirection, eased, viewBetween } from './camera-flight.js';
import type { Overlay } from './fat-lines.js';
import type { GroundShadow } from './ground-shadow.js';
import type { Surface } from './surface.js';

/** Smallest of the two viewing angles, in degrees. */
const viewingAngle = 28;
/** From how far something is seen whole, in its radii. */
const wholeDistance = 1.08 / Math.sin((viewingAngle * Math.PI) / 360);
/** Motion since the last frame that nobody sees, as a share of the camera's distance: under 0.05 pixels. */
const unseenPace = 2e-5;
/** Motion that is none but rounding. */
const roundingPace = 1e-12;
/** Milliseconds between two frames of a surface that only turns by itself. */
const turningInterval = 30;
/** Milliseconds of a flight of the camera. */
const flightTime = 700;
/** Of a small place so much is seen round it, in radii of the surface. */
const leastReach = 0.28;
/** Of a place's points so many are looked for, to see whether it is hidden. */
const sightings = 14;
/** Milliseconds between two frames while only colours change, at least and at most. */
const colourInterval = [100, 1000] as const;
/** Share of the time that may go into such frames, where drawing is slow: the work goes first. */
const colourShare = 0.2;

export interface StageEvents {
  /** Before a frame is drawn; returns true to ask for another one. */
  beforeFrame(): boolean;
  /** After a frame is drawn. */
  afterFrame(): void;
  /** The surface was touched: it is moved by hand, or pointed at. */
  touched(): void;
  /** The camera was moved and has come to rest. */
  rested(): void;
}

/** From where a surface is seen, whatever its size and place. */
export interface CameraView {
  /** Angle from straight above, and round the vertical axis from the front to the right; radians. */
  polar: number;
  azimuth: number;
  /** From the camera to what it looks at, in radii of the surface. */
  distance: number;
  /** What it looks at, from the middle of the surface, in radii of the surface. */
  target: [number, number, number];
}

/** A place of a surface to look at. */
export interface Place {
  points: readonly Vector3[];
  /** From where to look rather, if that is known: the mean normal. */
  outwards?: Vector3 | undefined;
}

/** A point of the surface on the canvas, in CSS pixels from its top left corner. */
export interface ScreenPoint {
  x: number;
  y: number;
  /** False where the surface hides the point or it is outside of the canvas. */
  visible: boolean;
}

export class Stage {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  /** From the surface's coordinates to the scene's. */
  readonly #inRadii = new Group();
  readonly #onSurface = new Group();
  readonly #overlays = new Set<Overlay>();
  readonly #camera = new PerspectiveCamera(viewingAngle, 1, 0.01, 100);
  readonly #controls: OrbitControls;
  readonly #raycaster = new Raycaster();
  #surface: Surface | undefined;
  #shadow: GroundShadow | undefined;
  #width = 1;
  #height = 1;
  #requested = 0;
  #soon: ReturnType<typeof setTimeout> | undefined;
  #dirty = false;
  #lastFrame = 0;
  /** Milliseconds that a frame keeps the page busy, drawing and compositing, smoothed. */
  #frameCost = 0;
  #resting = true;
  #turnsByItself = false;
  /** Whether the camera was moved since it last came to rest. */
  #moved = false;
  /** Where the camera was for the last frame. */
  readonly #drawnFrom = {
    position: new Vector3(),
    quaternion: new Quaternion(),
    target: new Vector3(),
  };
  /** Whether a hand holds the surface. */
  #held = false;
  /** Whether a hand's motion, or the turning's, may still fade away. */
  #drifting = false;
  #flight: { from: CameraView; to: CameraView; begun: number } | undefined;
  readonly #canvas: HTMLCanvasElement;
  readonly #events: StageEvents;

  /** Throws where the browser has no WebGL 2. */
  constructor(canvas: HTMLCanvasElement, events: StageEvents) {
    this.#canvas = canvas;
    this.#events = events;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, stencil: true });
    this.#renderer.setClearColor(0x000000, 0);
    this.#scene.add(this.#inRadii);
    this.#inRadii.add(this.#onSurface);
    this.#controls = new OrbitControls(this.#camera, canvas);
    this.#controls.enableDamping = true;
    this.#controls.dampingFactor = 0.14;
    this.#controls.rotateSpeed = 0.9;
    this.#controls.autoRotateSpeed = 1.1;
    this.#controls.minDistance = 0.15;
    this.#controls.maxDistance = 4 * wholeDistance;
    this.#controls.addEventListener('start', () => {
      this.#flight = undefined;
      this.#held = this.#drifting = true;
      this.touch();
    });
    this.#controls.addEventListener('end', () => {
      this.#held = false;
      this.#schedule();
    });
    // The controls report no motion that is small to them, though it may be seen where the surface is near.
    canvas.addEventListener('pointermove', () => {
      if (this.#held) this.#schedule();
    });
    this.#controls.addEventListener('change', () => {
      this.#moved ||= !this.#turnsByItself;
      this.invalidate();
    });
  }

  /** Compiles an object's shaders beside the page's own work, so that its first frame need not wait. */
  async prepare(object: Object3D): Promise<void> {
    await this.#renderer.compileAsync(object, this.#camera, this.#scene);
  }

  /** Shows a surface from the standard direction, in place of the one before. */
  show(surface: Surface | undefined): void {
    this.#surface?.dispose();
    this.setShadow(undefined);
    this.#surface = surface;
    if (surface) {
      const { center, radius } = surface.bounds;
      this.#inRadii.scale.setScalar(1 / radius);
      this.#inRadii.position.copy(center).divideScalar(-radius);
      this.#inRadii.updateMatrixWorld();
      this.#inRadii.add(surface.object);
      surface.setPixelRatio(this.#renderer.getPixelRatio());
      this.resetView();
    }
    this.invalidate();
  }

  setShadow(shadow: GroundShadow | undefined): void {
    this.#shadow?.dispose();
    this.#shadow = shadow;
    if (shadow) this.#inRadii.add(shadow.object);
    this.invalidate();
  }

  add(overlay: Overlay): void {
    overlay.setPixelRatio(this.#renderer.getPixelRatio());
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
   * The canvas's size in CSS pixels, the height at its bottom to keep free of the surface, and the
   * screen's pixels per CSS pixel.
   */
  resize(width: number, height: number, bottom: number, pixelRatio: number): void {
    this.#width = Math.max(1, width);
    this.#height = Math.max(1, height);
    this.#renderer.setPixelRatio(Math.min(2, pixelRatio));
    this.#renderer.setSize(this.#width, this.#height, false);
    const ratio = this.#renderer.getPixelRatio();
    this.#surface?.setPixelRatio(ratio);
    for (const overlay of this.#overlays) overlay.setPixelRatio(ratio);
    // The standard angle fits into the width and into the height that is left.
    const room = Math.max(0.4 * this.#height, this.#height - bottom);
    this.#camera.aspect = this.#width / this.#height;
    this.#camera.fov = fovFor(Math.min(this.#width, room), this.#height);
    const down = (this.#height - room) / 2;
    this.#camera.setViewOffset(this.#width, this.#height, 0, down, this.#width, this.#height);
    this.#draw();
  }

  /** Nothing is drawn while resting, for example out of view. */
  rest(resting: boolean): void {
    this.#resting = resting;
    if (!resting) this.invalidate();
  }

  /** Whether motion goes on after the hand has stopped. */
  setDamping(damping: boolean): void {
    this.#controls.enableDamping = damping;
  }

  /** Turns slowly until touched. */
  set turning(turning: boolean) {
    this.#drifting ||= this.#turnsByItself;
    this.#turnsByItself = turning;
    this.#controls.autoRotate = turning;
    this.invalidate();
  }

  get turning(): boolean {
    return this.#turnsByItself;
  }

  /** Ends the turning. */
  touch(): void {
    if (this.#turnsByItself) this.turning = false;
    this.#events.touched();
  }

  /** Asks for a frame before long; many such requests share one. */
  invalidateSoon(): void {
    this.#soon ??= setTimeout(
      () => {
        this.#soon = undefined;
        this.invalidate();
      },
      Math.min(colourInterval[1], Math.max(colourInterval[0], this.#frameCost / colourShare)),
    );
  }

  /** Asks for a frame. */
  invalidate(): void {
    this.#dirty = true;
    this.#schedule();
  }

  /** The point of the surface under a point of the window. */
  pick(clientX: number, clientY: number): FacePoint | undefined {
    if (!this.#surface) return undefined;
    const box = this.#canvas.getBoundingClientRect();
    const place = new Vector2(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
    );
    this.#raycaster.setFromCamera(place, this.#camera);
    const { ray } = this.#raycaster;
    this.#onTheSurface(ray.origin);
    return this.#surface.pick(ray);
  }

  project(point: Vector3): ScreenPoint {
    const { x, y, z } = this.#inTheScene(point).project(this.#camera);
    const inside = Math.abs(x) <= 1 && Math.abs(y) <= 1 && z > -1 && z < 1;
    return {
      x: (0.5 + 0.5 * x) * this.#width,
      y: (0.5 - 0.5 * y) * this.#height,
      visible:
        inside && !this.#surface?.hides(point, this.#onTheSurface(this.#camera.position.clone())),
    };
  }

  /** A point of the surface in the scene's coordinates. */
  #inTheScene(point: Vector3): Vector3 {
    return point.clone().applyMatrix4(this.#inRadii.matrixWorld);
  }

  /** Turns a point of the scene into the surface's coordinates. */
  #onTheSurface(point: Vector3): Vector3 {
    return point.sub(this.#inRadii.position).divide(this.#inRadii.scale);
  }

  /** Back to the standard direction and distance. */
  resetView(): void {
    if (!this.#surface) return;
    this.#flight = undefined;
    this.#setView({
      polar: (68 * Math.PI) / 180,
      azimuth: (32 * Math.PI) / 180,
      distance: wholeDistance,
      target: [0, 0, 0],
    });
  }

  /** From where the surface is seen now; undefined where there is none. */
  get view(): CameraView | undefined {
    if (!this.#surface) return undefined;
    const { target } = this.#controls;
    const arm = this.#camera.position.clone().sub(target);
    const distance = arm.length();
    return {
      polar: Math.acos(Math.min(1, Math.max(-1, arm.y / distance))),
      azimuth: Math.atan2(arm.x, arm.z),
      distance,
      target: target.toArray(),
    };
  }

  /** Looks from there at once; what lies beyond the limits of moving by hand is brought within. */
  lookFrom(view: CameraView): void {
    this.#flight = undefined;
    this.touch();
    this.#setView(view);
  }

  /** Moves to where a place is seen well: smoothly, or at once. */
  flyTo(place: Place, atOnce: boolean): void {
    const { view: from } = this;
    if (!from || place.points.length === 0) return;
    this.touch();
    const to = this.#viewOf(place);
    this.#flight = atOnce ? undefined : { from, to, begun: performance.now() };
    if (atOnce) this.#setView(to);
    this.invalidate();
  }

  #setView({ polar, azimuth, distance, target }: CameraView): void {
    // Nothing of what moved before may go on from there.
    this.#finishMotion();
    this.#controls.target.fromArray(target).clampLength(0, 4);
    this.#camera.position
      .setFromSphericalCoords(distance, Math.min(Math.PI - 0.01, Math.max(0.01, polar)), azimuth)
      .clampLength(this.#controls.minDistance, this.#controls.maxDistance)
      .add(this.#controls.target);
    this.#controls.update();
    this.invalidate();
  }

  /** From where a place is seen well, with what is round it. */
  #viewOf({ points, outwards }: Place): CameraView {
    const surface = this.#surface!;
    const ball = new Sphere().setFromPoints(points.map((point) => this.#inTheScene(point)));
    const reach = Math.min(1, Math.max(1.35 * ball.radius, leastReach));
    const distance = reach * wholeDistance;
    const step = Math.max(1, Math.floor(points.length / sightings));
    const looked = points.filter((_, i) => i % step === 0);
    const seen = (direction: Vector3): number => {
      const eye = this.#onTheSurface(ball.center.clone().addScaledVector(direction, distance));
      return looked.filter((point) => !surface.hides(point, eye)).length / looked.length;
    };
    const present = this.#camera.position.clone().sub(this.#controls.target).normalize();
    const { x, y, z } = bestDirection(present, outwards, seen);
    return {
      polar: Math.acos(Math.min(1, Math.max(-1, y))),
      azimuth: Math.atan2(x, z),
      distance,
      target: ball.center.toArray(),
    };
  }

  /** Turns the camera about the surface, to the right and up, in radians. */
  orbit(right: number, up: number): void {
    this.#flight = undefined;
    this.touch();
    const arm = this.#camera.position.clone().sub(this.#controls.target);
    const radius = arm.length();
    const polar = Math.acos(Math.min(1, Math.max(-1, arm.y / radius))) - up;
    const azimuth = Math.atan2(arm.x, arm.z) + right;
    arm.setFromSphericalCoords(radius, Math.min(Math.PI - 0.01, Math.max(0.01, polar)), azimuth);
    this.#camera.position.copy(this.#controls.target).add(arm);
    this.#controls.update();
    this.invalidate();
  }

  /** Multiplies the distance to the surface. */
  zoom(factor: number): void {
    this.#flight = undefined;
    this.touch();
    const arm = this.#camera.position.clone().sub(this.#controls.target).multiplyScalar(factor);
    arm.clampLength(this.#controls.minDistance, this.#controls.maxDistance);
    this.#camera.position.copy(this.#controls.target).add(arm);
    this.#controls.update();
    this.invalidate();
  }

  /** The picture as it is now, transparent where nothing is. */
  picture(): HTMLCanvasElement {
    this.#draw();
    return this.#copy();
  }

  /**
   * A picture of a place of the surface, with `overlay` instead of what else is drawn on it. What is on
   * the canvas stays. Size in pixels.
   */
  pictureOf(
    place: Place,
    overlay: Overlay | undefined,
    width: number,
    height: number,
  ): HTMLCanvasElement {
    const [renderer, inRadii, surface] = [this.#renderer, this.#inRadii, this.#surface];
    if (!surface) throw new Error('no surface is shown');
    const [size, ratio] = [renderer.getSize(new Vector2()), renderer.getPixelRatio()];
    const camera = new PerspectiveCamera(fovFor(width, height), width / height);
    const view = this.#viewOf(place);
    const target = new Vector3().fromArray(view.target);
    camera.position.setFromSphericalCoords(view.distance, view.polar, view.azimuth).add(target);
    camera.lookAt(target);
    this.#onSurface.visible = false;
    if (this.#shadow) this.#shadow.object.visible = false;
    overlay?.setPixelRatio(1);
    if (overlay) inRadii.add(overlay.object);
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
      surface.setPixelRatio(ratio);
      renderer.setPixelRatio(ratio);
      renderer.setSize(size.x, size.y, false);
      this.#draw();
    }
  }

  #copy(): HTMLCanvasElement {
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [this.#canvas.width, this.#canvas.height];
    copy.getContext('2d')!.drawImage(this.#canvas, 0, 0);
    return copy;
  }

  dispose(): void {
    cancelAnimationFrame(this.#requested);
    clearTimeout(this.#soon);
    this.#resting = true;
    for (const overlay of this.#overlays) overlay.dispose();
    this.#overlays.clear();
    this.show(undefined);
    this.#controls.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
  }

  #schedule(): void {
    if (this.#requested || this.#resting) return;
    this.#requested = requestAnimationFrame((now) => this.#frame(now));
  }

  #frame(now: number): void {
    this.#requested = 0;
    const again = this.#events.beforeFrame();
    this.#fly(now);
    const elapsed = now - this.#lastFrame;
    if (!this.#dirty && this.#turnsByItself && elapsed < turningInterval) {
      this.#schedule();
      return;
    }
    this.#lastFrame = now;
    const moving = this.#steer(Math.min(0.1, elapsed / 1000));
    if (this.#moved && !moving && !this.#flight) {
      this.#moved = false;
      this.#events.rested();
    }
    if (this.#dirty || moving) {
      this.#dirty = false;
      const begun = performance.now();
      this.#draw();
      // A task of its own comes after the browser has composited what was drawn.
      setTimeout(() => (this.#frameCost = 0.5 * (this.#frameCost + performance.now() - begun)));
    }
    if (again) this.invalidate();
    else if (moving) this.#schedule();
  }

  /**
   * Goes on with what a hand has begun, or with the turning; returns whether there is more to come. A camera
   * at rest keeps its place to the last bit: what is under a pointer stays under it.
   */
  #steer(seconds: number): boolean {
    if (!this.#drifting && !this.#turnsByItself) return false;
    const [camera, controls, drawnFrom] = [this.#camera, this.#controls, this.#drawnFrom];
    controls.update(seconds);
    if (this.#turnsByItself) return true;
    const moved =
      camera.position.distanceTo(drawnFrom.position) + controls.target.distanceTo(drawnFrom.target);
    const pace = moved / camera.position.distanceTo(controls.target);
    if (pace > unseenPace) {
      this.#moved = true;
      return true;
    }
    if (pace < roundingPace) {
      camera.position.copy(drawnFrom.position);
      camera.quaternion.copy(drawnFrom.quaternion);
      controls.target.copy(drawnFrom.target);
      // The controls have made the matrix anew as well, and what is picked next uses it.
      camera.updateMatrixWorld();
    } else if (!this.#held) {
      // Less than a pixel.
      this.#finishMotion();
      this.#dirty = this.#moved = true;
    }
    this.#drifting = this.#held;
    return false;
  }

  /** What is left of a motion, at once. */
  #finishMotion(): void {
    const { enableDamping } = this.#controls;
    this.#controls.enableDamping = false;
    this.#controls.update();
    this.#controls.enableDamping = enableDamping;
  }

  /** Goes on with a flight of the camera. */
  #fly(now: number): void {
    if (!this.#flight) return;
    const { from, to, begun } = this.#flight;
    const time = (now - begun) / flightTime;
    if (time >= 1) this.#flight = undefined;
    this.#setView(viewBetween(from, to, eased(time)));
  }

  #draw(): void {
    this.#drawnFrom.position.copy(this.#camera.position);
    this.#drawnFrom.quaternion.copy(this.#camera.quaternion);
    this.#drawnFrom.target.copy(this.#controls.target);
    this.#render(this.#camera);
    this.#events.afterFrame();
  }

  #render(camera: PerspectiveCamera): void {
    const distance = camera.position.length();
    camera.near = Math.max(0.02, distance - 1.2);
    camera.far = distance + 3;
    camera.updateProjectionMatrix();
    this.#renderer.render(this.#scene, camera);
  }
}

/** The vertical angle, in degrees, with which the standard angle fits into a width and the height. */
function fovFor(width: number, height: number): number {
  const half = Math.tan((viewingAngle * Math.PI) / 360);
  return (360 / Math.PI) * Math.atan((half * height) / Math.min(width, height));
}
