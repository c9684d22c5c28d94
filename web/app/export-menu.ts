// What is on the page as files: fields, tips, parts, the pinned loops, the picture.

import type { FieldFormat, FieldName, LoopFormat } from '../src/kernel/index.js';
import { type GirthViewer, fieldNames, fieldTitle, make } from '../src/element/index.js';
import type { ComputedFields } from './computed-fields.js';
import { byId } from './dom.js';
import { Draft } from './draft.js';
import { failureWords } from './failure-words.js';
import type { PartsPanel } from './parts-panel.js';
import { saveFile, stemOf } from './save-file.js';

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

type Content = Blob | Uint8Array;

async function zipped(files: Content[], stem: string, format: string): Promise<Uint8Array> {
  const { zipSync } = await import('fflate');
  const entries = files.map((bytes, i) => [`${stem}-${i + 1}.${format}`, bytes] as const);
  return zipSync(Object.fromEntries(entries) as Record<string, Uint8Array>);
}

export function offerExports(viewer: GirthViewer, known: ComputedFields, parts: PartsPanel): void {
  const menu = byId('export');
  const failure = byId('export-failure');
  const allFields = 'all';
  const field = make('select', { id: 'export-name', 'aria-label': 'Field' });
  const choice = new Draft(field);

  /** Writes files and hands them to the browser; several as a zip. */
  const save = async (kind: string, format: string, write: () => Promise<Content[]>) => {
    failure.textContent = '';
    const stem = stemOf(viewer.info?.name ?? 'model');
    try {
      const files = await write();
      if (files.length === 1) saveFile(files[0]!, `${stem}${kind}.${format}`);
      else saveFile(await zipped(files, `${stem}${kind}`, format), `${stem}${kind}.zip`);
      menu.hidePopover();
    } catch (error) {
      failure.textContent = `That could not be written: ${failureWords(error)}.`;
    }
  };

  const entry = (format: string, about: string, act: () => Promise<void>) => {
    const words = make('span', {}, about);
    const button = make('button', { type: 'button' }, make('b', {}, format.toUpperCase()), words);
    button.dataset['format'] = format;
    button.addEventListener('click', () => void act());
    return button;
  };
  const group = (title: string, id: string, ...content: HTMLElement[]) =>
    make('section', { id, 'aria-label': title }, make('h3', {}, title), ...content);

  /** Fields that are computed from end to end. */
  const computed = (): FieldName[] => fieldNames.filter((name) => known.has(name));

  const saveField = (format: FieldFormat): Promise<void> => {
    const name = choice.text as FieldName | typeof allFields;
    if (name !== allFields) {
      return save(`-${name}`, format, async () => [await viewer.exportField(format, name)]);
    }
    // NumPy's format has one array a file.
    return save('-fields', format, async () =>
      format === 'npy'
        ? Promise.all(computed().map((one) => viewer.exportField(format, one)))
        : [await viewer.exportFields(computed(), format)],
    );
  };
  const fields = Object.entries(fieldFormats).map(([format, about]) =>
    entry(format, about, () => saveField(format as FieldFormat)),
  );
  const loops = Object.entries(loopFormats).map(([format, about]) =>
    entry(format, about, () =>
      save('-loops', format, () => viewer.exportLoops(format as LoopFormat)),
    ),
  );
  const tips = [
    entry('json', 'regions, contours, apexes', () =>
      save('-tips', 'json', async () => [await viewer.exportTips('json')]),
    ),
    entry('obj', 'contours as lines', () =>
      save('-tips', 'obj', async () => [await viewer.exportTips('obj')]),
    ),
  ];
  const tubes = [
    entry('json', 'tubes, plates, body', () =>
      save('-parts', 'json', async () => [
        await viewer.exportParts(parts.choice ?? (await viewer.suggestedThresholds()), 'json'),
      ]),
    ),
  ];
  const picture = [
    entry('png', 'as it is now, with the legend', () =>
      save('', 'png', async () => [await viewer.snapshot({ legend: true })]),
    ),
  ];
  failure.before(
    group('Values at every vertex', 'export-field', field, ...fields),
    group('Tips', 'export-tips', ...tips),
    group('Tubes and plates', 'export-parts', ...tubes),
    group('Pinned loops', 'export-loops', ...loops),
    group('Picture', 'export-picture', ...picture),
  );

  menu.addEventListener('beforetoggle', () => {
    const names = computed();
    const before = choice.text;
    field.replaceChildren(
      ...names.map((name) => make('option', { value: name }, fieldTitle(name))),
      ...(names.length > 1 ? [make('option', { value: allFields }, 'All of these')] : []),
    );
    const shown = viewer.getAttribute('field') as FieldName | null;
    const options = [...field.options].map(({ value }) => value);
    const wished = [before, shown, 'igf'].find((name) => name && options.includes(name));
    if (wished) choice.show(wished);
    field.disabled = names.length === 0;
    for (const button of fields) button.disabled = names.length === 0;
    for (const button of [...tips, ...tubes]) button.disabled = !names.includes('igf');
    for (const button of loops) button.disabled = viewer.pinned.length === 0;
    for (const button of picture) button.disabled = !viewer.info;
  });
}
