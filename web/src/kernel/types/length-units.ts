// Made of cpp/include/girth/io/length_units.def by `npm run build:tables`: not to be edited.

/** A unit of length. */
export interface LengthUnit {
  /** 'mm' */
  readonly symbol: string;
  /** 'millimetre' */
  readonly name: string;
  /** In one of it: 0.001. */
  readonly metres: number;
}

/** Units of length, small ones first. */
export const lengthUnits: readonly LengthUnit[] = [
  { symbol: 'um', name: 'micrometre', metres: 1e-6 },
  { symbol: 'mm', name: 'millimetre', metres: 1e-3 },
  { symbol: 'cm', name: 'centimetre', metres: 1e-2 },
  { symbol: 'm', name: 'metre', metres: 1 },
  { symbol: 'km', name: 'kilometre', metres: 1e3 },
  { symbol: 'in', name: 'inch', metres: 0.0254 },
  { symbol: 'ft', name: 'foot', metres: 0.3048 },
];

/** The unit with that symbol or name; undefined where there is none. */
export function findLengthUnit(symbolOrName: string): LengthUnit | undefined {
  return lengthUnits.find(({ symbol, name }) => symbol === symbolOrName || name === symbolOrName);
}
