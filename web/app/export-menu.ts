// What is on the page as files: the field, the pinned loops, the picture.

import type { FieldFormat, LoopFormat } from '../src/kernel/index.js';
import { type GirthViewer, make } from '../src/element/index.js';
import { byId } from './dom.js';

const fieldFormats: Record<FieldFormat, string> = {
  csv: 'a row for each vertex',
  json: 'the same, for programs',
  npy: 'for NumPy',
  ply: 'surface and values',
  glb: 'surface, values, colours',
};
const loopFormats: Record<LoopFormat, string> = {
  obj: 'as lines',
  glb: 'as line strips',
  json: 'lengths and points',
};
const mediaTypes: Record<string, string> = {
  csv: 'text/csv',
  json: 'application/json',
  glb: 'model/gltf-binary',
  obj: 'model/obj',
  png: 'image/png',
  zip: 'application/zip',
};

async function zipped(files: Uint8Array[], stem: string, format: string): Promise<BlobPart> {
  const { zipSync } = await import('fflate');
  const entries = files.map((bytes, i) => [`${stem}-${i + 1}.${format}`, bytes] as const);
  return zipSync(Object.fromEntries(entries));
}

export function offerExports(viewer: GirthViewer): void {
  const menu = byId('export');
  const failure = byId('export-failure');

  /** Writes files and hands them to the browser; several as a zip. */
  const save = async (
    kind: string,
    format: string,
    write: () => Promise<(Blob | Uint8Array)[]>,
  ) => {
    failure.textContent = '';
    const stem = (viewer.info?.name ?? 'model').replace(/\.[^.]*$/, '') || 'model';
    try {
      const files = await write();
      const [content, ending] =
        files.length === 1
          ? [files[0] as BlobPart, format]
          : [await zipped(files as Uint8Array[], `${stem}${kind}`, format), 'zip'];
      const type = mediaTypes[ending] ?? 'application/octet-stream';
      const address = URL.createObjectURL(new Blob([content], { type }));
      const link = make('a', { href: address, download: `${stem}${kind}.${ending}` });
      link.click();
      // The browser has begun to save it by then.
      setTimeout(() => URL.revokeObjectURL(address), 60_000);
      menu.hidePopover();
    } catch (error) {
      const words = error instanceof Error ? error.message : String(error);
      failure.textContent = `That could not be written: ${words}.`;
    }
  };

  const entry = (format: string, about: string, act: () => Promise<void>) => {
    const words = make('span', {}, about);
    const button = make('button', { type: 'button' }, make('b', {}, format.toUpperCase()), words);
    button.dataset['format'] = format;
    button.addEventListener('click', () => void act());
    return button;
  };
  const group = (title: string, id: string, buttons: HTMLButtonElement[]) =>
    make('section', { id, 'aria-label': title }, make('h3', {}, title), ...buttons);

  const field = Object.entries(fieldFormats).map(([format, about]) =>
    entry(format, about, () =>
      save('-igf', format, async () => [await viewer.exportField(format as FieldFormat)]),
    ),
  );
  const loops = Object.entries(loopFormats).map(([format, about]) =>
    entry(format, about, () =>
      save('-loops', format, () => viewer.exportLoops(format as LoopFormat)),
    ),
  );
  const picture = [
    entry('png', 'as it is now', () => save('', 'png', async () => [await viewer.snapshot()])),
  ];
  failure.before(
    group('Girth at every vertex', 'export-field', field),
    group('Pinned loops', 'export-loops', loops),
    group('Picture', 'export-picture', picture),
  );

  menu.addEventListener('beforetoggle', () => {
    const isComputed = !!viewer.info && viewer.values('igf').some((value) => !Number.isNaN(value));
    for (const button of field) button.disabled = !isComputed;
    for (const button of loops) button.disabled = viewer.pinned.length === 0;
    for (const button of picture) button.disabled = !viewer.info;
  });
}
