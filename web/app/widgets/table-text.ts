// Tables as text that spreadsheets take: separated by tabs for the clipboard, by commas as a file.

import { writtenOut } from '../../src/element/plots.js';

export type Cell = string | number;
/** The names of the columns, then the rows. */
export type Table = readonly (readonly Cell[])[];

/** A number with as many significant digits as it needs, up to `digits`, without an exponent; '' for what is none. */
export function plainNumber(value: number, digits = 12): string {
  if (!Number.isFinite(value)) return '';
  const power = Number(value.toExponential(digits - 1).split('e')[1]);
  const written = writtenOut(value, Math.max(0, digits - 1 - power));
  return written.includes('.') ? written.replace(/\.?0+$/, '') : written;
}

/** The name of a column with the unit of its numbers; '' where that is not known. */
export const columnOf = (name: string, unit: string): string => (unit ? `${name} (${unit})` : name);

/** Marks as text what a spreadsheet would compute: names come from links, too. */
function safe(cell: Cell): string {
  if (typeof cell === 'number') return plainNumber(cell);
  return /^[=+\-@\t\r]/.test(cell) ? `'${cell}` : cell;
}

/** Tabs and line ends inside a cell become spaces. */
export function tsvOf(table: Table): string {
  return table
    .map((row) => row.map((cell) => safe(cell).replace(/[\t\r\n]+/g, ' ')).join('\t'))
    .map((line) => `${line}\n`)
    .join('');
}

/** The table as RFC 4180 has it, with line ends of one letter as in all files of this project. */
export function csvOf(table: Table): string {
  const quoted = (text: string): string =>
    /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  return table
    .map((row) => row.map((cell) => quoted(safe(cell))).join(','))
    .map((line) => `${line}\n`)
    .join('');
}
