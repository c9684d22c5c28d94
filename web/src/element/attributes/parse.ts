// The meaning of attributes, sources and errors in the element's own terms.

import type {
  FieldName,
  GirthErrorFields,
  MeshSource,
  SpectralOptions,
} from '../../kernel/types/types.js';

/** The ends of the colour map: values, or the shares of the surface below them. */
export interface RangeChoice {
  by: 'values' | 'shares';
  ends: readonly [number, number];
}

/** More lines of equal value than this are no lines. */
export const mostIsolines = 100;

/** Two ascending numbers, or percentages as in '5% 95%'; undefined for anything else. */
export function parseRange(text: string | null): RangeChoice | undefined {
  const words = (text ?? '').trim().split(/[\s,]+/);
  if (words.length !== 2) return undefined;
  const isShares = words.every((word) => word.endsWith('%'));
  const numbers = words.map((word) => {
    const digits = isShares ? word.slice(0, -1) : word;
    return digits === '' ? NaN : Number(digits) / (isShares ? 100 : 1);
  });
  const [low = NaN, high = NaN] = numbers;
  if (!(low < high) || !Number.isFinite(high - low)) return undefined;
  if (isShares && (low < 0 || high > 1)) return undefined;
  return { by: isShares ? 'shares' : 'values', ends: [low, high] };
}

type SpectralAttribute = 'time' | 'energy' | 'component';

/** The attribute that chooses the number of a signature that a field is, and the option it becomes. */
const spectralAttributes: Partial<
  Record<FieldName, { attribute: SpectralAttribute; option: keyof SpectralOptions }>
> = {
  hks: { attribute: 'time', option: 'time' },
  wks: { attribute: 'energy', option: 'component' },
  sihks: { attribute: 'component', option: 'component' },
};

/** Any number: the kernel decides which ones are valid. Undefined for anything else, and for other fields. */
export function parseSpectral(
  name: FieldName,
  attributeOf: (attribute: SpectralAttribute) => string | null,
): SpectralOptions | undefined {
  const asked = spectralAttributes[name];
  const text = asked && attributeOf(asked.attribute)?.trim();
  if (!asked || !text || !Number.isFinite(Number(text))) return undefined;
  return { [asked.option]: Number(text) };
}

export function parseVertices(text: string | null): number[] {
  return (text ?? '')
    .split(/[\s,]+/)
    .filter((word) => /^\d+$/.test(word))
    .map(Number);
}

/** A failure as events and messages have it, whatever was thrown. */
export function fieldsOf(error: unknown): GirthErrorFields {
  if (error instanceof Error && 'code' in error && typeof error.code === 'string') {
    const { element = -1, hint = '' } = error as Partial<GirthErrorFields>;
    return { code: error.code, element, message: error.message, hint };
  }
  const message = error instanceof Error ? error.message : String(error);
  return { code: 'INTERNAL', element: -1, message, hint: 'reload the page and try again' };
}

/** The name of what a source is, as far as it is known before it is read. */
export function nameOf(source: MeshSource): string {
  if (typeof source === 'string' || source instanceof URL) {
    return decodeURIComponent(String(source).split(/[?#]/)[0]!.split('/').pop() ?? '');
  }
  // The first name with a model's ending stands for several files; the kernel looks closer.
  const names = (Array.isArray(source) ? (source as object[]) : [source]).map(nameOfFile);
  return names.find((name) => /\.(glb|gltf|obj|off|ply|stl|zip)$/i.test(name)) ?? names[0] ?? '';
}

function nameOfFile(file: object): string {
  const { name = '', path = name } = file as { name?: string; path?: string };
  return path.slice(path.lastIndexOf('/') + 1);
}
