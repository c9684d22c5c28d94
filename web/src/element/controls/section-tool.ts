// A plane that cuts the surface: what the attribute asks for, and its menu on the bar. It is fetched when it is first
// needed. The element hands it what they share: a part that imported the element's modules would split them into many
// small files for every page.

import type { Stage, Surface } from '../../view/index.js';
import { sectionAcross } from '../../view/section-plane.js';
import type { button, icon } from './canvas-bar.js';
import type { make } from './dom.js';
import type { SectionWish } from '../attributes/section-words.js';

export interface SectionHost {
  stage(): Stage | undefined;
  /** The one that is cut. */
  surface(): Surface | undefined;
  /** A length in words. */
  lengthWords(length: number): string;
  /** The origin of the surface's coordinates in those of its file. */
  origin(): readonly number[];
  /** The section that the attribute asks for. */
  wished(): SectionWish | undefined;
  /** The root in which the tool is to be seen. */
  root: ShadowRoot;
  /** Makers of elements, buttons and icons. */
  kit: { make: typeof make; button: typeof button; icon: typeof icon };
  /** Sets the attribute; `isMoving`: the hand goes on. */
  choose(text: string | null, isMoving: boolean): void;
}

/** The style of the tool and its menu. */
const sectionStyle = /* css */ `
.tool > button.on { color: var(--girth-accent); }
.section { inline-size: 17rem; gap: 6px; }
.section .choices { display: flex; align-items: center; gap: 2px; }
.section .choices button { flex: 1 0 auto; justify-content: center; padding-inline: 9px; white-space: nowrap; }
.section button[aria-pressed='true'] { background: var(--girth-accent); color: var(--girth-paper); }
.section button:disabled { opacity: 0.45; cursor: default; }
.section output { flex: 1 1 auto; padding-inline-start: 8px; font-variant-numeric: tabular-nums; }
.section input[type='range'] { inline-size: auto; block-size: 24px; margin-inline: 8px; }
/* Where there is little room it lies below the surface, not on it. */
@container (max-width: 520px) {
  .bar-tools:has(.section:not([hidden])) { inset: 10px; pointer-events: none; }
  .bar-tools:has(.section:not([hidden])) > * { pointer-events: auto; }
  .tool:has(> .section) { position: static; }
  .tool .section { inset: auto 0 0 0; inline-size: auto; grid-template-columns: 1fr auto; align-items: center; }
  .section > :first-child { grid-column: 1 / -1; }
}
`;

const shape = 'M4 6.5 10 3l6 3.5v7L10 17l-6-3.5zM2 10h16';

type Direction = SectionWish['direction'];

const axes = ['x', 'y', 'z'] as const;
/** The plane's place at first, as a share of the surface. */
const middle = 0.5;
/** Percent of a step of the slider. */
const step = 0.5;

export class SectionTool {
  readonly opener: HTMLButtonElement;
  readonly menu: HTMLElement;
  readonly #whole: HTMLButtonElement;
  readonly #axes: HTMLButtonElement[];
  readonly #seen: HTMLButtonElement;
  readonly #place: HTMLInputElement;
  readonly #words: HTMLOutputElement;
  readonly #flip: HTMLButtonElement;
  readonly #host: SectionHost;

  constructor(host: SectionHost) {
    this.#host = host;
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(sectionStyle);
    host.root.adoptedStyleSheets.push(sheet);
    const { make, button, icon } = host.kit;
    const choice = (text: string, words: string): HTMLButtonElement =>
      make('button', { type: 'button', 'aria-label': words, title: words }, text);
    this.opener = button('Section plane', icon(shape));
    this.menu = make('div', {
      class: 'menu plate section',
      role: 'group',
      'aria-label': 'Section plane',
      hidden: '',
    });
    this.#whole = choice('Whole', 'Whole surface, no section');
    this.#axes = axes.map((axis) => choice(axis, `Section across ${axis}`));
    this.#seen = choice('View', 'Section across the view');
    this.#place = make('input', {
      type: 'range',
      min: '0',
      max: '100',
      step: String(step),
      'aria-label': 'Place of the section',
    });
    this.#words = make('output');
    this.#flip = make('button', { type: 'button' }, 'Other side');
    this.#whole.addEventListener('click', () => host.choose(null, false));
    this.#axes.forEach((one, i) =>
      one.addEventListener('click', () => {
        const direction = axes.map((_, k) => (k === i ? 1 : 0)) as unknown as Direction;
        this.#cut({ direction, share: this.#wish?.share ?? middle });
      }),
    );
    this.#seen.addEventListener('click', () => {
      const direction = host.stage()?.towardsEye;
      if (direction) this.#cut({ direction, share: middle });
    });
    this.#flip.addEventListener('click', () => {
      const wish = this.#wish;
      if (!wish) return;
      const [x, y, z] = wish.direction;
      this.#cut({ direction: [-x, -y, -z], share: 1 - wish.share });
    });
    for (const type of ['input', 'change']) {
      this.#place.addEventListener(type, () => {
        const share = Number(this.#place.value) / 100;
        if (this.#wish) this.#cut({ ...this.#wish, share }, type === 'input');
      });
    }
    this.menu.append(
      make('div', { class: 'choices' }, this.#whole, ...this.#axes, this.#seen),
      this.#place,
      make('div', { class: 'choices' }, this.#words, this.#flip),
    );
  }

  /** Cuts the surface that is shown as the attribute asks for, and shows it on the menu. */
  update(): void {
    const wish = this.#wish;
    const surface = this.#host.surface();
    const plane = wish && surface && sectionAcross(surface, wish.direction, wish.share);
    this.#host.stage()?.cut(plane);
    const axis = wish && axisOf(wish.direction);
    const buttons = [this.#whole, ...this.#axes, this.#seen];
    const chosen = !wish ? this.#whole : axis === undefined ? this.#seen : this.#axes[axis];
    for (const one of buttons) one.setAttribute('aria-pressed', String(one === chosen));
    this.opener.classList.toggle('on', wish !== undefined);
    this.#place.disabled = this.#flip.disabled = !wish;
    this.#words.textContent = plane ? this.#wordsOf(wish, plane.offset) : '';
    this.#place.setAttribute('aria-valuetext', this.#words.textContent || 'no section');
    if (!wish) return;
    const percent = String(100 * wish.share);
    if (Number(this.#place.value) !== Number(percent)) this.#place.value = percent;
  }

  /** The place of the plane: 'x = 0.12 m' in the file's coordinates, or the share that is left. */
  #wordsOf({ direction, share }: SectionWish, offset: number): string {
    const axis = axisOf(direction);
    const percent = `${Number((100 * share).toFixed(1))}% left`;
    if (axis === undefined) return percent;
    const along = direction[axis] < 0 ? -offset : offset;
    const place = along + this.#host.origin()[axis]!;
    return `${axes[axis]} = ${this.#host.lengthWords(place)}`;
  }

  get #wish(): SectionWish | undefined {
    return this.#host.wished();
  }

  #cut(wish: SectionWish, isMoving = false): void {
    this.#host.choose(writeSection(wish), isMoving);
  }
}

/** The number of the axis that a direction is along; undefined for none. */
function axisOf(direction: Direction): 0 | 1 | 2 | undefined {
  const parts = ([0, 1, 2] as const).filter((i) => direction[i] !== 0);
  return parts.length === 1 ? parts[0] : undefined;
}

/**
 * A section as `parseSection` reads it; directions to four digits, shares to a tenth of a percent.
 */
export function writeSection({ direction, share }: SectionWish): string {
  const [axis, ...others] = direction.flatMap((part, i) => (part === 0 ? [] : [i]));
  const isAxis = others.length === 0 && Math.abs(direction[axis!]!) === 1;
  const words = isAxis
    ? (direction[axis!]! < 0 ? '-' : '') + axes[axis!]!
    : direction.map((part) => Number(part.toFixed(4)) + 0).join(',');
  return `${words} ${Number((100 * share).toFixed(1))}%`;
}
