// How a model stands on the stage: its way up, and the shadow under it.

import { type Stage, type UpAxis, isUpName, rotationUp, upAxisOf } from '../view/index.js';
import { groundUnder } from './ground.js';
import type { Model } from './model.js';

export class Standing {
  readonly #stage: Stage;
  readonly #model: Model;
  /** The way up that fits the model. */
  readonly fitting: UpAxis;
  #axis: UpAxis;
  #shadowing = new AbortController();
  #hasShadow = false;

  /** Turns a model that is on the stage upright: as wished, or as fits it. */
  constructor(stage: Stage, model: Model, wished: string | null) {
    this.#stage = stage;
    this.#model = model;
    this.fitting = this.#axisFor(null);
    this.#axis = this.#stand(wished);
  }

  /** Which way is up. */
  get axis(): UpAxis {
    return this.#axis;
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

  #axisFor(wished: string | null): UpAxis {
    const { info, geometry } = this.#model.mesh;
    return upAxisOf(wished, info.format, geometry.positions, geometry.indices);
  }

  #stand(wished: string | null): UpAxis {
    const axis = isUpName(wished) ? this.#axisFor(wished) : this.fitting;
    this.#stage.stand(rotationUp(axis.direction));
    return axis;
  }
}
