// Handing files to the browser, which asks or knows where to put them.

import { make } from '../../src/element/index.js';

const mediaTypes: Record<string, string> = {
  csv: 'text/csv',
  glb: 'model/gltf-binary',
  html: 'text/html',
  json: 'application/json',
  obj: 'model/obj',
  png: 'image/png',
  svg: 'image/svg+xml',
  zip: 'application/zip',
};

/** A file's name without its ending. */
export function stemOf(name: string): string {
  return name.replace(/\.[^.]*$/, '') || 'model';
}

export function saveFile(content: Blob | Uint8Array | string, name: string): void {
  const type = mediaTypes[name.slice(name.lastIndexOf('.') + 1)] ?? 'application/octet-stream';
  const address = URL.createObjectURL(new Blob([content as BlobPart], { type }));
  make('a', { href: address, download: name }).click();
  // The browser has begun to save it by then.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
