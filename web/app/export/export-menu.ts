// Files of the page: the model, fields, tips, limbs, parts, necks, handles, the bottleneck, pinned loops, the picture, and the whole project.

import type { FieldFormat, FieldName, LoopFormat } from '../../src/kernel/index.js';
import {
  type CombinedName,
  type GirthViewer,
  combinationOf,
  fieldNames,
  fieldTitle,
  isFieldName,
  make,
} from '../../src/element/index.js';
import type { ComputedFields } from '../model/computed-fields.js';
import { byId, once } from '../widgets/dom.js';
import { Draft } from '../widgets/draft.js';
import { failureWords } from '../widgets/failure-words.js';
import { FigureChoice } from './figure-choice.js';
import type { LimbsPanel } from '../panels/limbs/limbs-panel.js';
import type { NecksPanel } from '../panels/necks/necks-panel.js';
import { modelFormats } from './model-files.js';
import type { PagePlot } from './page-plot.js';
import type { PartsPanel } from '../panels/parts/parts-panel.js';
import type { PinnedList } from '../panels/loops/pinned-list.js';
import { stemOf } from './save-file.js';
import { type Piece, fileWord, saveFiles } from './zip-files.js';
import { csvOf } from '../widgets/table-text.js';

const fieldFormats: Record<FieldFormat, string> = {
  csv: 'a row for each vertex',
  json: 'the same, for programs',
  npy: 'for NumPy',
  ply: 'surface and values',
  glb: 'surface, values, colours',
};
/** A file for each loop. */
const loopFormats: Record<Exclude<LoopFormat, 'json'>, string> = {
  obj: 'as lines',
  glb: 'as line strips',
};

/** Panels that have what is exported. */
interface ExportedPanels {
  parts: PartsPanel;
  loops: PinnedList;
  /** Fetched when they are first needed. */
  limbs: () => Promise<LimbsPanel>;
  necks: NecksPanel;
}

const textFile = (text: string): Uint8Array => new TextEncoder().encode(text);

/** `plots`: all of the page, seen or not; `project`: all that is shown, in one file. */
export function offerExports(
  viewer: GirthViewer,
  known: ComputedFields,
  { parts, loops: pinned, limbs: limbsPanel, necks: necksPanel }: ExportedPanels,
  plots: () => readonly PagePlot[],
  project: () => Promise<Uint8Array>,
): void {
  const menu = byId('export');
  const failure = byId('export-failure');
  const allFields = 'all';
  const field = make('select', { id: 'export-name', 'aria-label': 'Field' });
  const choice = new Draft(field);

  /** Writes files and hands them to the browser; several as a zip. Each format has a file name of its own. */
  const save = async (kind: string, format: string, write: () => Promise<Piece[]>) => {
    failure.textContent = '';
    const stem = stemOf(viewer.info?.name ?? 'model');
    try {
      await saveFiles(await write(), `${stem}${kind}`, format);
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

  /** Two fields in one that colour the surface. */
  const combined = (): CombinedName[] => {
    const name = viewer.shown?.name ?? 'none';
    return combinationOf(name) ? [name as CombinedName] : [];
  };

  const saveField = (format: FieldFormat): Promise<void> => {
    const name = choice.text as FieldName | CombinedName | typeof allFields;
    if (name !== allFields) {
      return save(`-${fileWord(name)}`, format, async () => [
        { content: await viewer.exportField(format, name) },
      ]);
    }
    // NumPy's format has one array a file.
    return save('-fields', format, async () =>
      format === 'npy'
        ? Promise.all(
            computed().map(async (one) => ({
              content: await viewer.exportField(format, one),
              word: one,
            })),
          )
        : [{ content: await viewer.exportFields(computed(), format) }],
    );
  };
  const fields = Object.entries(fieldFormats).map(([format, about]) =>
    entry(format, about, () => saveField(format as FieldFormat)),
  );
  const models = Object.entries(modelFormats).map(([format, about]) =>
    entry(format, about, () =>
      save('', format, async () => [
        { content: await viewer.exportModel(format as keyof typeof modelFormats) },
      ]),
    ),
  );
  const loopLines = async (format: LoopFormat): Promise<Piece[]> => {
    const { pinned } = viewer;
    const files = await viewer.exportLoops(format);
    return files.map((content, i) => ({ content, word: pinned[i]?.name ?? '' }));
  };
  /** All loops in one file, each with its name. */
  const loopsJson = async (): Promise<Piece[]> => {
    const pieces = await loopLines('json');
    const all = pieces.map(({ content, word }) => ({
      name: word,
      ...(JSON.parse(new TextDecoder().decode(content as Uint8Array)) as object),
    }));
    return [{ content: textFile(`${JSON.stringify({ loops: all })}\n`) }];
  };
  const loops = [
    entry('csv', 'names and lengths', () =>
      save('-loops', 'csv', () => Promise.resolve([{ content: textFile(csvOf(pinned.table)) }])),
    ),
    ...Object.entries(loopFormats).map(([format, about]) =>
      entry(format, about, () => save('-loops', format, () => loopLines(format as LoopFormat))),
    ),
    entry('json', 'names, lengths and points', () => save('-loops', 'json', loopsJson)),
  ];
  const tips = [
    entry('json', 'regions, contours, apexes', () =>
      save('-tips', 'json', async () => [{ content: await viewer.exportTips('json') }]),
    ),
    entry('obj', 'contours as lines', () =>
      save('-tips', 'obj', async () => [{ content: await viewer.exportTips('obj') }]),
    ),
  ];
  const limbs = [
    entry('json', 'measures, profiles, vertices', () =>
      save('-limbs', 'json', async () => [{ content: await viewer.exportLimbs('json') }]),
    ),
    entry('csv', 'profiles: a row for each station', () =>
      save('-limb-profiles', 'csv', async () => [
        { content: textFile(csvOf(await (await limbsPanel()).profiles())) },
      ]),
    ),
  ];
  const tubes = [
    entry('json', 'tubes, plates, body', () =>
      save('-parts', 'json', async () => [
        {
          content: await viewer.exportParts(
            parts.choice ?? (await viewer.suggestedThresholds()),
            'json',
          ),
        },
      ]),
    ),
  ];
  /** Entries for a result of the panel of necks, one for each format. */
  const listed = (name: keyof NecksPanel['listed'], formats: Readonly<Record<string, string>>) =>
    Object.entries(formats).map(([format, about]) =>
      entry(format, about, () =>
        save(`-${name}`, format, async () => [
          { content: await viewer.write(necksPanel.listed[name]!, format as 'json') },
        ]),
      ),
    );
  const lines = { obj: 'loops as lines', glb: 'loops as line strips', json: 'measures and points' };
  const measured = {
    necks: listed('necks', { csv: 'a row for each that is listed', ...lines }),
    handles: listed('handles', { csv: 'a row for each', ...lines }),
    bottleneck: listed('bottleneck', lines),
  };
  const figure = new FigureChoice();
  const savePicture = (): Promise<void> =>
    save('', 'png', async () => [{ content: await viewer.snapshot(figure.options) }]);
  const askedIn = make('div');
  const partial = once(async () => {
    const { PartialColours } = await import('./partial-colours.js');
    const question = new PartialColours(viewer, savePicture);
    askedIn.append(question.element);
    menu.addEventListener('beforetoggle', () => question.leave());
    return question;
  });
  /** Asks first where colours are missing. */
  const askOrSave = async (): Promise<void> => {
    const name = viewer.shown?.name;
    if (!name || !isFieldName(name) || viewer.shareOf(name) === 1) await savePicture();
    else (await partial()).ask(name);
  };
  const picture = [
    entry('png', 'as it is now', askOrSave),
    entry('svg', 'outline and loops, as lines', () =>
      save('-outline', 'svg', async () => [
        { content: textFile(await viewer.drawing(figure.drawing)) },
      ]),
    ),
    entry('svg', 'visible plots, as lines', () =>
      save('-plot', 'svg', () => {
        const seen = plots().flatMap(({ word, svg }) => {
          const text = svg(figure.drawing.width);
          return text === undefined ? [] : [{ content: textFile(text), word }];
        });
        return Promise.resolve(seen);
      }),
    ),
  ];
  const page = [
    entry('html', 'in one file, to be turned in any browser', () =>
      save('', 'html', async () => {
        const { webPage } = await import('./web-page.js');
        return [{ content: textFile(await webPage(viewer)) }];
      }),
    ),
  ];
  const whole = [
    entry('zip', 'model, settings and results in one file', () =>
      save('.girth', 'zip', async () => [{ content: await project() }]),
    ),
  ];
  failure.before(
    group('Model, as it is shown', 'export-model', ...models),
    group('Values at every vertex', 'export-field', field, ...fields),
    group('Tips', 'export-tips', ...tips),
    group('Limbs', 'export-limbs', ...limbs),
    group('Tubes and plates', 'export-parts', ...tubes),
    group('Necks', 'export-necks', ...measured.necks),
    group('Handles and tunnels', 'export-handles', ...measured.handles),
    group('Bottleneck', 'export-bottleneck', ...measured.bottleneck),
    group('Pinned loops', 'export-loops', ...loops),
    group('Picture', 'export-picture', figure.element, ...picture, askedIn),
    group('Web page', 'export-page', ...page),
    group('Project', 'export-project', ...whole),
  );

  menu.addEventListener('beforetoggle', () => {
    const names = computed();
    const before = choice.text;
    field.replaceChildren(
      ...[...names, ...combined()].map((name) => make('option', { value: name }, fieldTitle(name))),
      ...(names.length > 1 ? [make('option', { value: allFields }, 'All of these')] : []),
    );
    const shown = viewer.getAttribute('field');
    const options = [...field.options].map(({ value }) => value);
    const wished = [before, shown, 'igf'].find((name) => name && options.includes(name));
    if (wished) choice.show(wished);
    field.hidden = names.length === 0;
    for (const button of fields) button.disabled = names.length === 0;
    for (const button of [...tips, ...limbs, ...tubes]) button.disabled = !names.includes('igf');
    for (const name of Object.keys(measured)) {
      byId(`export-${name}`).hidden = !(name in necksPanel.listed);
    }
    for (const button of loops) button.disabled = viewer.pinned.length === 0;
    for (const button of [...models, ...picture, ...page, ...whole]) button.disabled = !viewer.info;
  });
}
