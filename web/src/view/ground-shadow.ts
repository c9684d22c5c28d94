// A soft shadow on the ground under a model: where it stands, at a glance.

import {
  DataTexture,
  LinearFilter,
  Mesh,
  PlaneGeometry,
  Quaternion,
  RedFormat,
  ShaderMaterial,
  UnsignedByteType,
  type Vector3,
} from 'three';
import type { Rotation } from './up-axis.js';

const cells = 96;

/**
 * The shadow of a surface that stands upright: faces splatted straight down onto a square grid, fainter the higher they are, and blurred.
 * `cells` by `cells` bytes, row by row along x, rows along z.
 */
export function* splatShadow(
  positions: Float32Array,
  indices: Uint32Array,
  centre: readonly [number, number],
  ground: number,
  halfWidth: number,
  height: number,
): Generator<void, Uint8Array> {
  let grid = new Float32Array(cells * cells);
  const scale = cells / (2 * halfWidth);
  // The face's corners on the grid; no garbage in the loop.
  const x = new Float64Array(3);
  const z = new Float64Array(3);
  for (let f = 0; f < indices.length; f += 3) {
    if (f % 768 === 0) yield;
    let level = 0;
    for (let k = 0; k < 3; ++k) {
      const v = 3 * indices[f + k]!;
      x[k] = (positions[v]! - centre[0]) * scale + 0.5 * cells;
      z[k] = (positions[v + 2]! - centre[1]) * scale + 0.5 * cells;
      level += positions[v + 1]! / 3;
    }
    const strength = Math.max(0, 1 - (level - ground) / (0.75 * height)) ** 2;
    if (strength <= 0) continue;
    const left = Math.max(0, Math.floor(Math.min(x[0]!, x[1]!, x[2]!)));
    const right = Math.min(cells - 1, Math.floor(Math.max(x[0]!, x[1]!, x[2]!)));
    const back = Math.max(0, Math.floor(Math.min(z[0]!, z[1]!, z[2]!)));
    const front = Math.min(cells - 1, Math.floor(Math.max(z[0]!, z[1]!, z[2]!)));
    const area = (x[1]! - x[0]!) * (z[2]! - z[0]!) - (x[2]! - x[0]!) * (z[1]! - z[0]!);
    for (let j = back; j <= front; ++j) {
      for (let i = left; i <= right; ++i) {
        let inside = true;
        // Small faces count wherever they touch; large ones where they cover the cell's middle.
        for (let k = 0; k < 3 && Math.abs(area) > 4; ++k) {
          const n = (k + 1) % 3;
          const side = (x[n]! - x[k]!) * (j + 0.5 - z[k]!) - (z[n]! - z[k]!) * (i + 0.5 - x[k]!);
          if (side * area < 0) inside = false;
        }
        if (inside) grid[j * cells + i] = Math.max(grid[j * cells + i]!, strength);
      }
    }
  }
  for (let pass = 0; pass < 3; ++pass) {
    grid = blurRows(grid);
    yield;
    grid = blurRows(grid);
    yield;
  }
  return Uint8Array.from(grid, (value) => Math.min(255, 255 * value));
}

/** Running mean along each row, written transposed: twice gives both directions. */
function blurRows(grid: Float32Array): Float32Array<ArrayBuffer> {
  const radius = 3;
  const blurred = new Float32Array(grid.length);
  for (let row = 0; row < cells; ++row) {
    let sum = 0;
    for (let i = -radius; i < cells; ++i) {
      if (i + radius < cells) sum += grid[row * cells + i + radius]!;
      if (i - radius - 1 >= 0) sum -= grid[row * cells + i - radius - 1]!;
      if (i >= 0) blurred[i * cells + row] = sum / (2 * radius + 1);
    }
  }
  return blurred;
}

export class GroundShadow {
  readonly object: Mesh<PlaneGeometry, ShaderMaterial>;
  readonly #texture: DataTexture;

  /** `centre` is above or below the middle, on the ground, upright; the shadow's own coordinates are the surface's. */
  constructor(grid: Uint8Array, centre: Vector3, upright: Rotation, halfWidth: number) {
    this.#texture = new DataTexture(grid, cells, cells, RedFormat, UnsignedByteType);
    this.#texture.minFilter = this.#texture.magFilter = LinearFilter;
    this.#texture.needsUpdate = true;
    const plane = new PlaneGeometry(2 * halfWidth, 2 * halfWidth);
    // The grid's rows run along z: lie the plane down so that its v axis does too.
    plane.rotateX(-Math.PI / 2);
    this.object = new Mesh(
      plane,
      new ShaderMaterial({
        transparent: true,
        depthWrite: false,
        uniforms: { grid: { value: this.#texture } },
        vertexShader: /* glsl */ `
          varying vec2 vPlace;
          void main() {
            vPlace = vec2(uv.x, 1.0 - uv.y);
            gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
          }
        `,
        fragmentShader: /* glsl */ `
          uniform sampler2D grid;
          varying vec2 vPlace;
          void main() {
            gl_FragColor = vec4(0.0, 0.0, 0.02, 0.34 * texture2D(grid, vPlace).r);
          }
        `,
      }),
    );
    const back = new Quaternion().copy(upright).invert();
    this.object.position.copy(centre).applyQuaternion(back);
    this.object.quaternion.copy(back);
    this.object.renderOrder = -1;
  }

  dispose(): void {
    this.#texture.dispose();
    this.object.geometry.dispose();
    this.object.material.dispose();
    this.object.removeFromParent();
  }
}
