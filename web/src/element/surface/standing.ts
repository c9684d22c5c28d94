// The stand of a model on the stage: its way up, and the shadow under it.

import { type Stage, type UpAxis, isUpName, rotationUp, upAxisOf } from '../../view/index.js';
import { groundUnder } from './ground.js';
import type { Model } from '../model/model.js';

export class Standing {
  readonly #stage: Stage;
  readonly #model: Model;
  #axis: UpAxis;
  #measured: { axis: UpAxis; height: number } | undefined;
  #shadowing = new AbortController();
  #hasShadow = false;

  /** Turns a model that is on the stage upright: as wished, or as fits it. */
  constructor(stage: Stage, model: Model, wished: string | null) {
    this.#stage = stage;
    this.#model = model;
    this.#axis = this.#stand(wished);
  }

  /** The way up that fits the model. */
  get fitting(): UpAxis {
    return this.#model.fitting;
  }

  /** Which way is up. */
  get axis(): UpAxis {
    return this.#axis;
  }

  /** The model's extent upwards, in model units. */
  get height(): number {
    if (this.#measured?.axis === this.#axis) return this.#measured.height;
    const height = this.#heightAlong(this.#axis.direction);
    this.#measured = { axis: this.#axis, height };
    return height;
  }

  #heightAlong(direction: UpAxis['direction']): number {
    const { info, geometry } = this.#model.mesh;
    const axis = direction.findIndex((share) => Math.abs(share) === 1);
    if (axis >= 0) return info.size[axis]!;
    const { positions } = geometry;
    const [x, y, z] = direction;
    let [low, high] = [Infinity, -Infinity];
    for (let i = 0; i < positions.length; i += 3) {
      const above = x * positions[i]! + y * positions[i + 1]! + z * positions[i + 2]!;
      if (above < low) low = above;
      if (above > high) high = above;
    }
    return high - low;
  }

  /** Another way up is wished for; null: that which fits the model. */
  set wished(wished: string | null) {
    this.#axis = this.#stand(wished);
    if (this.#hasShadow) void this.castShadow();
  }

  /** Draws the shadow; again after each change of the way up. */
  async castShadow(): Promise<void> {
    const [stage, { mesh, surface }] = [this.#stage, this.#model];
    this.#shadowing.abort();
    this.#shadowing = new AbortController();
    const { signal } = this.#shadowing;
    this.#hasShadow = true;
    try {
      const shadow = await groundUnder(mesh, surface, stage.upright, signal);
      await stage.prepare(shadow.object);
      if (!signal.aborted) stage.setShadow(shadow);
    } catch (error) {
      // A newer one, or none any more.
      if (!signal.aborted) throw error;
    }
  }

  dispose(): void {
    this.#shadowing.abort();
  }

  #stand(wished: string | null): UpAxis {
    const { info, geometry } = this.#model.mesh;
    const axis = isUpName(wished)
      ? upAxisOf(wished, info.format, geometry.positions, geometry.indices)
      : this.fitting;
    this.#stage.stand(rotationUp(axis.direction));
    return axis;
  }
}
