// Elements of a page that are linked: all are seen from the same place, in radii of each surface, and those that wish for
// it share one range of colours. Fetched when an element asks for it.

import { type Stage, findLengthUnit } from '../view/index.js';
import type { Ends } from './colour-range.js';
import type { OwnRange } from './shading.js';

/** An element, as its link knows it. */
export interface LinkedElement {
  /** Undefined as long as nothing is shown. */
  stage(): Stage | undefined;
  /** Whether its colours span the range that others share with it. */
  sharesRange(): boolean;
  /** Shows its colours anew: the shared range may be another one. */
  refresh(): void;
}

/** The elements that are linked, by the names of their links. */
const links = new Map<string, Set<Link>>();

/** What an element has in common with others. */
export class Link {
  readonly #element: LinkedElement;
  #members = new Set<Link>();
  /** What the element's colours would span alone. */
  #own: OwnRange | undefined;

  constructor(element: LinkedElement) {
    this.#element = element;
  }

  /** Links the element with those of the same name, and with no others; '' for none. */
  join(name: string): void {
    const members = name === '' ? new Set<Link>() : (links.get(name) ?? new Set());
    if (members.has(this)) return;
    this.#leave();
    if (name !== '') links.set(name, members.add(this));
    this.#members = members;
    this.arrive();
    this.changeRange();
  }

  /** A model is shown: it is seen from where the others are, unless it alone is not seen as at first. */
  arrive(): void {
    const stage = this.#element.stage();
    if (!stage) return;
    stage.companions = () => this.#stages;
    const others = this.#stages;
    const leader = others.find(({ isHome }) => !isHome);
    if (leader) follow(stage, leader);
    else if (!stage.isHome) this.move();
    else if (others.length > 0) for (const one of [stage, ...others]) one.resetView();
  }

  /** The element is seen from elsewhere than before. */
  move(): void {
    const stage = this.#element.stage();
    if (stage) for (const other of this.#stages) follow(other, stage);
  }

  /** The range of a linked element may be another one. */
  changeRange(): void {
    for (const member of this.#members) member.#element.refresh();
  }

  /** The model is gone. */
  forget(): void {
    this.#own = undefined;
    this.changeRange();
  }

  /** The range that the element's colours span. */
  rangeFor(own: OwnRange): Ends {
    const isNew = JSON.stringify(own) !== JSON.stringify(this.#own);
    this.#own = own;
    if (!this.#element.sharesRange()) return own.ends;
    const sharing = [...this.#members].filter((one) => one.#element.sharesRange());
    // Not while this one's colours are in the making.
    if (isNew) queueMicrotask(() => sharing.forEach((one) => one.#refreshFor(this)));
    const all = sharing.flatMap((one) => one.#own ?? []);
    const chosen = all.find(({ isChosen }) => isChosen);
    const ends = (chosen ? [chosen] : all).flatMap((one) => endsIn(own, one));
    return ends.length > 0 ? [Math.min(...ends), Math.max(...ends)] : own.ends;
  }

  #refreshFor(other: Link): void {
    if (other !== this) this.#element.refresh();
  }

  /** Those of the others where there is something to be seen. */
  get #stages(): Stage[] {
    return [...this.#members].flatMap((one) => (one === this ? [] : (one.#element.stage() ?? [])));
  }

  #leave(): void {
    const others = this.#stages;
    this.#members.delete(this);
    this.changeRange();
    for (const [name, { size }] of links) if (size === 0) links.delete(name);
    this.#members = new Set();
    const own = this.#element.stage();
    // Of what is to be seen as a whole there is less.
    for (const stage of own ? [own, ...others] : others) if (stage.isHome) stage.resetView();
    this.#element.refresh();
  }
}

/** Looks at one surface from where another is seen. */
function follow(stage: Stage, leader: Stage): void {
  if (leader.isHome) stage.resetView();
  else if (leader.view) stage.lookFrom(leader.view);
}

/** A range in the unit of another one; none where they are of different things. */
function endsIn(wanted: OwnRange, { name, unit, ends }: OwnRange): number[] {
  if (name !== wanted.name) return [];
  const [from, to] = [findLengthUnit(unit), findLengthUnit(wanted.unit)];
  if (from && to) return ends.map((end) => (end * from.metres) / to.metres);
  return unit === wanted.unit || unit === '' || wanted.unit === '' ? [...ends] : [];
}
