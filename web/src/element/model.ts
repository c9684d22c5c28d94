// One model on the stage: its surface, and its field as far as it is computed.

import type { Field, Mesh, PartialField } from '../kernel/types.js';
import {
  FieldPreview,
  Surface,
  borrowedWeight,
  buildAdjacency,
  computedWeight,
  inSlices,
  splitCreases,
} from '../view/index.js';

/** Edges sharper than this stay visible as creases, in radians. */
const creaseAngle = (38 * Math.PI) / 180;
/** Milliseconds a frame may spend on spreading colours. */
const spreadBudget = 5;

export class Model {
  /** Set once the whole field is there. */
  field: Field | undefined;
  /** Aborted to cancel the field; set while it is computed. */
  computing: AbortController | undefined;
  /** Aborted when the model goes. */
  readonly life = new AbortController();

  private constructor(
    readonly mesh: Mesh,
    readonly surface: Surface,
    readonly preview: FieldPreview,
  ) {}

  /** Makes a mesh ready to draw, in slices of time. */
  static async of(mesh: Mesh, signal: AbortSignal): Promise<Model> {
    const { positions, indices, walls } = mesh.geometry;
    const adjacency = await inSlices(buildAdjacency(positions.length / 3, indices, walls), signal);
    const creased = await inSlices(splitCreases(positions, indices, creaseAngle), signal);
    const surface = new Surface(positions, indices, walls, adjacency, creased);
    return new Model(mesh, surface, new FieldPreview(adjacency));
  }

  /** The smallest and largest value there is; undefined before the first. */
  get extent(): [number, number] | undefined {
    return this.field?.range ?? this.preview.range;
  }

  /** The values there are, one per vertex; NaN where there is none yet. */
  get values(): Float64Array {
    return this.field?.values ?? this.preview.values;
  }

  /** Takes new values and colours their vertices. */
  receive(partial: PartialField): void {
    this.preview.receive(partial, (vertex) =>
      this.surface.setScalar(vertex, this.preview.shown[vertex]!, computedWeight),
    );
  }

  /** Spreads colours to vertices without a value, for a few milliseconds; true when all are done. */
  spread(): boolean {
    const { surface, preview } = this;
    const done = preview.spread(
      (vertex) => surface.setScalar(vertex, preview.shown[vertex]!, borrowedWeight),
      performance.now() + spreadBudget,
      () => performance.now(),
    );
    surface.uploadScalars();
    return done;
  }

  /** Colours every vertex anew. */
  paint(): void {
    const { surface, preview, field } = this;
    const shown = field?.values ?? preview.shown;
    for (let v = 0; v < shown.length; ++v) {
      const known = field || preview.isComputed(v) ? computedWeight : borrowedWeight;
      surface.setScalar(v, shown[v]!, Number.isNaN(shown[v]) ? 0 : known);
    }
    surface.uploadScalars();
  }

  /**
   * Ends all work on the model and lets go of its memory, but for the mesh where that is kept; the
   * stage disposes of the surface.
   */
  dispose(keepsMesh = false): void {
    this.computing?.abort();
    this.life.abort();
    if (!keepsMesh) this.mesh.dispose();
  }
}
