// Colours of a model's surface: a field, its range and its lines, or categories; and the legend.

import type {
  Field,
  Parts,
  PartThresholds,
  PartialField,
  RefinedGirth,
  Tips,
} from '../../kernel/types/types.js';
import {
  type Category,
  type ColormapName,
  type FieldPreview,
  type CombinedName,
  type LegendContent,
  type LengthFormat,
  type ScaleContent,
  type ShownName,
  borrowedWeight,
  combinationOf,
  combinedUnit,
  computedWeight,
  fieldTitle,
  fieldUnit,
  formatCount,
  formatLength,
  girthKinds,
  girthStates,
  isFieldName,
  isGivenName,
  lengthFormat,
  nextTask,
  partKinds,
  shareWithin,
} from '../../view/index.js';
import { ColourRange, type Ends } from './colour-range.js';
import type { CombinedField } from '../model/combined-field.js';
import type { FieldState } from '../model/fields.js';
import { methodOf } from '../model/girth-method.js';
import type { GivenField } from '../model/given-fields.js';
import type { Model } from '../model/model.js';
import type { RangeChoice } from '../attributes/parse.js';

/**
 * Along an edge that no jump crosses the girth changes by at most twice its length; within a narrow
 * triangle of such edges by more.
 */
const steepestGirth = 4;
/** Milliseconds a frame may spend on spreading colours. */
const spreadBudget = 5;

/** The number of values from which their range is found in a task of its own. */
const manyValues = 50_000;

/** Codes that the girth has beside its values, and what they mean. */
const codeWords = { kind: girthKinds, state: girthStates };
type CodesName = keyof typeof codeWords;
const isOfCodes = (name: ShownName): name is CodesName => Object.hasOwn(codeWords, name);

/** The wishes of the element's attributes. */
export interface ShadingWishes {
  name: ShownName;
  /** The title in the legend; '' for the field's usual name. */
  title: string;
  /** Undefined: as fits the field. */
  colormap: ColormapName | undefined;
  /** Undefined: the body of the values. */
  range: RangeChoice | undefined;
  /** Whether equal factors, rather than equal differences, are equally far apart in the colour map. */
  log: boolean;
  isolines: number;
  /** The unit of lengths; '' where it is not known. */
  unit: string;
  /** The unit that lengths are written in; '' for `unit`. */
  shownUnit: string;
}

/** The shown field and its colours, once there is something to show. */
export interface ShownField {
  /** The name of the field or categories that colour the surface. */
  name: ShownName;
  /** The values at the ends of the colour map; undefined for categories. */
  range: readonly [number, number] | undefined;
  /** The field's smallest and largest value; undefined for categories. */
  extent: readonly [number, number] | undefined;
  /** The colours. */
  colormap: ColormapName;
  /** Whether the colour map is logarithmic. */
  log: boolean;
  /** How values are written. */
  format: LengthFormat;
}

/** Kinds of places that are shown in place of the field. */
export interface ShownPlaces {
  /** The legend's title. */
  title: string;
  /** For each vertex an index into the categories. */
  kinds: Uint8Array;
  /** The categories that `kinds` counts. */
  categories: readonly Category[];
}

/** The thresholds of parts, or the parts as the kernel has smoothed them. */
export interface PartsChoice extends PartThresholds {
  smoothed: Parts | undefined;
}

/** Categories have no range. */
const isOfCategories = (name: ShownName): boolean => isOfCodes(name) || name === 'parts';

/**
 * Whether the colours follow the body of the values where no range is wished for. Angles have the same meaning
 * everywhere, and most of the surface is in no tip.
 */
const hasBody = (name: ShownName): boolean =>
  !isOfCategories(name) && name !== 'tips' && name !== 'angle';

/** The range that the colours of a surface span by themselves. */
export interface OwnRange {
  /** The name of the field that colours the surface. */
  name: ShownName;
  /** The unit of the values; '' for none. */
  unit: string;
  ends: Ends;
  /** Whether two numbers were wished for. */
  isChosen: boolean;
}

export class Shading {
  wishes: ShadingWishes;
  /** The range that is shown for the surface's own: others may share it. */
  rangeFor: (own: OwnRange) => Ends = ({ ends }) => ends;
  /** The thresholds of the parts; undefined until they are first chosen. */
  parts: PartsChoice | undefined;
  /** Shown in place of what the wishes name; undefined for nothing. */
  places: ShownPlaces | undefined;
  #tips: { made: Tips; jumps: Float64Array; highest: number } | undefined;
  #areas: Float64Array | undefined;
  /** Whether the two fields are in the surface's memory that the thresholds divide. */
  #hasPair = false;
  readonly #colourRange = new ColourRange();
  #content: LegendContent | undefined;
  #current: ShownField | undefined;
  /** The whole field that was painted last; undefined for anything else. */
  #whole: Field | GivenField | CombinedField | undefined;
  /** The name of what colours the surface until the wished field is there. */
  #painted: ShownName = 'none';
  readonly #model: Model;

  constructor(model: Model, wishes: ShadingWishes) {
    this.#model = model;
    this.wishes = wishes;
  }

  get legend(): LegendContent | undefined {
    return this.#content;
  }

  get shown(): ShownField | undefined {
    return this.#current;
  }

  /**
   * The name of what colours the surface: the wished field, or the one before until that is there.
   */
  get name(): ShownName {
    const { name } = this.wishes;
    return this.#isThere(name) ? name : this.#painted;
  }

  /** The title of what colours the surface. */
  get title(): string {
    return this.wishes.title || fieldTitle(this.name);
  }

  /** Whether there are values to show, be it of a part of the surface. */
  #isThere(name: ShownName): boolean {
    const { fields } = this.#model;
    if (name === 'none') return true;
    if (name === 'tips') return !!this.#tips;
    if (isOfCodes(name)) return this.#codesOf(name).length > 0;
    if (name === 'parts') {
      return !!this.parts && !!fields.get('igf')?.field && !!fields.get('sdf')?.field;
    }
    const { field, preview } = this.#knownOf(name);
    return !!field || !!preview?.range;
  }

  /** The field of a name, computed or as the file has it; or its part that is there so far. */
  #knownOf(name: ShownName): {
    field?: Field | GivenField | CombinedField;
    preview?: FieldPreview;
  } {
    const { fields } = this.#model;
    const given = fields.givenOf(name) ?? fields.combinedOf(name);
    if (given) return { field: given };
    const { field, preview } = (isFieldName(name) && fields.get(name)) || {};
    return { ...(field && { field }), ...(preview && { preview }) };
  }

  /** Whether the wished field can be shown without computing anything. */
  get isReady(): boolean {
    const { name } = this.wishes;
    if (isOfCodes(name)) return this.#codesOf(name).length > 0;
    if (name === 'tips') return this.#model.file.tips !== undefined;
    return name === 'none' || !!this.#knownOf(name).field;
  }

  /** Computes what is to be shown, unless it is there. */
  async prepare(): Promise<void> {
    const model = this.#model;
    const { name, range } = this.wishes;
    if (name === 'none') return;
    if (isGivenName(name)) {
      if (!this.#knownOf(name).field) await model.fields.notGiven(name);
    } else if (this.isReady && name !== 'tips') {
      // The model's file has the field already.
    } else if (isFieldName(name)) await model.fields.compute(name);
    else if (combinationOf(name)) await model.fields.combine(name as CombinedName);
    else if (isOfCodes(name)) await model.fields.compute('igf');
    else if (name === 'tips') this.#keepTips(await model.tips());
    else {
      await model.girthAndDiameter();
      this.parts ??= { ...(await model.suggestedThresholds()), smoothed: undefined };
    }
    const needsAreas = range ? range.by === 'shares' && !isOfCategories(name) : hasBody(name);
    if (needsAreas) this.#areas ??= await model.areas();
  }

  /**
   * Finds the range of a field that is about to be shown. On a large surface this is a task of its own: together
   * with the colouring it would hold up the page. Undefined where there is nothing to wait for.
   */
  awaitRange(field: Field): Promise<void> | undefined {
    const { name, range } = this.wishes;
    const isFound = range ? range.by === 'values' : !hasBody(name);
    if (field.name !== name || field.values.length < manyValues || isFound) return undefined;
    return this.#awaitRange(field);
  }

  async #awaitRange({ values, range: extent }: Field): Promise<void> {
    // A failure to find the areas is reported where the colours are prepared.
    this.#areas ??= await this.#model.areas().catch(() => undefined);
    const { range } = this.wishes;
    if (range?.by === 'shares' && this.#areas) {
      this.#colourRange.sharesOf(values, this.#areas, range.ends);
    } else if (!range && !Number.isNaN(extent[0])) {
      this.#colourRange.bodyOf({ values, count: values.length, weights: this.#areas, extent });
    }
    await nextTask();
  }

  #keepTips(made: Tips): void {
    if (this.#tips?.made === made) return;
    const jumps = new Float64Array(this.#model.mesh.info.vertexCount);
    // The largest last: a vertex in several tips has the rise of the highest.
    for (const { vertices, jump } of [...made.tips].reverse()) {
      for (const vertex of vertices) jumps[vertex] = jump;
    }
    this.#tips = { made, jumps, highest: made.tips[0]?.jump ?? 0 };
  }

  /** How a field's values are written. */
  formatOf(name: ShownName): LengthFormat {
    const extent = this.#extentOf(name);
    const largest = extent
      ? Math.max(extent[1], -extent[0])
      : 2 * this.#model.surface.bounds.radius;
    return this.#formatFor(name, largest);
  }

  #unitOf(name: ShownName): string {
    const combined = combinationOf(name);
    if (combined) {
      const { by, first, second } = combined;
      return combinedUnit(by, this.#unitOf(first), this.#unitOf(second));
    }
    return this.#model.fields.givenUnit(name) ?? fieldUnit(name, this.wishes.unit);
  }

  /** Takes new values and colours their vertices. */
  receive(state: FieldState, partial: PartialField): void {
    const { preview } = state;
    if (!preview) return;
    const isGiven = this.#model.fields.givenOf(state.name) !== undefined;
    const isShown = (): boolean => state.name === this.name && !this.places && !isGiven;
    const wasShown = preview.computed > 0 && isShown();
    preview.receive(partial, (vertex) => {
      if (wasShown) this.#paintVertex(vertex, preview.shown[vertex]!, computedWeight);
    });
    // The first values take the place of whatever the surface was coloured by.
    if (!wasShown && isShown()) this.paint();
  }

  /** Whether colours are still to be spread between values that are there. */
  get isSpreading(): boolean {
    return this.#preview !== undefined && !this.#preview.isSpread;
  }

  /** Spreads colours to vertices without a value, for a few milliseconds; true when all are done. */
  spread(): boolean {
    const preview = this.#preview;
    if (!preview) return true;
    const done = preview.spread(
      (vertex) => this.#paintVertex(vertex, preview.shown[vertex]!, borrowedWeight),
      performance.now() + spreadBudget,
      () => performance.now(),
    );
    this.#model.surface.uploadScalars();
    return done;
  }

  get #preview() {
    const { name } = this;
    return this.places ? undefined : this.#knownOf(name).preview;
  }

  #paintVertex(vertex: number, value: number, weight: number): void {
    this.#model.surface.setScalar(vertex, value, Number.isNaN(value) ? 0 : weight);
  }

  /** Colours every vertex anew with what there is. */
  paint(): void {
    const { name } = this;
    this.#painted = name;
    const whole = this.places ? undefined : this.#knownOf(name).field;
    const isPainted = whole !== undefined && whole === this.#whole;
    this.#whole = whole;
    // Values that are no longer there colour the surface until the new ones come.
    if (isPainted || this.#keptOf(name)) this.refresh();
    else this.#paintAs(name);
  }

  /** The legend's words on values that colour the surface and are no longer there. */
  #keptOf(name: ShownName): ScaleContent | undefined {
    if (this.places || this.#current?.name !== name || this.#isThere(name)) return undefined;
    return this.#content && 'range' in this.#content ? this.#content : undefined;
  }

  #paintAs(name: ShownName): void {
    const { surface } = this.#model;
    if (this.places) {
      surface.setCategories(this.places.kinds, this.places.categories);
      surface.shadeBy('categories');
    } else if (isOfCodes(name)) {
      const codes = this.#codesOf(name);
      if (codes.length > 0) surface.setCategories(codes, codeWords[name]);
      surface.shadeBy(codes.length > 0 ? 'categories' : 'plain');
    } else if (name === 'parts') {
      this.#paintParts();
    } else if (name === 'tips') {
      this.#paintScalar(this.#tips?.jumps, () => computedWeight);
    } else if (name !== 'none') {
      const { field, preview } = this.#knownOf(name);
      this.#paintScalar(field?.values ?? preview?.shown, (vertex) =>
        !preview || preview.isComputed(vertex) ? computedWeight : borrowedWeight,
      );
    } else {
      surface.shadeBy('plain');
    }
    this.refresh();
  }

  #paintScalar(values: ArrayLike<number> | undefined, weightOf: (vertex: number) => number): void {
    const { surface } = this.#model;
    surface.shadeBy(values ? 'scalar' : 'plain');
    if (!values) return;
    for (let vertex = 0; vertex < values.length; ++vertex) {
      this.#paintVertex(vertex, values[vertex]!, weightOf(vertex));
    }
    surface.uploadScalars();
  }

  #paintParts(): void {
    const { surface, fields } = this.#model;
    const [igf, sdf] = [fields.get('igf')?.field, fields.get('sdf')?.field];
    const { parts } = this;
    if (!parts || !igf || !sdf) {
      surface.shadeBy('plain');
    } else if (parts.smoothed) {
      surface.setCategories(parts.smoothed.kinds, partKinds);
      surface.shadeBy('categories');
    } else {
      if (!this.#hasPair) surface.setPair(igf.values, sdf.values);
      this.#hasPair = true;
      surface.setThresholds(parts.girth, parts.shapeDiameter, partKinds);
      surface.shadeBy('thresholds');
    }
  }

  /** Brings range, lines and legend up to date with the values there are. */
  refresh(): void {
    const { surface } = this.#model;
    const { name } = this;
    const { isolines, colormap: wished } = this.wishes;
    const kept = this.#keptOf(name);
    const format = kept?.format ?? this.formatOf(name);
    this.#current = undefined;
    this.#content = undefined;
    if (this.places) {
      const { title, categories } = this.places;
      this.#content = { title, categories, note: '' };
      return;
    }
    if (name === 'none') return;
    const { title } = this;
    if (isOfCategories(name)) {
      if (isOfCodes(name) && this.#codesOf(name).length === 0) {
        if (name === 'state') this.#content = { title, categories: [], note: this.#noStates };
        return;
      }
      if (name === 'parts' && !this.parts) return;
      const used = isOfCodes(name) ? this.#usedWords(name) : partKinds;
      const colormap = wished ?? 'viridis';
      const none = { range: undefined, extent: undefined, log: false };
      this.#current = { name, ...none, colormap, format };
      this.#content = { title, categories: used, note: this.#noteOf(name) };
      return;
    }
    const extent = kept?.extent ?? this.#extentOf(name);
    if (!extent) {
      const note = this.#noteOf(name);
      if (note) this.#content = { title, categories: [], note };
      return;
    }
    const isDifference = combinationOf(name)?.by === 'difference';
    const isSigned = isDifference || (extent[0] < 0 && extent[1] > 0);
    const colormap = wished ?? (isSigned ? 'rdbu' : 'viridis');
    const own = this.#rangeOf(name, extent, colormap === 'rdbu' && isSigned);
    const range = kept?.range ?? this.#shownRange(name, own);
    const isShared = !kept && range !== own;
    // Where all values are the same but for rounding, they have the same colour.
    const least = 1e-5 * Math.abs(range[1]);
    const widen = range[1] - range[0] < least ? least : 0;
    surface.setColormap(colormap);
    surface.setRange(range[0] - widen, range[1] + widen);
    const steepest = name === 'igf' ? steepestGirth : Infinity;
    surface.setIsolines(isolines, steepest, this.#isCarried(name));
    // There are no logarithms of 0 and below.
    const log = this.wishes.log && range[0] > 0;
    surface.setLog(log);
    this.#current = { name, range, extent, colormap, log, format };
    this.#content = {
      title,
      colormap,
      range,
      extent,
      // Values that share a range with others are written as the others' are.
      format: isShared ? this.#formatFor(name, Math.max(range[1], -range[0])) : format,
      log,
      isolines,
      note: kept?.note ?? this.#noteOf(name),
      beyond: kept || this.wishes.range ? kept?.beyond : this.#beyond(name, range, extent),
    };
  }

  /** The codes of the vertices, where the girth is whole; otherwise empty. */
  #codesOf(name: CodesName): Uint8Array {
    const igf = this.#model.fields.wholeOf('igf');
    const codes = name === 'kind' ? igf?.kinds : (igf as Partial<RefinedGirth> | undefined)?.states;
    return codes ?? new Uint8Array(0);
  }

  #usedWords(name: CodesName): readonly Category[] {
    const codes = this.#codesOf(name);
    return codeWords[name].filter((_, number) => codes.includes(number));
  }

  /** Why there are no states, once the girth is there. */
  get #noStates(): string {
    return this.#model.fields.wholeOf('igf') ? 'only the refined method says how sure it is' : '';
  }

  #extentOf(name: ShownName): readonly [number, number] | undefined {
    if (name === 'tips') return this.#tips?.highest ? [0, this.#tips.highest] : undefined;
    const { field, preview } = this.#knownOf(name);
    const range = field?.range ?? preview?.range;
    return range && Number.isNaN(range[0]) ? undefined : range;
  }

  #shownRange(name: ShownName, ends: Ends): Ends {
    const isChosen = this.wishes.range?.by === 'values';
    return this.rangeFor({ name, unit: this.#unitOf(name), ends, isChosen });
  }

  /** The format of values whose largest is `largest`. */
  #formatFor(name: ShownName, largest: number): LengthFormat {
    return lengthFormat(largest, this.#unitOf(name), this.wishes.shownUnit);
  }

  #rangeOf(
    name: ShownName,
    extent: readonly [number, number],
    isCentred: boolean,
  ): readonly [number, number] {
    const { range } = this.wishes;
    if (range?.by === 'values') return range.ends;
    let [low, high] = range ? this.#endsOf(name, extent, range) : this.#bodyOf(name, extent);
    if (isCentred) [low, high] = [Math.min(low, -high), Math.max(high, -low)];
    return [low, high];
  }

  /** The extent without what few places stretch it by. */
  #bodyOf(name: ShownName, extent: Ends): Ends {
    if (!hasBody(name)) return extent;
    const { field, preview } = this.#knownOf(name);
    const values = field?.values ?? preview?.values;
    if (!values) return extent;
    const count = field ? values.length : preview!.computed;
    return this.#colourRange.bodyOf({ values, count, weights: this.#areas, extent });
  }

  /** The values below which the wished shares of the surface lie; the extent until the field is whole. */
  #endsOf(name: ShownName, extent: Ends, { ends }: RangeChoice): Ends {
    const values = name === 'tips' ? this.#tips?.jumps : this.#knownOf(name).field?.values;
    if (!values || !this.#areas) return extent;
    return this.#colourRange.sharesOf(values, this.#areas, ends);
  }

  /** The values beyond the colours, in words: 'up to 348.6 in 0.6% of the surface'. */
  #beyond(name: ShownName, [low, high]: Ends, extent: Ends): string | undefined {
    const isCut = [extent[0] < low, extent[1] > high];
    if (!isCut[0] && !isCut[1]) return undefined;
    const format = this.formatOf(name);
    const words = [
      isCut[0] ? `from ${formatLength(extent[0], format)}` : '',
      isCut[1] ? `up to ${formatLength(extent[1], format)}` : '',
    ];
    const values = this.#knownOf(name).field?.values;
    if (!values) return words.filter(Boolean).join(', ');
    const share = 100 * (1 - shareWithin(values, this.#areas, [low, high]));
    const percent = share < 0.1 ? 'less than 0.1' : share.toFixed(1);
    return `${words.filter(Boolean).join(', ')} in ${percent}% of the surface`;
  }

  /** Whether values were carried over from fewer triangles, which do not tell where a jump is. */
  #isCarried(name: ShownName): boolean {
    if (name !== 'igf') return false;
    const { field, preview } = this.#knownOf(name);
    const computed = this.#model.fields.get('igf')?.field;
    if (field) return computed !== undefined && methodOf(computed) === 'coarse';
    return preview?.isLent === true;
  }

  /** A note on the values: that of the core, and the meaning of grey. */
  #noteOf(name: ShownName): string {
    if (name === 'tips') return this.#tips?.made.tips.length === 0 ? 'no tips' : '';
    const source = name === 'parts' ? 'sdf' : name;
    const { field } = this.#knownOf(source);
    if (!field) return '';
    const { withoutValue } = field;
    const note = this.#isCarried(name) ? `${field.note}; striped near jumps` : field.note;
    if (withoutValue === 0) return note;
    if (note) return `${note} (grey)`;
    const vertices = withoutValue === 1 ? 'vertex' : 'vertices';
    return `grey: no value at ${formatCount(withoutValue)} ${vertices}`;
  }
}
