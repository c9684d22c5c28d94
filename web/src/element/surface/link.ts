// Links between elements of a page: elements of one name are seen from the same place, or span one
// range of colours. The place is in radii of each surface. The module is fetched when an element
// asks for it.

import { findLengthUnit } from '../../kernel/types/length-units.js';
import { type CameraView, type Stage, isSameView } from '../../view/index.js';
import type { Ends } from './colour-range.js';
import type { OwnRange } from './shading.js';

/** Groups of members, each of one name. */
class Groups<Member> {
  readonly #names = new Map<Member, string>();

  /** Takes a member into the group of a name, '' for none; returns whether it was not there before. */
  join(member: Member, name: string): boolean {
    if ((this.#names.get(member) ?? '') === name) return false;
    this.#names.delete(member);
    if (name !== '') this.#names.set(member, name);
    return true;
  }

  /** All that a member belongs together with, itself included, in the order in which they came; none where it is in no group. */
  of(member: Member): Member[] {
    const name = this.#names.get(member);
    if (name === undefined) return [];
    return [...this.#names].flatMap(([one, its]) => (its === name ? [one] : []));
  }
}

const views = new Groups<LinkedView>();
const ranges = new Groups<SharedRange>();

/** The view of an element, which others take over. */
export class LinkedView {
  readonly #stageOf: () => Stage | undefined;
  /** The view that was taken over when another element was followed last. */
  #followed: CameraView | undefined;

  /** `stage`: undefined as long as nothing is shown. */
  constructor(stage: () => Stage | undefined) {
    this.#stageOf = stage;
  }

  /** Links the element with those of the same name, and with no others; '' for none. */
  join(name: string): void {
    const before = this.#others;
    if (!views.join(this, name)) return;
    const own = this.#stageOf();
    // The models that must fit into the view together have become fewer.
    for (const stage of own ? [own, ...before] : before) stage.refit();
    this.arrive();
  }

  /** A model is shown: it is seen from where the others are, unless it alone is not seen as at first. */
  arrive(): void {
    const stage = this.#stageOf();
    if (!stage) return;
    stage.companions = () => this.#others;
    const others = this.#others;
    const leader = others.find(({ isHome }) => !isHome);
    if (leader) {
      // The leader fits its view to one more surface.
      leader.refit();
      this.#follow(leader);
    } else if (!stage.isHome) this.move();
    else if (others.length > 0) for (const one of [stage, ...others]) one.resetView();
  }

  /** The element is seen from elsewhere than before. */
  move(): void {
    const stage = this.#stageOf();
    if (!stage) return;
    // An element that has only followed has no news for its leader, which may have gone on since.
    if (this.#followed && stage.view && isSameView(this.#followed, stage.view)) return;
    this.#followed = undefined;
    for (const one of views.of(this)) if (one !== this) one.#follow(stage);
  }

  /** Looks at its surface from where another is seen. */
  #follow(leader: Stage): void {
    const stage = this.#stageOf();
    if (!stage) return;
    if (leader.isHome) stage.resetView();
    else if (leader.view) stage.lookFrom(leader.view);
    this.#followed = stage.view;
  }

  /** The stages of the others, where there is something to be seen. */
  get #others(): Stage[] {
    return views.of(this).flatMap((one) => (one === this ? [] : (one.#stageOf() ?? [])));
  }
}

/** The range that an element's colours span, which others' span, too. */
export class SharedRange {
  /** The range that the element's colours would span alone. */
  #own: OwnRange | undefined;
  readonly #refresh: () => void;

  /** `refresh` shows the element's colours anew: the range may be another one. */
  constructor(refresh: () => void) {
    this.#refresh = refresh;
  }

  /** Lets the element share its range with those of the same name, and with no others; '' for none. */
  join(name: string): void {
    const before = ranges.of(this);
    if (!ranges.join(this, name)) return;
    for (const one of new Set([this, ...before, ...ranges.of(this)])) one.#refresh();
  }

  /** The model is gone. */
  forget(): void {
    this.#own = undefined;
    for (const one of ranges.of(this)) one.#refresh();
  }

  /** The range for colours that would span this one alone. */
  of(own: OwnRange): Ends {
    const isNew = JSON.stringify(own) !== JSON.stringify(this.#own);
    this.#own = own;
    const sharing = ranges.of(this);
    const others = sharing.filter((one) => one !== this);
    // Not while this one's colours are in the making.
    if (isNew) queueMicrotask(() => others.forEach((one) => one.#refresh()));
    const all = sharing.flatMap((one) => one.#own ?? []).filter(({ name }) => name === own.name);
    const chosen = all.find(({ isChosen }) => isChosen);
    const ends = (chosen ? [chosen] : all).flatMap((one) => endsIn(own.unit, one));
    return ends.length > 0 ? [Math.min(...ends), Math.max(...ends)] : own.ends;
  }
}

/** A range in another unit; none where the two cannot be compared. */
function endsIn(wanted: string, { unit, ends }: OwnRange): number[] {
  const [from, to] = [findLengthUnit(unit), findLengthUnit(wanted)];
  if (from && to) return ends.map((end) => (end * from.metres) / to.metres);
  return unit === wanted || unit === '' || wanted === '' ? [...ends] : [];
}
