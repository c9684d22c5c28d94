// The tips of one model on its stage: contours, tinted regions, apexes, and one that is selected.

import type { ContourLine, Tips } from '../../kernel/types/types.js';
import { type Stage, TipMarks } from '../../view/index.js';
import type { Model } from '../model/model.js';

/** Which tips are drawn on the surface. */
export interface TipsChoice {
  /** Whether any are. */
  shown: boolean;
  /** Hides tips and arcs that rise less, in model units. Default: none are hidden. */
  leastJump?: number;
  /** A tip's number in `Tips.tips`. */
  selected?: number;
}

/** A dash of an open line and its gap, in radii of the surface. */
const dash = 0.035;

export class TipsOnSurface {
  #marks: TipMarks | undefined;
  #shown: { all: Tips; choice: TipsChoice } | undefined;
  readonly #stage: Stage;
  readonly #model: Model;

  constructor(stage: Stage, model: Model) {
    this.#stage = stage;
    this.#model = model;
  }

  /** The tips that are drawn, and how; undefined for none. */
  get shown(): { all: Tips; choice: TipsChoice } | undefined {
    return this.#shown;
  }

  show(all: Tips, choice: TipsChoice): void {
    this.clear();
    const { tips, arcs } = all;
    const { leastJump = 0, selected } = choice;
    this.#shown = { all, choice };
    const { surface } = this.#model;
    const isShown = ({ jump }: { jump: number }): boolean => jump >= leastJump;
    const chosen = selected === undefined ? undefined : tips[selected];
    const others = tips.filter((tip) => tip !== chosen && isShown(tip));
    const linesOf = (some: readonly { contour: ContourLine[] }[]): ContourLine[] =>
      some.flatMap(({ contour }) => contour);
    const place = (vertex: number): number[] => surface.positionOf(vertex).toArray();
    this.#marks = new TipMarks({
      contours: linesOf(others),
      selected: linesOf(chosen ? [chosen] : []),
      arcs: arcs.filter(isShown).map(({ line }) => line),
      apexes: others.map(({ apex }) => place(apex)),
      selectedApex: chosen && place(chosen.apex),
      dash: dash * surface.bounds.radius,
    });
    this.#stage.add(this.#marks);
    surface.tint(
      others.map(({ vertices }) => vertices),
      chosen?.vertices,
    );
  }

  clear(): void {
    if (!this.#marks) return;
    this.#stage.remove(this.#marks);
    this.#marks = undefined;
    this.#shown = undefined;
    this.#model.surface.tint([], undefined);
    this.#stage.invalidate();
  }
}
