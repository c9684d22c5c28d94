// The sheet that opens from the model's line: what the file is, what was done to it, and what else
// can be done.

import type { MeshInfo, PrepareOptions } from '../../src/kernel/index.js';
import { type GirthViewer, formatCount, make, sentence } from '../../src/element/index.js';
import { modelFormats } from '../export/model-files.js';
import { saveFile, stemOf } from '../export/save-file.js';
import { byId } from '../widgets/dom.js';
import { Draft } from '../widgets/draft.js';
import { failureWords } from '../widgets/failure-words.js';
import { modelFacts, plural, repairs, sizeWords } from './model-words.js';
import { type ModelScale, SizeChoice } from './size-choice.js';
import { plainNumber } from '../widgets/table-text.js';

/** The largest components are offered, and no more than these. */
const mostParts = 100;

/** Actions on the model that is shown. */
export interface ModelActions {
  size: ModelScale;
  /** Opens another of the files that came together. */
  choose(model: string): void;
  /** Reads the file once more and prepares it otherwise. */
  prepare(change: Pick<PrepareOptions, 'closeHoles' | 'weldDistance' | 'components'>): void;
  remesh(faces: number): void;
  /** The model as its file has it. */
  back(): void;
}

/** The page's knowledge of the model, which the viewer does not have. */
export interface ModelState {
  prepare: PrepareOptions;
  /** The steps that made the surface after it was read; none where it is the file's. */
  made: readonly string[];
}

export class ModelDetails {
  readonly #sheet = byId('details');
  readonly #opener = byId<HTMLButtonElement>('details-open');
  readonly #line = byId('model');
  readonly #comparison = make('p', { class: 'hint', role: 'status' });
  readonly #size = make('span');
  readonly #done = make('div');
  readonly #choice: SizeChoice;
  #shown: { info: MeshInfo; state: ModelState } | undefined;
  readonly #viewer: GirthViewer;
  readonly #actions: ModelActions;

  constructor(viewer: GirthViewer, actions: ModelActions) {
    this.#viewer = viewer;
    this.#actions = actions;
    this.#choice = new SizeChoice('', viewer, actions.size);
    viewer.addEventListener('unit', () => this.#refresh());
  }

  show(info: MeshInfo, state: ModelState): void {
    const [name = '', ...rest] = modelFacts(info);
    this.#line.replaceChildren(make('b', {}, name), ` · ${rest.join(' · ')}`);
    this.#line.title = this.#line.textContent ?? '';
    this.#comparison.textContent = '';
    this.#shown = { info, state };
    const isRepaired = repairs(info.report, this.#viewer.lengthFormat).length > 0;
    this.#opener.textContent = isRepaired ? 'repaired' : 'details';
    this.#opener.hidden = false;
    this.#build(info, state);
    this.#refresh();
  }

  /** Says how far the field of a surface that was changed is from that before. */
  async compare(): Promise<void> {
    const shown = this.#shown;
    const difference = await this.#viewer.differenceToOriginal().catch(() => undefined);
    if (difference === undefined || shown !== this.#shown) return;
    const words = plainNumber(difference, 2);
    this.#comparison.textContent = `The distribution of its girth differs from that before by ${words} (equation 1 of the paper; no unit).`;
  }

  /** Another model, or the same one prepared otherwise: whatever was being changed is no longer meant. */
  #build(info: MeshInfo, state: ModelState): void {
    this.#choice.clear();
    this.#sheet.replaceChildren(
      make('h2', { id: 'details-title' }, info.name),
      this.#facts(info),
      this.#choice.element,
      ...this.#saving(info),
      this.#done,
      ...this.#models(info),
      ...this.#components(info, state),
      ...this.#changes(info, state),
    );
  }

  /** Writes anew what the unit changes; the controls stay as they are. */
  #refresh(): void {
    if (!this.#shown) return;
    const { info, state } = this.#shown;
    this.#size.textContent = sizeWords(info, this.#viewer.lengthFormat);
    this.#done.replaceChildren(...this.#whatWasDone(info, state));
  }

  #close(): void {
    this.#sheet.hidePopover();
  }

  #facts(info: MeshInfo): HTMLElement {
    const rows: [string, (Node | string)[]][] = [
      ['File', [info.format]],
      ['Size', [this.#size]],
      [
        'Surface',
        [`${formatCount(info.faceCount)} faces, ${formatCount(info.vertexCount)} vertices`],
      ],
    ];
    return make(
      'dl',
      {},
      ...rows.map(([term, words]) =>
        make('div', {}, make('dt', {}, term), make('dd', {}, ...words)),
      ),
    );
  }

  /** The model as a file: as it is shown now. */
  #saving({ name }: MeshInfo): HTMLElement[] {
    const said = make('p', { class: 'hint', role: 'status' });
    const buttons = Object.entries(modelFormats).map(([format, about]) => {
      const words = format.toUpperCase();
      const button = make('button', { type: 'button', class: 'plain', title: about }, words);
      button.addEventListener('click', () => {
        this.#viewer.exportModel(format as keyof typeof modelFormats).then(
          (content) => {
            said.textContent = '';
            saveFile(content, `${stemOf(name)}.${format}`);
          },
          (error: unknown) => (said.textContent = sentence(failureWords(error))),
        );
      });
      return button;
    });
    return [
      make('h3', {}, 'Save the model as it is shown'),
      make('p', { class: 'buttons' }, ...buttons),
      said,
    ];
  }

  #whatWasDone(info: MeshInfo, { made }: ModelState): HTMLElement[] {
    const done = repairs(info.report, this.#viewer.lengthFormat);
    for (const { model, error } of info.unreadable) {
      done.push(`${model} was passed over: ${error.message}`);
    }
    const lines = [...done, ...made, ...info.notes].map((line) => make('li', {}, sentence(line)));
    const nothing = make('p', { class: 'hint' }, 'Nothing: the file is a surface already.');
    return [
      make('h3', {}, 'What was done to the file'),
      lines.length > 0 ? make('ul', { class: 'done' }, ...lines) : nothing,
    ];
  }

  #models({ models, name }: MeshInfo): HTMLElement[] {
    if (models.length < 2) return [];
    const select = make(
      'select',
      { 'aria-label': 'Model' },
      ...models.map((path) => make('option', { value: path }, path)),
    );
    const chosen = models.find((path) => path === name || path.endsWith(`/${name}`));
    const draft = new Draft(select, {
      committed: (path) => {
        this.#close();
        this.#actions.choose(path);
      },
    });
    if (chosen !== undefined) draft.show(chosen);
    const title = `${formatCount(models.length)} models came together`;
    return [make('h3', {}, title), make('p', {}, select)];
  }

  #components({ parts }: MeshInfo, { prepare, made }: ModelState): HTMLElement[] {
    if (parts.length < 2 || made.length > 0) return [];
    const kept = new Set(prepare.components?.length ? prepare.components : parts.keys());
    const largest = [...parts.keys()].sort((a, b) => parts[b]!.area - parts[a]!.area);
    const whole = parts.reduce((sum, { area }) => sum + area, 0);
    const offered = largest.slice(0, mostParts);
    const boxes = offered.map((part) => {
      const box = make('input', { type: 'checkbox', value: String(part) });
      box.checked = kept.has(part);
      return box;
    });
    const rows = offered.map((part, i) => {
      const { faceCount, area } = parts[part]!;
      const share = whole > 0 ? (100 * area) / whole : 0;
      const percent = `${share < 1 ? '<\u202f1' : Math.round(share)}\u202f%`;
      const words = make('span', {}, `${percent} of the area`);
      return make(
        'li',
        {},
        make('label', {}, boxes[i]!, plural(faceCount, 'face', 'faces'), words),
      );
    });
    const apply = make('button', { type: 'button', class: 'plain' }, 'Keep these');
    const others = largest.slice(mostParts).filter((part) => kept.has(part));
    const wanted = (): number[] => {
      const ticked = offered.filter((_, i) => boxes[i]!.checked);
      return [...ticked, ...others].sort((a, b) => a - b);
    };
    const refresh = (): void => {
      const now = wanted();
      apply.disabled = now.length === 0 || now.join() === [...kept].sort((a, b) => a - b).join();
    };
    for (const box of boxes) box.addEventListener('change', refresh);
    refresh();
    apply.addEventListener('click', () => {
      const components = wanted();
      this.#close();
      this.#actions.prepare({ components: components.length === parts.length ? [] : components });
    });
    const more = parts.length - offered.length;
    return [
      make('h3', {}, `${formatCount(parts.length)} components`),
      make('ul', { class: 'parts' }, ...rows),
      ...(more > 0 ? [make('p', { class: 'hint' }, `and ${formatCount(more)} smaller ones`)] : []),
      make('p', {}, apply),
    ];
  }

  #changes(info: MeshInfo, { prepare, made }: ModelState): HTMLElement[] {
    const buttons: HTMLElement[] = [];
    const button = (words: string, act: () => void): void => {
      const made = make('button', { type: 'button', class: 'plain' }, words);
      made.addEventListener('click', () => {
        this.#close();
        act();
      });
      buttons.push(made);
    };
    const holes = info.boundaries.reduce((sum, count) => sum + count, 0);
    if (holes > 0 && made.length === 0) {
      button(holes === 1 ? 'Close the hole' : `Close ${formatCount(holes)} holes`, () =>
        this.#actions.prepare({ closeHoles: true }),
      );
    }
    const weldDistance = info.report.crackWidth;
    if (weldDistance > 0 && made.length === 0) {
      button('Sew the cracks', () => this.#actions.prepare({ weldDistance }));
    }
    const isChanged =
      made.length > 0 ||
      prepare.closeHoles ||
      prepare.weldDistance ||
      prepare.components?.length ||
      this.#actions.size.scale !== 1;
    if (isChanged) button('Back to the file', () => this.#actions.back());
    return [
      make('h3', {}, 'Change the surface'),
      this.#remeshing(info),
      ...(buttons.length > 0 ? [make('p', { class: 'buttons' }, ...buttons)] : []),
      this.#comparison,
    ];
  }

  #remeshing({ faceCount }: MeshInfo): HTMLElement {
    const number = make('input', {
      type: 'number',
      id: 'faces',
      min: '4',
      max: '200000',
      step: '1',
      required: '',
    });
    const draft = new Draft(number);
    draft.show(String(Math.min(10_000, Math.max(500, Math.round(faceCount / 2)))));
    const form = make(
      'form',
      { class: 'remesh' },
      make('label', { for: 'faces' }, 'Remesh to'),
      number,
      'faces',
      make('button', { class: 'plain' }, 'Remesh'),
    );
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#close();
      this.#actions.remesh(Number(draft.text));
    });
    return form;
  }
}
