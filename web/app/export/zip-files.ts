// Several files handed to the browser as one.

import { saveFile } from './save-file.js';

/** One of several files, and what its name says of it. */
export interface Piece {
  content: Blob | Uint8Array;
  word?: string;
}

/** Saves a file as `stem.format`, and several as a zip: each has its number in its name. */
export async function saveFiles(
  files: readonly Piece[],
  stem: string,
  format: string,
): Promise<void> {
  const [first] = files;
  if (first && files.length === 1) saveFile(first.content, `${stem}.${format}`);
  else saveFile(await zipped(files, stem, format), `${stem}-${format}.zip`);
}

async function zipped(files: readonly Piece[], stem: string, format: string): Promise<Uint8Array> {
  const { zipSync } = await import('fflate');
  const entries = files.map(({ content, word = '' }, i) => {
    const name = [stem, i + 1, ...(word === '' ? [] : [fileWord(word)])].join('-');
    return [`${name}.${format}`, content] as const;
  });
  return zipSync(Object.fromEntries(entries) as Record<string, Uint8Array>);
}

/** A name as part of a file's name. */
export function fileWord(name: string): string {
  return name.replace(/[^\p{L}\p{N}]+/gu, '-').replace(/^-|-$/g, '');
}
