// The camera and what moves it: a hand, a key, a flight to a place, the slow turning.

import { PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { eased, viewBetween } from './camera-flight.js';
import {
  type CameraView,
  anglesOf,
  fovFor,
  isSameView,
  keptFromPoles,
  viewingAngle,
  wholeDistance,
} from './camera-view.js';
import type { Room } from './fitted-view.js';
import type { Motion } from './frame-scheduler.js';

/** Motion since the last frame that nobody sees, as a share of the camera's distance: under 0.05 pixels. */
const unseenPace = 2e-5;
/** Motion that is none but rounding. */
const roundingPace = 1e-12;
/** Milliseconds of a flight of the camera. */
const flightTime = 700;
/** The camera looks at nothing farther from the middle of the surface, in radii of the surface. */
const farthestTarget = 4;

export interface RigEvents {
  /** The camera stands elsewhere: a frame is to be drawn. */
  changed(): void;
  /** A hand may have moved it: a frame is to be looked at. */
  stirred(): void;
  /** The surface was touched: it is moved by hand, or pointed at. */
  touched(): void;
  /** The camera stands elsewhere than in the last frame; before this one is drawn. */
  moved(): void;
  /** The camera was moved and has come to rest. */
  rested(): void;
}

/** A place of a camera, to the last bit. */
class Standpoint {
  readonly position = new Vector3();
  readonly quaternion = new Quaternion();
  readonly target = new Vector3();

  take(camera: PerspectiveCamera, target: Vector3): void {
    this.position.copy(camera.position);
    this.quaternion.copy(camera.quaternion);
    this.target.copy(target);
  }

  isAt(camera: PerspectiveCamera, target: Vector3): boolean {
    const { position, quaternion } = camera;
    return (
      this.position.equals(position) &&
      this.quaternion.equals(quaternion) &&
      this.target.equals(target)
    );
  }
}

export class CameraRig {
  readonly camera = new PerspectiveCamera(viewingAngle, 1, 0.01, 100);
  readonly #controls: OrbitControls;
  readonly #events: RigEvents;
  #turnsByItself = false;
  /** The cause of the camera's motion since `reset`. */
  #movedBy: 'nothing' | 'turning' | 'others' = 'others';
  #room: Room = { across: 1, up: 1 };
  /** Whether the camera was moved since it last came to rest. */
  #moved = false;
  /** Whether a hand holds the surface. */
  #held = false;
  /** Whether a hand's motion, or the turning's, may still fade away. */
  #drifting = false;
  #flight: { from: CameraView; to: CameraView; begun: number } | undefined;
  /** Where the camera was for the last frame. */
  readonly #drawnFrom = new Standpoint();
  /** Where it was when its motion was last reported. */
  readonly #reported = new Standpoint();

  constructor(canvas: HTMLCanvasElement, events: RigEvents) {
    this.#events = events;
    this.#controls = new OrbitControls(this.camera, canvas);
    this.#controls.enableDamping = true;
    this.#controls.dampingFactor = 0.14;
    this.#controls.rotateSpeed = 0.9;
    this.#controls.autoRotateSpeed = 1.1;
    this.#controls.minDistance = 0.15;
    this.#controls.maxDistance = 4 * wholeDistance;
    this.#controls.addEventListener('start', () => {
      this.#flight = undefined;
      this.#movedBy = 'others';
      this.#held = this.#drifting = true;
      this.touch();
    });
    this.#controls.addEventListener('end', () => {
      this.#held = false;
      events.stirred();
    });
    // The controls report no motion that is small to them, though it may be seen where the surface is near.
    canvas.addEventListener('pointermove', () => {
      if (this.#held) events.stirred();
    });
    this.#controls.addEventListener('change', () => {
      this.#moved ||= !this.#turnsByItself;
      events.changed();
    });
  }

  /** Whether motion goes on after the hand has stopped. */
  set damping(damping: boolean) {
    this.#controls.enableDamping = damping;
  }

  /** Turns slowly until touched. */
  set turning(turning: boolean) {
    this.#drifting ||= this.#turnsByItself;
    this.#turnsByItself = turning;
    this.#controls.autoRotate = turning;
    this.#events.changed();
  }

  get turning(): boolean {
    return this.#turnsByItself;
  }

  /** Ends the turning. */
  touch(): void {
    if (this.#turnsByItself) this.turning = false;
    this.#events.touched();
  }

  /** The canvas's size in CSS pixels, and the heights at its top and bottom to keep free of the surface. */
  fit(width: number, height: number, top: number, bottom: number): void {
    // The standard angle fits into the width and into the height that is left.
    const room = Math.max(0.4 * height, height - top - bottom);
    this.camera.aspect = width / height;
    this.camera.fov = fovFor(Math.min(width, room), height);
    // The middle of what is left is above or below that of the canvas.
    const down = (Math.min(height - room, bottom) - Math.min(height - room, top)) / 2;
    this.camera.setViewOffset(width, height, 0, down, width, height);
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    this.#room = { across: half * this.camera.aspect, up: (half * room) / height };
  }

  /** The room for the surface round the point that the camera looks at. */
  get room(): Room {
    return this.#room;
  }

  /** Whether nothing has moved the camera since `reset`. */
  get isHome(): boolean {
    return this.#movedBy === 'nothing';
  }

  /** Whether nothing but its turning has. */
  get hasOnlyTurned(): boolean {
    return this.#movedBy === 'turning';
  }

  /** From where it looks now. */
  get view(): CameraView {
    const { target } = this.#controls;
    const arm = this.#arm();
    return { ...anglesOf(arm), distance: arm.length(), target: target.toArray() };
  }

  /** The direction from what it looks at to the camera, of length 1. */
  get direction(): Vector3 {
    return this.#arm().normalize();
  }

  /** To the view where the camera begins. */
  reset(home: CameraView): void {
    this.#flight = undefined;
    this.#setView(home);
    this.#movedBy = 'nothing';
  }

  /** To a view from which the whole is seen, as far round as the camera has turned. */
  refit(whole: CameraView): void {
    this.#setView(whole);
    this.#movedBy = 'turning';
  }

  /**
   * Looks from there at once; what lies beyond the limits of moving by hand is brought within. Where it looks from there
   * already, whatever moves goes on.
   */
  lookFrom(view: CameraView): void {
    if (isSameView(view, this.view)) return;
    this.#flight = undefined;
    this.touch();
    this.#setView(view);
  }

  /** Moves there: smoothly, or at once. */
  flyTo(to: CameraView, atOnce: boolean): void {
    const from = this.view;
    this.touch();
    this.#flight = atOnce ? undefined : { from, to, begun: performance.now() };
    if (atOnce) this.#setView(to);
    this.#events.changed();
  }

  /** Turns the camera about the surface, to the right and up, in radians. */
  orbit(right: number, up: number): void {
    const arm = this.#arm();
    const { polar, azimuth } = anglesOf(arm);
    this.#take(
      arm.setFromSphericalCoords(arm.length(), keptFromPoles(polar - up), azimuth + right),
    );
  }

  /** Multiplies the distance to the surface. */
  zoom(factor: number): void {
    const { minDistance, maxDistance } = this.#controls;
    this.#take(this.#arm().multiplyScalar(factor).clampLength(minDistance, maxDistance));
  }

  /** Goes on with a flight; before each frame. Returns whether more of it is to come. */
  fly(now: number): boolean {
    if (!this.#flight) return false;
    const { from, to, begun } = this.#flight;
    const time = (now - begun) / flightTime;
    if (time >= 1) this.#flight = undefined;
    this.#setView(viewBetween(from, to, eased(time)));
    return time < 1;
  }

  /** Goes on with what a hand has begun, or with the turning, and reports when the camera is at rest. */
  advance(seconds: number): Motion {
    const motion = this.#steer(seconds);
    if (!this.#reported.isAt(this.camera, this.#controls.target)) {
      this.#reported.take(this.camera, this.#controls.target);
      this.#events.moved();
      // In the next frame it may be at rest.
      this.#events.stirred();
    } else if (this.#moved && motion !== 'more' && !this.#flight) {
      this.#moved = false;
      this.#events.rested();
    }
    return motion;
  }

  /** A frame was drawn from where the camera is. */
  drawn(): void {
    this.#drawnFrom.take(this.camera, this.#controls.target);
  }

  dispose(): void {
    this.#controls.dispose();
  }

  #arm(): Vector3 {
    return this.camera.position.clone().sub(this.#controls.target);
  }

  /** A key has moved the camera to the end of this arm. */
  #take(arm: Vector3): void {
    this.#flight = undefined;
    this.#movedBy = 'others';
    this.touch();
    this.camera.position.copy(this.#controls.target).add(arm);
    this.#controls.update();
    this.#events.changed();
  }

  #setView({ polar, azimuth, distance, target }: CameraView): void {
    this.#movedBy = 'others';
    // Nothing of what moved before may go on from there.
    this.#finishMotion();
    this.#controls.target.fromArray(target).clampLength(0, farthestTarget);
    this.camera.position
      .setFromSphericalCoords(distance, keptFromPoles(polar), azimuth)
      .clampLength(this.#controls.minDistance, this.#controls.maxDistance)
      .add(this.#controls.target);
    this.#controls.update();
    this.#events.changed();
  }

  /** A camera at rest keeps its place to the last bit: what is under a pointer stays under it. */
  #steer(seconds: number): Motion {
    if (!this.#drifting && !this.#turnsByItself) return 'none';
    const [controls, drawnFrom] = [this.#controls, this.#drawnFrom];
    const { camera } = this;
    controls.update(seconds);
    if (this.#turnsByItself) {
      if (this.isHome) this.#movedBy = 'turning';
      return 'more';
    }
    const moved =
      camera.position.distanceTo(drawnFrom.position) + controls.target.distanceTo(drawnFrom.target);
    const pace = moved / camera.position.distanceTo(controls.target);
    if (pace > unseenPace) {
      this.#moved = true;
      return 'more';
    }
    let motion: Motion = 'none';
    if (pace < roundingPace) {
      camera.position.copy(drawnFrom.position);
      camera.quaternion.copy(drawnFrom.quaternion);
      controls.target.copy(drawnFrom.target);
      // The controls have made the matrix anew as well, and what is picked next uses it.
      camera.updateMatrixWorld();
    } else if (!this.#held) {
      // Less than a pixel.
      this.#finishMotion();
      this.#moved = true;
      motion = 'last';
    }
    this.#drifting = this.#held;
    return motion;
  }

  /** Ends a motion at once, with the rest of its way. */
  #finishMotion(): void {
    const { enableDamping } = this.#controls;
    this.#controls.enableDamping = false;
    this.#controls.update();
    this.#controls.enableDamping = enableDamping;
  }
}
