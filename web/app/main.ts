// The drop page: one screen built on <girth-viewer>.

import type { FileWithPath, PrepareOptions } from '../src/kernel/index.js';
import { type GirthViewer, fieldTitle, sentence } from '../src/element/index.js';
import {
  type PageState,
  type PanelName,
  panelNames,
  preparationOf,
  resized,
} from './state/address-state.js';
import { without } from './state/actions.js';
import { Address } from './state/address.js';
import { Store } from './state/store.js';
import { followAttributes, followCamera } from './state/attributes.js';
import type { ComparePanel } from './panels/compare/compare-panel.js';
import { ComputedFields } from './model/computed-fields.js';
import { byId, nextTask, once } from './widgets/dom.js';
import { type Files, acceptDrops } from './model/drop.js';
import { type Example, ExamplesStrip } from './model/examples-strip.js';
import { offerExports } from './export/export-menu.js';
import { takeResults } from './model/grown-results.js';
import { failureWords } from './widgets/failure-words.js';
import { FieldPanel } from './panels/field/field-panel.js';
import { removalWords } from './panels/necks/handle-removal.js';
import { acceptLaunches } from './model/launch.js';
import type { LimbsPanel } from './panels/limbs/limbs-panel.js';
import { NecksPanel } from './panels/necks/necks-panel.js';
import { explainColours, showUntilTouched } from './help/meaning.js';
import { MissingModel } from './model/missing-model.js';
import { forwardKeys, pressControls } from './commands/keys.js';
import { ModelDetails } from './model/model-details.js';
import { offerInstalling, workOffline } from './offline.js';
import type { PagePlot } from './export/page-plot.js';
import { Panel } from './widgets/panel.js';
import { PartsPanel } from './panels/parts/parts-panel.js';
import { PinnedList } from './panels/loops/pinned-list.js';
import type { PrintPanel } from './panels/print/print-panel.js';
import { RecentFiles } from './model/recent-files.js';
import { type Opened, Session, isSameModel } from './model/session.js';
import { elementLine, frameLine } from './export/share-lines.js';
import { type Shared, offerSharing } from './export/share-sheet.js';
import { closeLeftSheets } from './widgets/sheets.js';
import { Draft } from './widgets/draft.js';
import { LengthInput } from './widgets/length-input.js';
import type { PanelKit } from './widgets/panel-kit.js';
import { PanelSearch } from './widgets/panel-search.js';
import { PlaceList } from './widgets/place-list.js';
import { axisNumber } from './widgets/axis-number.js';
import { ProfilePlot } from '../src/element/plots.js';
import type { TubePanel } from './panels/tube/tube-panel.js';
import { TableActions } from './widgets/table-actions.js';
import { columnOf } from './widgets/table-text.js';
import { saveFile, stemOf } from './export/save-file.js';
import type { ModelScale } from './model/size-choice.js';
import { offerTheme } from './theme.js';
import { TipsPanel } from './panels/tips/tips-panel.js';
import { offerUndo } from './state/undo-buttons.js';

const viewer = byId<GirthViewer>('viewer');
const invitation = byId('invitation');
const projectFault = byId('project-fault');
const store = new Store();
const computed = new ComputedFields(viewer);
const session = new Session(viewer, () => takeResults(viewer, computed, store.shown));
followAttributes(viewer, store);
showUntilTouched(viewer);

// Long work is done in several tasks, between which the page answers.
await nextTask();
const field = new FieldPanel(viewer, computed, store, {
  partKinds: () => parts.kinds,
  tipRises: () => tips.rises,
});
const loops = new PinnedList(viewer, store);
/** For panels that are fetched when they are opened. */
const kit: PanelKit = {
  ...{ Draft, LengthInput, PanelSearch, PlaceList, ProfilePlot, TableActions },
  ...{ axisNumber, columnOf, failureWords, stemOf },
};
const sections = new Panel('sections-panel');
const showSections = once(async () => {
  const { SectionsPanel } = await import('./panels/sections/sections-panel.js');
  return new SectionsPanel(viewer, store, sections, kit);
});
sections.onToggle(() => void showSections());
const tube = new Panel('tube-panel');
let measured: TubePanel | undefined;
const showTube = once(async () => {
  const { TubePanel } = await import('./panels/tube/tube-panel.js');
  return (measured = new TubePanel(viewer, store, tube, kit));
});
tube.onToggle(() => void showTube());
const tips = new TipsPanel(viewer, store, {
  found: () => field.refresh(),
  colour: (bySdf) => field.colourForPanel('sdf', bySdf),
});
await nextTask();
const limbed = new Panel('limbs-panel');
let limbs: LimbsPanel | undefined;
const showLimbs = once(async () => {
  const { LimbsPanel } = await import('./panels/limbs/limbs-panel.js');
  return (limbs = new LimbsPanel(viewer, store, limbed));
});
limbed.onToggle(() => void showLimbs());
const necks = new NecksPanel(viewer, store, (length) => session.removeHandles(length));
const parts = new PartsPanel(viewer, store, {
  found: () => field.refresh(),
  colour: (wanted) => field.colourForPanel('parts', wanted),
});
const size: ModelScale = {
  get scale() {
    return session.scale;
  },
  rescale: (scale) => {
    if (!session.opened) return;
    // The view of the model is the same in the other size.
    const { shown } = store;
    const wished = { ...resized(shown, scale / session.scale), scale };
    const { weld } = wished;
    void reopen(wished, { scale, ...(weld === undefined ? {} : { weldDistance: weld }) });
  },
};
const printing = new Panel('print-panel');
let print: PrintPanel | undefined;
const showPrint = once(async () => {
  const { PrintPanel } = await import('./panels/print/print-panel.js');
  print = new PrintPanel(viewer, store, printing, size, () => {
    explain();
    field.showPlaces(print?.places);
  });
});
printing.onToggle(() => void showPrint());
/** Panels that wait until the first surface is drawn; then they are there before somebody opens them. */
async function fetchPanels(): Promise<void> {
  await new Promise((drawn) => requestAnimationFrame(drawn));
  await nextTask();
  // A failure is met again where a panel is opened.
  await Promise.allSettled([showPrint(), showLimbs()]);
}
viewer.addEventListener('load', () => void fetchPanels(), { once: true });
const comparePanel = new Panel('compare-panel');
let compared: ComparePanel | undefined;
/** The comparison is fetched when its panel is opened, or several models are. */
const compare = once(async () => {
  const { ComparePanel } = await import('./panels/compare/compare-panel.js');
  return (compared = new ComparePanel(comparePanel, {
    present: () => session.opened && { opened: session.opened, name: viewer.info?.name ?? '' },
    gallery: () =>
      examples.all.map((example) => ({ opened: exampleToOpen(example), name: example.file })),
    fieldOf: (opened, name) => {
      const isShown = session.opened && isSameModel(session.opened, opened);
      // The page computes the girth of every model that it shows.
      return isShown && (name === 'igf' || computed.has(name)) ? viewer.fieldOf(name) : undefined;
    },
    show: (opened) => void session.open(opened),
    showBeside: (opened) => void beside().then((one) => one.open(opened)),
  }));
});
comparePanel.onToggle((isOpen) => isOpen && void compare());
const panels: Record<PanelName, Panel> = {
  loops: loops.panel,
  sections,
  tube,
  tips: tips.panel,
  limbs: limbed,
  necks: necks.panel,
  parts: parts.panel,
  print: printing,
  compare: comparePanel,
};

const openPanel = (): PanelName | undefined => {
  const open = panelNames.find((name) => panels[name].isOpen);
  return open === 'loops' ? undefined : open;
};
for (const panel of Object.values(panels)) {
  panel.onToggle(() => store.choose({ panel: openPanel() }));
}
store.watch(['panel'], ({ panel }) => {
  if (panel !== openPanel()) panels[panel ?? 'loops'].open();
});

await nextTask();

/** The model beside the shown one, once it is asked for. */
const beside = once(async () => {
  const { Beside } = await import('./model/beside.js');
  return new Beside(viewer, store, {
    gallery: () =>
      examples.all.map((example) => ({ opened: exampleToOpen(example), title: example.title })),
    openedBefore: (file) => session.openedBefore(file),
  });
});
byId('beside-menu').addEventListener('beforetoggle', () => void beside());
followCamera(viewer, store);
// Loops are followed after the panel that cuts along them.
store.watch(['loops', 'names'], (state) => loops.follow(state));
let wasBeside = false;
store.watch(['beside', 'besideFile', 'apart', 'oneScale'], (state) => {
  wasBeside ||= (state.beside ?? state.besideFile) !== undefined;
  if (wasBeside) void beside().then((one) => one.apply(store.shown));
});

// ---- what is shown, and the address that holds it

/** Adds the lengths of loops to a state, for readers who do not have the file. */
const written = (state: PageState): PageState =>
  viewer.info && state.file !== undefined && state.loops
    ? { ...state, values: loops.values }
    : state;

/** The surface has come: it is shown as it was wished for, or as the one before. */
function arrive(wish?: number, isAnother = false): void {
  const surface = viewer.info!;
  const { vertexCount, faceCount, unit } = surface;
  const facts = { surface, vertexCount, faceCount, unit, given: viewer.given };
  store.arrive(session.read(), facts, wish, isAnother);
}

/** Opens the shown model again, prepared otherwise, with the state that is wished for then. */
async function reopen(state: PageState, change: PrepareOptions): Promise<void> {
  const wish = store.ask(state, { byHand: true });
  if (!(await session.reopen(change, wish))) store.fail(wish);
}

/** Opens the model that a link names, or the first example, and then shows the rest. */
async function follow(link: PageState, asked = session.ask()): Promise<void> {
  const isFile = link.file !== undefined && link.model === undefined;
  const isAddress = link.model?.includes(':') ?? false;
  const example = examples.all.find(({ name }) => name === link.model) ?? examples.all[0];
  const model = isFile || isAddress ? link.model : example?.name;
  const state = model === undefined ? link : { ...link, model };
  const before = isFile ? session.openedBefore(link.file!) : undefined;
  const opened = before ?? (isFile || !model ? undefined : { source: model, link: { model } });
  const wish = store.ask(state, { isMissing: isFile && !before });
  const isWithHandles = { ...state, handles: undefined };
  if (viewer.info && session.isOf(state)) {
    arrive(wish);
  } else if (viewer.info && session.isBefore(state)) {
    if (!(await session.restore(wish))) store.fail(wish);
  } else if (viewer.info && state.handles !== undefined && session.isOf(isWithHandles)) {
    await repair(state.handles, wish);
  } else if (opened) {
    const prepare = preparationOf(state);
    const isOpen =
      isAddress || before
        ? await session.open({ ...opened, prepare, wish }, asked)
        : await openExample(example!, { prepare, wish }, asked);
    if (!isOpen) store.fail(wish);
  } else if (isFile) {
    // A link cannot have a file in it: wait for it.
    invitation.hidden = true;
    missing.show(state, !viewer.info);
  }
}

/** Takes the handles away that a link's surface has not, and then shows the rest. */
async function repair(length: number, wish: number): Promise<void> {
  const { opened } = session;
  const removal = await session.removeHandles(length, wish);
  // Where something was taken away, the surface that is left has come as another model does.
  if (removal && removal.removed.length > 0) return;
  if (session.opened === opened) arrive(wish);
}

const address: Address = new Address(store, {
  written,
  followed: (state) => void follow(state),
  stepped: () => showUndo(),
});
const showUndo = offerUndo(address);

// ---- opening models

const details = new ModelDetails(viewer, {
  choose: (model) => session.choose(model),
  size,
  prepare: (change) => void session.reopen(change),
  remesh: (faces) => {
    if (session.canRemesh) void session.remesh(faces);
    else void reopen({ ...without(store.shown, ['handles']), faces }, {});
  },
  back: () => session.back(),
});

const missing = new MissingModel(() => byId<HTMLInputElement>('file').click());

const examples = new ExamplesStrip(byId('examples'), (example) => {
  address.flush();
  store.giveUp();
  void openExample(example);
});

function exampleToOpen(example: Example): Opened {
  return { source: examples.addressOf(example), link: { model: example.name }, prepare: {} };
}

async function openExample(
  example: Example,
  as: Partial<Opened> = {},
  asked = session.ask(),
): Promise<boolean> {
  projectFault.hidden = true;
  examples.mark(example);
  return session.open({ ...exampleToOpen(example), ...as }, asked);
}

/**
 * Opens files, or those found in a folder or on the disk, if there are any. A model that was asked
 * for later stays.
 */
async function openFiles(found: Files | Promise<Files>): Promise<void> {
  const asked = session.ask();
  const files = await found;
  if (files.length === 0 || session.isOvertaken(asked)) return;
  address.flush();
  projectFault.hidden = true;
  const names = files.map((file) => (file instanceof File ? file.name : file.path));
  if (names.length === 1 && /\.zip$/i.test(names[0]!) && (await openProject(files[0]!, asked)))
    return;
  const source = files.length === 1 && files[0] instanceof File ? files[0] : files;
  const wished = store.wish?.state ?? {};
  const isWished = names.some((name) => name === wished.file);
  const wish = isWished ? store.ask(wished) : undefined;
  if (!isWished) store.giveUp();
  const file = isWished ? wished.file! : names[0]!;
  const prepare = isWished ? preparationOf(wished) : {};
  if (!(await session.open({ source, link: { file }, prepare, wish }, asked))) {
    // The file may be dropped again.
    if (wish !== undefined && store.wish?.number === wish) store.ask(wished, { isMissing: true });
    return;
  }
  recent.opened(files);
  invitation.hidden = true;
  viewer.removeAttribute('turn');
  const { models, unreadable } = viewer.info!;
  if (models.length > 1) {
    const named = models.find((path) => !unreadable.some(({ model }) => model === path))!;
    session.name(named);
    store.choose({ file: named });
    comparePanel.reveal();
    (await compare()).add(
      models.map((model) => ({
        opened: { source, link: { file: model }, model, prepare: {} },
        name: model,
      })),
    );
  }
}

const projects = once(() => import('./model/project.js'));

function showProjectFault(error: unknown): void {
  projectFault.textContent = sentence(failureWords(error));
  projectFault.hidden = false;
}

/**
 * Opens a zip as a project; false where it is none. A model that was asked for later, and is open
 * by then, stays.
 */
async function openProject(file: File | FileWithPath, asked: number): Promise<boolean> {
  const { projectIn } = await projects();
  const read = await projectIn(file).catch((error: unknown) => {
    if (!session.isOvertaken(asked)) showProjectFault(error);
  });
  if (session.isOvertaken(asked)) return true;
  if (!read) return false;
  const { name, source, model, state, adopt } = read;
  const wish = store.ask(state, { byHand: true });
  const prepare = preparationOf(state);
  const opened = { source, link: { file: name }, model, prepare, wish, adopt };
  if (!(await session.open(opened, asked))) {
    store.fail(wish);
    return true;
  }
  recent.opened([file]);
  invitation.hidden = true;
  viewer.removeAttribute('turn');
  return true;
}

viewer.addEventListener('load', (event) => {
  const { info } = event.detail;
  // Units and a way up that were chosen stay with their model, however that is prepared.
  const isAnother = session.arrived();
  if (isAnother) recent.left();
  missing.hide();
  byId('beside-open').hidden = false;
  const { opened } = session;
  const { prepare = {}, remeshed, handles, link, wish } = opened ?? {};
  examples.mark(examples.all.find(({ name }) => name === link?.model));
  const { removal } = viewer;
  const made = [
    ...(remeshed ? [remeshed.words] : []),
    ...(removal ? [`short handles removed: ${removalWords(removal)}`] : []),
  ];
  details.show(info, { prepare, made });
  for (const panel of [field, tips, necks, parts]) panel.clear();
  limbs?.clear();
  print?.clear(isAnother);
  document.title = `${info.name} – Girth`;
  delete document.documentElement.dataset['field'];
  const wished = store.wish?.number === wish ? store.wish?.state : undefined;
  if (wished?.faces !== undefined && remeshed?.faces !== wished.faces) {
    void session.remesh(wished.faces).then((isDone) => {
      if (!isDone && session.opened === opened) arrive(wish, isAnother);
    });
  } else if (wished?.handles !== undefined && handles === undefined) {
    void repair(wished.handles, wish!);
  } else {
    loops.adopting(session.adopt().catch(showProjectFault));
    arrive(wish, isAnother);
  }
});
viewer.addEventListener('field', (event) => {
  const { name, share } = event.detail;
  if (name !== 'igf') return;
  document.documentElement.dataset['field'] = share === 1 ? 'complete' : 'partial';
  if (share < 1) return;
  void recent.draw();
  void details.compare();
  tips.compute();
  limbs?.girthIsThere();
  necks.girthIsThere();
});
const explain = explainColours(viewer, () => print?.places !== undefined);

/** The page's own first model comes before all that somebody asks for. */
const atFirst = session.ask();
const recent = new RecentFiles(viewer, (files) => void openFiles(files));
acceptDrops(byId('drop'), (files) => void openFiles(files));
acceptLaunches((files) => void openFiles(files));
const plots = (): PagePlot[] =>
  [
    field,
    ...(measured ? [measured] : []),
    ...(limbs ? [limbs] : []),
    necks,
    parts,
    ...(compared ? [compared] : []),
  ].flatMap(({ plots }) => plots);
offerExports(viewer, computed, { parts, loops, limbs: showLimbs, necks }, plots, async () =>
  (await projects()).projectOf(viewer, session.opened!, store.shown, computed),
);
offerSharing(shared, async () => {
  const { webPage } = await import('./export/web-page.js');
  const page = new TextEncoder().encode(await webPage(viewer));
  saveFile(page, `${stemOf(viewer.info?.name ?? 'model')}.html`);
});

/** The forms in which others can have the view. */
function shared(): Shared {
  const { opened } = session;
  const { info } = viewer;
  const state = { ...viewer.state, ...necks.attributes };
  const fileName = opened?.link.file;
  const isPrepared =
    opened !== undefined && (Object.keys(session.read()).length > 1 || opened.model !== undefined);
  const lines = { element: undefined, frame: undefined };
  const about = { link: address.link, fileName, isPrepared };
  if (!opened || !info || isPrepared) return { ...about, ...lines };
  const fetched = typeof opened.source === 'string' ? opened.source : undefined;
  const embed = new URL('embed.html', location.href);
  embed.search = '';
  embed.hash = '';
  const title = `${info.name}: ${fieldTitle(viewer.shown?.name ?? 'none') || 'surface'}`;
  return {
    ...about,
    element: elementLine(fetched ?? info.name, state),
    frame: fetched && frameLine(embed.href, fetched, state, title),
  };
}

/** Lets a button choose files, or a folder. Returns what opens those that have been chosen. */
function choosesFiles(button: string, input: string): () => void {
  const chooser = byId<HTMLInputElement>(input);
  byId(button).addEventListener('click', () => chooser.click());
  const take = (): void => {
    const chosen = [...(chooser.files ?? [])];
    // A file may be chosen again after it was changed. Nobody types here.
    // oxlint-disable-next-line girth/shown-text
    chooser.value = '';
    if (chosen.length > 0) void openFiles(chosen);
  };
  chooser.addEventListener('change', take);
  return take;
}
const takeChosen = [choosesFiles('open', 'file'), choosesFiles('open-folder', 'folder')];

const explanation = byId<HTMLDialogElement>('explanation');
byId('help').addEventListener('click', () => explanation.showModal());
const tour = once(async () => {
  const { Tour } = await import('./help/tour.js');
  return new Tour(viewer, {
    begin: async () => {
      const octopus = examples.all.find(({ name }) => name === 'octopus');
      if (octopus && session.opened?.link.model !== octopus.name) await openExample(octopus);
    },
    open: (name) => panels[name].open(),
  });
});
byId('tour').addEventListener('click', () => {
  explanation.close();
  void tour().then((one) => one.start());
});
byId('folder').addEventListener('change', () => explanation.close());
explanation.addEventListener('click', (event) => {
  if (event.target === explanation) explanation.close();
});

// Whoever never asks for them does not fetch them.
byId('commands').addEventListener('click', () => {
  // Models that can be opened beside are among the commands.
  void Promise.all([palette(), beside()]).then(([one]) => one.open());
});
byId('all-keys').addEventListener('click', () => {
  explanation.close();
  void keyList().then((one) => one.open());
});
const palette = once(async () => new (await import('./commands/palette.js')).Palette(viewer));
const keyList = once(async () => new (await import('./commands/key-list.js')).KeyList(viewer));

// Explanations of terms are fetched with the first surface, or where somebody points before.
const explainTerms = once(async () => (await import('./help/explanation.js')).explainTerms());
for (const event of ['load', 'pointerover', 'focusin']) {
  const from = event === 'load' ? viewer : document;
  from.addEventListener(event, () => void explainTerms(), { once: true });
}
closeLeftSheets();
offerTheme(() => field.refresh());
offerInstalling();
// Files for later visits are fetched when this visit has what it needs.
const worksOffline = once(workOffline);
viewer.addEventListener('field', ({ detail }) => {
  if (detail.share === 1) void worksOffline();
});
setTimeout(() => void worksOffline(), 15_000);
// Files that are dropped before the examples are there are not lost to them.
const first = address.state;
store.ask(first, { isMissing: first.file !== undefined && first.model === undefined });
pressControls();
forwardKeys(viewer);
// Files may have been chosen before anybody listened.
for (const take of takeChosen) take();
await examples.prepare();
if (!session.isOvertaken(atFirst)) void follow(first, atFirst);
