// The tips of the shape: a list, the lines on the surface, and what noise may have made.

import { type GirthViewer, formatLength, make } from '../../../src/element/index.js';
import type { Tips } from '../../../src/kernel/index.js';
import type { Store } from '../../state/store.js';
import { formatArea } from '../../widgets/area-words.js';
import { Draft } from '../../widgets/draft.js';
import { failureWords } from '../../widgets/failure-words.js';
import { plural } from '../../model/model-words.js';
import { Panel } from '../../widgets/panel.js';
import { PlaceList } from '../../widgets/place-list.js';
import { term } from '../../help/term.js';
import { Resource, type Status } from '../../results/resource.js';
import { TipRivals } from './tip-rivals.js';

const steps = 200;

/** The page, as far as the panel needs it. */
export interface TipsPage {
  /** The tips are known. */
  found(): void;
  /** Colours the surface by shape diameter, beside the tips, or as before. */
  colour(bySdf: boolean): void;
}

export class TipsPanel {
  readonly panel = new Panel('tips-panel');
  readonly #list = new PlaceList('Tips');
  readonly #arcs = new PlaceList('Other lines');
  readonly #arcsTitle = make('h3');
  readonly #results = make('div', { class: 'results' });
  readonly #shown = make('input', { id: 'tips-shown', type: 'checkbox' });
  readonly #jump = make('input', {
    id: 'tips-jump',
    type: 'range',
    min: '0',
    max: String(steps),
    value: '0',
  });
  readonly #jumpDraft: Draft;
  readonly #jumpText = make('output', { for: 'tips-jump' });
  readonly #rivals: TipRivals;
  readonly #words = make('p', { id: 'tips-words', class: 'hint', role: 'status' });
  /** How far the girth rises at the tip that each vertex is in, 0 elsewhere. */
  rises: Float64Array | undefined;
  readonly #tips: Resource<Tips>;
  #selected: number | undefined;
  readonly #viewer: GirthViewer;
  readonly #store: Store;
  readonly #page: TipsPage;

  constructor(viewer: GirthViewer, store: Store, page: TipsPage) {
    this.#viewer = viewer;
    this.#store = store;
    this.#page = page;
    this.#shown.checked = true;
    this.#rivals = new TipRivals(viewer, page);
    this.#tips = new Resource<Tips>({
      find: () => viewer.tips(),
      changed: (status) => this.#changed(status),
    });
    this.#results.append(
      this.#words,
      this.#list.element,
      this.#arcsTitle,
      make('p', { class: 'hint' }, 'Here the girth jumps, but nothing is cut off.'),
      this.#arcs.element,
    );
    this.panel.body.append(
      make(
        'p',
        { class: 'hint' },
        'A ',
        term('tip', 'tip'),
        ' is a part that a jump of the ',
        term('girth', 'girth'),
        ' cuts off.',
      ),
      this.#results,
      make('label', { class: 'check' }, this.#shown, ' Show them on the surface'),
      make(
        'div',
        { class: 'slide' },
        make('label', { for: 'tips-jump' }, 'Tips that rise by at least'),
        this.#jumpText,
        this.#jump,
      ),
      this.#rivals.element,
    );
    this.#shown.addEventListener('change', () => this.#draw());
    this.#jumpDraft = new Draft(this.#jump, {
      edited: () => {
        this.#refresh();
        this.#draw();
      },
      committed: () => store.choose({ jump: this.#leastJump }),
    });
    store.watch(['tip', 'jump'], () => this.#follow());
    this.panel.onToggle((isOpen) => {
      this.#draw();
      if (isOpen) this.compute();
      else this.#rivals.clear(this.#tips.found?.tips.length ?? 0);
    });
    viewer.addEventListener('unit', () => this.#refresh());
    this.clear();
  }

  /** Another model. */
  clear(): void {
    this.#tips.drop();
    this.#selected = undefined;
    this.#jumpDraft.discard();
    this.#jumpDraft.show('0');
    this.#rivals.clear(0);
    this.#refresh();
  }

  /** Shows the tip and the threshold of the state. */
  #follow(): void {
    const { tip, jump = 0 } = this.#store.shown;
    if (!this.#tips.found) {
      if (this.panel.isOpen) this.compute();
    } else if (tip !== this.#chosen || jump !== this.#leastJump) this.#show(tip !== this.#chosen);
  }

  /** Finds the tips of the girth that is shown, once that is there. */
  compute(): void {
    const { info } = this.#viewer;
    const { persistence, method } = this.#store.shown;
    if (info) this.#tips.want([info, persistence, method]);
  }

  #changed(status: Status<Tips>): void {
    this.rises = undefined;
    if (status.is === 'done') {
      const { tips, arcs } = status.found;
      // The title of the lines and its explanation are as high as two of them.
      const rows = tips.length + (arcs.length > 0 ? arcs.length + 2 : 0);
      this.#results.style.setProperty('--rows', String(rows));
      this.rises = new Float64Array(this.#viewer.info!.vertexCount);
      // The largest last: a vertex in several tips has the rise of the highest.
      for (const { vertices, jump } of [...tips].reverse()) {
        for (const vertex of vertices) this.rises[vertex] = jump;
      }
      this.#show(false);
      this.#rivals.expect(tips.length);
      this.#page.found();
      return;
    }
    this.#refresh();
    if (status.is === 'pending')
      this.#words.textContent = 'Tips follow as soon as the girth is computed …';
    if (status.is === 'failed') this.#words.textContent = `No tips: ${failureWords(status.error)}.`;
  }

  /** The number of the selected tip, from 1. */
  get #chosen(): number | undefined {
    return this.#selected === undefined ? undefined : this.#selected + 1;
  }

  #show(fly: boolean): void {
    const { tip, jump = 0 } = this.#store.shown;
    const { tips } = this.#tips.found!;
    this.#jumpDraft.show(String(this.#highest > 0 ? Math.ceil((steps * jump) / this.#highest) : 0));
    this.#selected = tip !== undefined && tip >= 1 && tip <= tips.length ? tip - 1 : undefined;
    // A tip that the surface does not have is none.
    if (tip !== this.#chosen) this.#store.choose({ tip: undefined });
    this.#refresh();
    this.#draw();
    if (fly && this.#selected !== undefined) {
      this.#viewer.flyTo({ vertices: tips[this.#selected]!.vertices });
    }
  }

  get #highest(): number {
    const { found } = this.#tips;
    return Math.max(0, ...[...(found?.tips ?? []), ...(found?.arcs ?? [])].map(({ jump }) => jump));
  }

  get #leastJump(): number {
    // This order of operations makes the end of the slider the highest jump to the last bit.
    return this.#highest * (Number(this.#jumpDraft.text) / steps);
  }

  #choose(number: number): void {
    const tip = this.#tips.found!.tips[number]!;
    this.#selected = number;
    this.#draw();
    this.#viewer.flyTo({ vertices: tip.vertices });
    this.#store.choose({ tip: number + 1 });
  }

  #refresh(): void {
    const [made, viewer] = [this.#tips.found, this.#viewer];
    const { panel } = this;
    const format = viewer.lengthFormat;
    const leastJump = this.#leastJump;
    const tips = (made?.tips ?? []).map((tip, number) => ({ tip, number }));
    const kept = tips.filter(({ tip }) => tip.jump >= leastJump);
    const arcs = (made?.arcs ?? []).filter(({ jump }) => jump >= leastJump);
    const hidden = tips.length - kept.length;
    panel.summary = made ? String(kept.length) : '';
    this.#jump.disabled = !made || this.#highest === 0;
    this.#jumpText.textContent = made ? formatLength(leastJump, format) : '';
    this.#jump.setAttribute('aria-valuetext', this.#jumpText.textContent);
    this.#list.show(
      kept.map(({ tip, number }) => ({
        lead: String(number + 1),
        main: `rises by ${formatLength(tip.jump, format)}`,
        detail: `length ${formatLength(tip.apexDistance, format)} · area ${formatArea(tip.area, format)}`,
        choose: () => this.#choose(number),
      })),
    );
    const chosen = kept.findIndex(({ number }) => number === this.#selected);
    this.#list.select(chosen < 0 ? undefined : chosen);
    this.#arcsTitle.textContent =
      arcs.length === 1 ? 'One line cuts no tip off' : `${arcs.length} lines cut no tip off`;
    const openPart = [this.#arcsTitle, this.#arcsTitle.nextElementSibling as HTMLElement];
    for (const part of openPart) part.hidden = arcs.length === 0;
    this.#arcs.show(
      arcs.map(({ line, length, jump }) => ({
        main: `rises by ${formatLength(jump, format)}`,
        detail: `${line.closed ? 'closed' : 'open'} line · ${length > 0 ? `length ${formatLength(length, format)}` : 'across one edge'}`,
        choose: () => viewer.flyTo({ polyline: line.polyline }),
      })),
    );
    if (!made) {
      this.#words.textContent = '';
      return;
    }
    const words = tips.length === 0 ? 'No jump of the girth cuts a part off: no tips.' : '';
    this.#words.textContent =
      hidden > 0
        ? `${plural(hidden, 'tip rises', 'tips rise')} by less and ${hidden === 1 ? 'is' : 'are'} hidden.`
        : words;
  }

  /** Lines and tints on the surface, while the panel is open. */
  #draw(): void {
    const [tips, viewer, selected] = [this.#tips.found, this.#viewer, this.#selected];
    if (!tips) return;
    const shown = this.panel.isOpen && this.#shown.checked;
    void viewer.showTips({
      shown,
      leastJump: this.#leastJump,
      ...(selected === undefined ? {} : { selected }),
    });
  }
}
