// The scene, the camera and the canvas. Draws only when something has changed.

import {
  Group,
  type Object3D,
  PerspectiveCamera,
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
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly onSurface = new Group();
  private readonly overlays = new Set<Overlay>();
  private readonly camera = new PerspectiveCamera(viewingAngle, 1, 0.01, 100);
  private readonly controls: OrbitControls;
  private readonly raycaster = new Raycaster();
  private surface: Surface | undefined;
  private shadow: GroundShadow | undefined;
  private width = 1;
  private height = 1;
  private requested = 0;
  private soon: ReturnType<typeof setTimeout> | undefined;
  private dirty = false;
  private lastFrame = 0;
  /** Milliseconds that a frame keeps the page busy, drawing and compositing, smoothed. */
  private frameCost = 0;
  private resting = true;
  private turnsByItself = false;
  /** Whether the camera was moved since it last came to rest. */
  private moved = false;
  private flight: { from: CameraView; to: CameraView; begun: number } | undefined;

  /** Throws where the browser has no WebGL 2. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly events: StageEvents,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, stencil: true });
    this.renderer.setClearColor(0x000000, 0);
    this.scene.add(this.onSurface);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.14;
    this.controls.rotateSpeed = 0.9;
    this.controls.autoRotateSpeed = 1.1;
    this.controls.addEventListener('start', () => {
      this.flight = undefined;
      this.touch();
    });
    this.controls.addEventListener('change', () => {
      this.moved ||= !this.turnsByItself;
      this.invalidate();
    });
  }

  /** Compiles an object's shaders beside the page's own work, so that its first frame need not wait. */
  async prepare(object: Object3D): Promise<void> {
    await this.renderer.compileAsync(object, this.camera, this.scene);
  }

  /** Shows a surface from the standard direction, in place of the one before. */
  show(surface: Surface | undefined): void {
    this.surface?.dispose();
    this.setShadow(undefined);
    this.surface = surface;
    if (surface) {
      this.scene.add(surface.object);
      surface.setPixelRatio(this.renderer.getPixelRatio());
      this.resetView();
    }
    this.invalidate();
  }

  setShadow(shadow: GroundShadow | undefined): void {
    this.shadow?.dispose();
    this.shadow = shadow;
    if (shadow) this.scene.add(shadow.object);
    this.invalidate();
  }

  add(overlay: Overlay): void {
    overlay.setPixelRatio(this.renderer.getPixelRatio());
    this.overlays.add(overlay);
    this.onSurface.add(overlay.object);
    this.invalidate();
  }

  remove(overlay: Overlay): void {
    this.overlays.delete(overlay);
    overlay.dispose();
    this.invalidate();
  }

  /**
   * The canvas's size in CSS pixels, the height at its bottom to keep free of the surface, and the
   * screen's pixels per CSS pixel.
   */
  resize(width: number, height: number, bottom: number, pixelRatio: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.renderer.setPixelRatio(Math.min(2, pixelRatio));
    this.renderer.setSize(this.width, this.height, false);
    const ratio = this.renderer.getPixelRatio();
    this.surface?.setPixelRatio(ratio);
    for (const overlay of this.overlays) overlay.setPixelRatio(ratio);
    // The standard angle fits into the width and into the height that is left.
    const room = Math.max(0.4 * this.height, this.height - bottom);
    this.camera.aspect = this.width / this.height;
    this.camera.fov = fovFor(Math.min(this.width, room), this.height);
    const down = (this.height - room) / 2;
    this.camera.setViewOffset(this.width, this.height, 0, down, this.width, this.height);
    this.draw();
  }

  /** Nothing is drawn while resting, for example out of view. */
  rest(resting: boolean): void {
    this.resting = resting;
    if (!resting) this.invalidate();
  }

  /** Whether motion goes on after the hand has stopped. */
  setDamping(damping: boolean): void {
    this.controls.enableDamping = damping;
  }

  /** Turns slowly until touched. */
  set turning(turning: boolean) {
    this.turnsByItself = turning;
    this.controls.autoRotate = turning;
    this.invalidate();
  }

  get turning(): boolean {
    return this.turnsByItself;
  }

  /** Ends the turning. */
  touch(): void {
    if (this.turnsByItself) this.turning = false;
    this.events.touched();
  }

  /** Asks for a frame before long; many such requests share one. */
  invalidateSoon(): void {
    this.soon ??= setTimeout(
      () => {
        this.soon = undefined;
        this.invalidate();
      },
      Math.min(colourInterval[1], Math.max(colourInterval[0], this.frameCost / colourShare)),
    );
  }

  /** Asks for a frame. */
  invalidate(): void {
    this.dirty = true;
    this.schedule();
  }

  /** The point of the surface under a point of the window. */
  pick(clientX: number, clientY: number): FacePoint | undefined {
    if (!this.surface) return undefined;
    const box = this.canvas.getBoundingClientRect();
    const place = new Vector2(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
    );
    this.raycaster.setFromCamera(place, this.camera);
    return this.surface.pick(this.raycaster.ray);
  }

  project(point: Vector3): ScreenPoint {
    const { x, y, z } = point.clone().project(this.camera);
    const inside = Math.abs(x) <= 1 && Math.abs(y) <= 1 && z > -1 && z < 1;
    return {
      x: (0.5 + 0.5 * x) * this.width,
      y: (0.5 - 0.5 * y) * this.height,
      visible: inside && !this.surface?.hides(point, this.camera.position),
    };
  }

  /** Back to the standard direction and distance. */
  resetView(): void {
    const { surface } = this;
    if (!surface) return;
    this.flight = undefined;
    const { center, radius } = surface.bounds;
    const distance = (1.08 * radius) / Math.sin((viewingAngle * Math.PI) / 360);
    this.controls.target.copy(center);
    this.camera.position
      .setFromSphericalCoords(distance, (68 * Math.PI) / 180, (32 * Math.PI) / 180)
      .add(center);
    this.controls.minDistance = 0.15 * radius;
    this.controls.maxDistance = 4 * distance;
    this.controls.update();
    this.invalidate();
  }

  /** From where the surface is seen now; undefined where there is none. */
  get view(): CameraView | undefined {
    if (!this.surface) return undefined;
    const { center, radius } = this.surface.bounds;
    const { target } = this.controls;
    const arm = this.camera.position.clone().sub(target);
    const distance = arm.length();
    return {
      polar: Math.acos(Math.min(1, Math.max(-1, arm.y / distance))),
      azimuth: Math.atan2(arm.x, arm.z),
      distance: distance / radius,
      target: target.clone().sub(center).divideScalar(radius).toArray(),
    };
  }

  /** Looks from there at once; what lies beyond the limits of moving by hand is brought within. */
  lookFrom(view: CameraView): void {
    this.flight = undefined;
    this.touch();
    this.setView(view);
  }

  /** Moves to where a place is seen well: smoothly, or at once. */
  flyTo(place: Place, atOnce: boolean): void {
    const { view: from } = this;
    if (!from || place.points.length === 0) return;
    this.touch();
    const to = this.viewOf(place);
    this.flight = atOnce ? undefined : { from, to, begun: performance.now() };
    if (atOnce) this.setView(to);
    this.invalidate();
  }

  private setView({ polar, azimuth, distance, target }: CameraView): void {
    if (!this.surface) return;
    const { center, radius } = this.surface.bounds;
    this.controls.target.fromArray(target).clampLength(0, 4).multiplyScalar(radius).add(center);
    const { minDistance, maxDistance } = this.controls;
    const length = Math.min(maxDistance, Math.max(minDistance, distance * radius));
    this.camera.position
      .setFromSphericalCoords(length, Math.min(Math.PI - 0.01, Math.max(0.01, polar)), azimuth)
      .add(this.controls.target);
    this.controls.update();
    this.invalidate();
  }

  /** From where a place is seen well, with what is round it. */
  private viewOf({ points, outwards }: Place): CameraView {
    const surface = this.surface!;
    const { center, radius } = surface.bounds;
    const ball = new Sphere().setFromPoints([...points]);
    const reach = Math.min(radius, Math.max(1.35 * ball.radius, leastReach * radius));
    const distance = (1.08 * reach) / Math.sin((viewingAngle * Math.PI) / 360);
    const step = Math.max(1, Math.floor(points.length / sightings));
    const looked = points.filter((_, i) => i % step === 0);
    const seen = (direction: Vector3): number => {
      const eye = ball.center.clone().addScaledVector(direction, distance);
      return looked.filter((point) => !surface.hides(point, eye)).length / looked.length;
    };
    const present = this.camera.position.clone().sub(this.controls.target).normalize();
    const { x, y, z } = bestDirection(present, outwards, seen);
    return {
      polar: Math.acos(Math.min(1, Math.max(-1, y))),
      azimuth: Math.atan2(x, z),
      distance: distance / radius,
      target: ball.center.sub(center).divideScalar(radius).toArray(),
    };
  }

  /** Turns the camera about the surface, to the right and up, in radians. */
  orbit(right: number, up: number): void {
    this.flight = undefined;
    this.touch();
    const arm = this.camera.position.clone().sub(this.controls.target);
    const radius = arm.length();
    const polar = Math.acos(Math.min(1, Math.max(-1, arm.y / radius))) - up;
    const azimuth = Math.atan2(arm.x, arm.z) + right;
    arm.setFromSphericalCoords(radius, Math.min(Math.PI - 0.01, Math.max(0.01, polar)), azimuth);
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
    this.invalidate();
  }

  /** Multiplies the distance to the surface. */
  zoom(factor: number): void {
    this.flight = undefined;
    this.touch();
    const arm = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    arm.clampLength(this.controls.minDistance, this.controls.maxDistance);
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
    this.invalidate();
  }

  /** The picture as it is now, transparent where nothing is. */
  picture(): HTMLCanvasElement {
    this.draw();
    return this.copy();
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
    const { renderer, scene, surface } = this;
    if (!surface) throw new Error('no surface is shown');
    const [size, ratio] = [renderer.getSize(new Vector2()), renderer.getPixelRatio()];
    const camera = new PerspectiveCamera(fovFor(width, height), width / height);
    const view = this.viewOf(place);
    const { center, radius } = surface.bounds;
    const target = new Vector3().fromArray(view.target).multiplyScalar(radius).add(center);
    camera.position
      .setFromSphericalCoords(view.distance * radius, view.polar, view.azimuth)
      .add(target);
    camera.lookAt(target);
    this.onSurface.visible = false;
    if (this.shadow) this.shadow.object.visible = false;
    overlay?.setPixelRatio(1);
    if (overlay) scene.add(overlay.object);
    try {
      // Drawn and copied before the browser shows anything of it.
      renderer.setPixelRatio(1);
      renderer.setSize(width, height, false);
      surface.setPixelRatio(1);
      this.render(camera);
      return this.copy();
    } finally {
      overlay?.object.removeFromParent();
      this.onSurface.visible = true;
      if (this.shadow) this.shadow.object.visible = true;
      surface.setPixelRatio(ratio);
      renderer.setPixelRatio(ratio);
      renderer.setSize(size.x, size.y, false);
      this.draw();
    }
  }

  private copy(): HTMLCanvasElement {
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [this.canvas.width, this.canvas.height];
    copy.getContext('2d')!.drawImage(this.canvas, 0, 0);
    return copy;
  }

  dispose(): void {
    cancelAnimationFrame(this.requested);
    clearTimeout(this.soon);
    this.resting = true;
    for (const overlay of this.overlays) overlay.dispose();
    this.overlays.clear();
    this.show(undefined);
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private schedule(): void {
    if (this.requested || this.resting) return;
    this.requested = requestAnimationFrame((now) => this.frame(now));
  }

  private frame(now: number): void {
    this.requested = 0;
    const again = this.events.beforeFrame();
    this.fly(now);
    const elapsed = now - this.lastFrame;
    if (!this.dirty && this.turnsByItself && elapsed < turningInterval) {
      this.schedule();
      return;
    }
    this.dirty = false;
    this.lastFrame = now;
    // Reports 'change', which asks for the next frame, as long as the camera still moves.
    this.controls.update(Math.min(0.1, elapsed / 1000));
    const moving = this.dirty;
    if (this.moved && !moving && !this.flight) {
      this.moved = false;
      this.events.rested();
    }
    const begun = performance.now();
    this.draw();
    // A task of its own comes after the browser has composited what was drawn.
    setTimeout(() => (this.frameCost = 0.5 * (this.frameCost + performance.now() - begun)));
    this.dirty = moving && !this.turnsByItself;
    if (again) this.invalidate();
    else if (moving) this.schedule();
  }

  /** Goes on with a flight of the camera. */
  private fly(now: number): void {
    if (!this.flight) return;
    const { from, to, begun } = this.flight;
    const time = (now - begun) / flightTime;
    if (time >= 1) this.flight = undefined;
    this.setView(viewBetween(from, to, eased(time)));
  }

  private draw(): void {
    this.render(this.camera);
    this.events.afterFrame();
  }

  private render(camera: PerspectiveCamera): void {
    const { surface } = this;
    if (surface) {
      const { center, radius } = surface.bounds;
      const distance = camera.position.distanceTo(center);
      camera.near = Math.max(0.02 * radius, distance - 1.2 * radius);
      camera.far = distance + 3 * radius;
      camera.updateProjectionMatrix();
    }
    this.renderer.render(this.scene, camera);
  }
}

/** The vertical angle, in degrees, with which the standard angle fits into a width and the height. */
function fovFor(width: number, height: number): number {
  const half = Math.tan((viewingAngle * Math.PI) / 360);
  return (360 / Math.PI) * Math.atan((half * height) / Math.min(width, height));
}
