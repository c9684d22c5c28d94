// The drop page: one screen built on <girth-viewer>.

import type { FileWithPath } from '../src/kernel/index.js';
import { type GirthViewer, fieldTitle, sentence } from '../src/element/index.js';
import {
  type PageState,
  type PanelName,
  besideOf,
  panelNames,
  preparationOf,
  resized,
} from './state/address-state.js';
import { Address } from './state/address.js';
import type { Beside } from './model/beside.js';
import { ComparePanel } from './panels/compare/compare-panel.js';
import { ComputedFields } from './model/computed-fields.js';
import { byId, nextTask, once, setAttribute } from './widgets/dom.js';
import { type Files, acceptDrops } from './model/drop.js';
import { type Example, ExamplesStrip } from './model/examples-strip.js';
import { offerExports } from './export/export-menu.js';
import { failureWords } from './widgets/failure-words.js';
import { FieldPanel } from './panels/field/field-panel.js';
import { removalWords } from './panels/necks/handle-removal.js';
import { acceptLaunches } from './model/launch.js';
import { LimbsPanel } from './panels/limbs/limbs-panel.js';
import { NecksPanel } from './panels/necks/necks-panel.js';
import { explainColours, showUntilTouched } from './help/meaning.js';
import { MissingModel } from './model/missing-model.js';
import { forwardKeys, pressControls } from './commands/keys.js';
import { ModelDetails } from './model/model-details.js';
import { offerInstalling, workOffline } from './offline.js';
import type { PagePlot } from './export/page-plot.js';
import type { Panel } from './widgets/panel.js';
import type { OpenedProject } from './model/project.js';
import { PartsPanel } from './panels/parts/parts-panel.js';
import { PinnedList } from './panels/loops/pinned-list.js';
import { PrintPanel } from './panels/print/print-panel.js';
import { RecentFiles } from './model/recent-files.js';
import { type Opened, Session, isSameModel } from './model/session.js';
import { elementLine, frameLine } from './export/share-lines.js';
import { type Shared, offerSharing } from './export/share-sheet.js';
import { closeLeftSheets } from './widgets/sheets.js';
import type { ModelScale } from './model/size-choice.js';
import { explainTerms } from './help/terms.js';
import { offerTheme } from './theme.js';
import { TipsPanel } from './panels/tips/tips-panel.js';
import { Tour } from './help/tour.js';
import { offerUndo } from './state/undo-buttons.js';

const viewer = byId<GirthViewer>('viewer');
const invitation = byId('invitation');
const projectFault = byId('project-fault');
const session = new Session(viewer);
const computed = new ComputedFields(viewer);
/** Whether all of the page is there: before, nothing is shown whose address could change. */
let isBuilt = false;
const changed = (): void => {
  if (isBuilt) address.changed();
};

// Until somebody does something the page shows by itself what it is about.
let isUntouched = true;
viewer.addEventListener('touch', () => (isUntouched = false));

// What takes long is done in several tasks, between which the page answers.
await nextTask();
const field = new FieldPanel(viewer, computed, {
  changed,
  partKinds: () => parts.kinds,
  tipRises: () => tips.rises,
});
const loops = new PinnedList(viewer, changed);
const tips = new TipsPanel(viewer, {
  changed,
  found: () => field.refresh(),
  colour: (bySdf) => field.colourForPanel('sdf', bySdf),
});
await nextTask();
const limbs = new LimbsPanel(viewer, changed);
const necks = new NecksPanel(viewer, {
  changed,
  removeHandles: (length) => session.removeHandles(length),
});
const parts = new PartsPanel(viewer, {
  changed,
  found: () => field.refresh(),
  colour: (wanted) => field.colourForPanel('parts', wanted),
});
const size: ModelScale = {
  get scale() {
    return session.scale;
  },
  rescale: (scale) => {
    if (!session.opened) return;
    // What is shown of it is the same in the other size.
    wanted = { ...resized(read(), scale / session.scale), scale };
    isByHand = true;
    const weldDistance = wanted.weld;
    session.reopen({ scale, ...(weldDistance === undefined ? {} : { weldDistance }) });
  },
};
const print = new PrintPanel(viewer, size, changed, () => explain());
const compare = new ComparePanel({
  present: () => session.opened && { opened: session.opened, name: viewer.info?.name ?? '' },
  gallery: () =>
    examples.all.map((example) => ({ opened: exampleToOpen(example), name: example.file })),
  fieldOf: (opened, name) => {
    const isShown = session.opened && isSameModel(session.opened, opened);
    // Of every model the page computes the girth.
    return isShown && (name === 'igf' || computed.has(name)) ? viewer.fieldOf(name) : undefined;
  },
  show: (opened) => void session.open(opened),
  showBeside: (opened) => void beside().then((one) => one.open(opened)),
  changed,
});
const panels: Record<PanelName, Panel> = {
  loops: loops.panel,
  tips: tips.panel,
  limbs: limbs.panel,
  necks: necks.panel,
  parts: parts.panel,
  print: print.panel,
  compare: compare.panel,
};

await nextTask();

/** What is shown beside the model, once that was asked for. */
let second: Beside | undefined;
/** Until it is there, what a link asks for. */
let besideWish: PageState = {};
const beside = once(async () => {
  const { Beside } = await import('./model/beside.js');
  return (second = new Beside(viewer, {
    gallery: () =>
      examples.all.map((example) => ({ opened: exampleToOpen(example), title: example.title })),
    openedBefore: (file) => session.openedBefore(file),
    changed,
  }));
});
byId('beside-menu').addEventListener('beforetoggle', () => void beside());

// ---- what is shown, and the address that holds it

/** What a link asks for, until the model that it is about is there. */
let wanted: PageState | undefined;

function read(): PageState {
  // As long as the model of a link is missing, the link is all there is.
  if (wanted && !viewer.info) return wanted;
  const state: PageState = {
    ...session.read(),
    ...field.read(),
    ...tips.read(),
    ...parts.read(),
    ...print.read(),
    ...limbs.read(),
    ...necks.read(),
    ...loops.read(),
    ...(second?.read() ?? besideWish),
  };
  if (!viewer.info?.unit && viewer.unit) state.unit = viewer.unit;
  if (state.file !== undefined && state.loops) state.values = loops.values;
  if (viewer.shownUnit) state.shown = viewer.shownUnit;
  const { camera } = viewer;
  // The first view of a model needs no words, nor does one that passes by.
  if (camera && !viewer.isAtHome && !viewer.isTurning) state.camera = camera;
  const up = viewer.getAttribute('up');
  if (up) state.up = up;
  for (const name of ['shading', 'section'] as const) {
    const text = viewer.getAttribute(name);
    if (text) state[name] = text;
  }
  const open = panelNames.find((name) => panels[name].isOpen);
  if (open && open !== 'loops') state.panel = open;
  return state;
}

/** Whether what is wanted was asked for by hand: then the address does not have it yet. */
let isByHand = false;

/** Brings about what a link asks for, on the model that is shown; `known`: loops that need not be computed are pinned then. */
function apply(state: PageState, known: Promise<unknown> = Promise.resolve()): void {
  if (!viewer.info?.unit && state.unit) viewer.setAttribute('unit', state.unit);
  if (state.shown) viewer.setAttribute('shown-unit', state.shown);
  for (const name of ['up', 'shading', 'section'] as const) setAttribute(viewer, name, state[name]);
  field.apply(state);
  tips.apply(state);
  parts.apply(state);
  print.apply(state);
  limbs.apply(state);
  necks.apply(state);
  panels[state.panel ?? 'loops'].open();
  if (state.camera) viewer.camera = state.camera;
  besideWish = besideOf(state);
  if (second ?? state.beside ?? state.besideFile) {
    void address.during(beside().then((one) => one.apply(besideOf(state))));
  }
  if (!isByHand) address.settle();
  isByHand = false;
  void address.during(known.then(() => loops.apply(state)));
}

/** Opens the model that a link names, or the first example, and then applies the rest. */
async function go(state: PageState, asked = session.ask()): Promise<void> {
  if (viewer.info && session.isOf(state)) {
    apply(state);
    return;
  }
  if (viewer.info && session.isBefore(state)) {
    wanted = state;
    await session.restore();
    return;
  }
  if (
    viewer.info &&
    state.handles !== undefined &&
    session.isOf({ ...state, handles: undefined })
  ) {
    await repair(state);
    return;
  }
  const example = examples.all.find(({ name }) => name === state.model) ?? examples.all[0];
  const isAddress = state.model?.includes(':') ?? false;
  if (state.file !== undefined && state.model === undefined) {
    wanted = state;
    const before = session.openedBefore(state.file);
    if (before) {
      await session.open({ ...before, prepare: preparationOf(state) }, asked);
      return;
    }
    // A link cannot have a file in it: wait for it.
    invitation.hidden = true;
    missing.show(state, !viewer.info);
    return;
  }
  wanted = state;
  const prepare = preparationOf(state);
  if (isAddress) {
    const link = { model: state.model! };
    await session.open({ source: state.model!, link, prepare }, asked);
  } else if (example) await openExample(example, prepare, asked);
}

/** Takes the handles away that a link's surface has not, and then applies the rest. */
async function repair(state: PageState): Promise<void> {
  wanted = state;
  const removal = await session.removeHandles(state.handles!);
  // Where something was taken away, the surface that is left has come as another model does.
  if (removal && removal.removed.length > 0) return;
  wanted = undefined;
  apply(state);
}

const address: Address = new Address(
  read,
  (state) => void address.during(go(state)),
  () => showUndo(),
);
const showUndo = offerUndo(address);

// ---- opening models

const details = new ModelDetails(viewer, {
  choose: (model) => session.choose(model),
  size,
  prepare: (change) => session.reopen(change),
  remesh: (faces) => {
    if (session.canRemesh) {
      void session.remesh(faces);
      return;
    }
    const { handles, ...rest } = read();
    void handles;
    wanted = { ...rest, faces };
    isByHand = true;
    session.reopen({});
  },
  back: () => session.back(),
});

const missing = new MissingModel(() => byId<HTMLInputElement>('file').click());

const examples = new ExamplesStrip(byId('examples'), (example) => {
  address.flush();
  wanted = undefined;
  void openExample(example);
});

function exampleToOpen(example: Example, prepare = {}): Opened {
  return { source: examples.addressOf(example), link: { model: example.name }, prepare };
}

async function openExample(example: Example, prepare = {}, asked = session.ask()): Promise<void> {
  projectFault.hidden = true;
  examples.mark(example);
  await session.open(exampleToOpen(example, prepare), asked);
}

/** Opens files, or those that are found in a folder or on the disk, if there are any. What was asked for later stays. */
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
  if (!names.some((name) => name === wanted?.file)) wanted = undefined;
  const file = wanted?.file ?? names[0]!;
  const prepare = preparationOf(wanted ?? {});
  if (!(await session.open({ source, link: { file }, prepare }, asked))) return;
  recent.opened(files);
  invitation.hidden = true;
  viewer.removeAttribute('turn');
  const { models, unreadable } = viewer.info!;
  if (models.length > 1) {
    session.name(models.find((path) => !unreadable.some(({ model }) => model === path))!);
    changed();
    compare.add(
      models.map((model) => ({
        opened: { source, link: { file: model }, model, prepare: {} },
        name: model,
      })),
    );
    compare.panel.reveal();
  }
}

/** Attributes that are about one model. */
const aboutModel = ['unit', 'shown-unit', 'up', 'section'];
/** The project that is being opened: what was computed is taken when its surface is there. */
let project: OpenedProject | undefined;
const projects = once(() => import('./model/project.js'));

function showProjectFault(error: unknown): void {
  projectFault.textContent = sentence(failureWords(error));
  projectFault.hidden = false;
}

/** Opens a zip as a project; false where it is none. What was asked for later, and has been opened meanwhile, stays. */
async function openProject(file: File | FileWithPath, asked: number): Promise<boolean> {
  const { projectIn } = await projects();
  const read = await projectIn(file).catch((error: unknown) => {
    if (!session.isOvertaken(asked)) showProjectFault(error);
  });
  if (session.isOvertaken(asked)) return true;
  if (!read) return false;
  const { name, source, model, state } = read;
  project = read;
  wanted = state;
  isByHand = true;
  const prepare = preparationOf(state);
  if (!(await session.open({ source, link: { file: name }, model, prepare }, asked))) {
    // Nothing is left of it for what is opened next.
    if (project === read) {
      project = wanted = undefined;
      isByHand = false;
    }
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
  if (isAnother) for (const name of aboutModel) viewer.removeAttribute(name);
  const { prepare = {}, remeshed, handles, link } = session.opened ?? {};
  examples.mark(examples.all.find(({ name }) => name === link?.model));
  const { removal } = viewer;
  const made = [
    ...(remeshed ? [remeshed.words] : []),
    ...(removal ? [`short handles taken away: ${removalWords(removal)}`] : []),
  ];
  details.show(info, { prepare, made });
  for (const panel of [field, tips, limbs, necks, parts]) panel.clear();
  print.clear(isAnother);
  document.title = `${info.name} – Girth`;
  delete document.documentElement.dataset['field'];
  if (wanted?.faces !== undefined && remeshed?.faces !== wanted.faces) {
    void address.during(session.remesh(wanted.faces));
    return;
  }
  const isWanted = wanted && (wanted.model !== undefined || link?.file === wanted.file);
  if (wanted?.handles !== undefined && isWanted && handles === undefined) {
    void address.during(repair(wanted));
    return;
  }
  // A file's link is for the file, not for the example that is there meanwhile.
  const known = link?.file === project?.name ? project?.adopt(viewer) : undefined;
  project = undefined;
  if (wanted && isWanted) {
    const state = wanted;
    wanted = undefined;
    apply(state, known?.catch(showProjectFault));
  } else changed();
});
/** Persistence and method of the girth that panels have searched by. */
let searchedWith = '';
viewer.addEventListener('field', (event) => {
  const { name, share } = event.detail;
  if (name !== 'igf') return;
  document.documentElement.dataset['field'] = share === 1 ? 'complete' : 'partial';
  if (share < 1) return;
  const girth = ['persistence', 'method'].map((name) => viewer.getAttribute(name)).join();
  // What was found by another girth is out of date.
  if (girth !== searchedWith) {
    limbs.forget();
    necks.forget();
  }
  searchedWith = girth;
  void recent.draw();
  void details.compare();
  void tips.compute();
  limbs.girthIsThere();
  necks.girthIsThere();
  if (isUntouched) void showUntilTouched(viewer);
});
const explain = explainColours(viewer, () => print.isColouring);
for (const event of ['camera', 'unit', 'view']) viewer.addEventListener(event, changed);

/** What the page opens by itself comes before all that somebody asks for. */
const atFirst = session.ask();
const recent = new RecentFiles(viewer, (files) => void openFiles(files));
acceptDrops(byId('drop'), (files) => void openFiles(files));
acceptLaunches((files) => void openFiles(files));
const plots = (): PagePlot[] =>
  [field, limbs, necks, parts, compare].flatMap((panel) => panel.plots);
offerExports(viewer, computed, { parts, loops, limbs, necks }, plots, async () =>
  (await projects()).projectOf(viewer, session.opened!, read(), computed),
);
offerSharing(shared);

/** What others can have of what is shown. */
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
    // The same file may be chosen again after it was changed. Nobody types here.
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
const tour = new Tour(viewer, {
  begin: async () => {
    const octopus = examples.all.find(({ name }) => name === 'octopus');
    if (octopus && session.opened?.link.model !== octopus.name) await openExample(octopus);
  },
  open: (name) => panels[name].open(),
});
byId('tour').addEventListener('click', () => {
  explanation.close();
  void tour.start();
});
byId('folder').addEventListener('change', () => explanation.close());
explanation.addEventListener('click', (event) => {
  if (event.target === explanation) explanation.close();
});

// Whoever never asks for them does not fetch them.
byId('commands').addEventListener('click', () => {
  // What can be opened beside the model is among the commands.
  void Promise.all([palette(), beside()]).then(([one]) => one.open());
});
byId('all-keys').addEventListener('click', () => {
  explanation.close();
  void keyList().then((one) => one.open());
});
const palette = once(async () => new (await import('./commands/palette.js')).Palette(viewer));
const keyList = once(async () => new (await import('./commands/key-list.js')).KeyList(viewer));

explainTerms();
closeLeftSheets();
offerTheme(() => field.refresh());
offerInstalling();
// What is kept for later visits is fetched when this one has what it needs.
const worksOffline = once(workOffline);
viewer.addEventListener('field', ({ detail }) => {
  if (detail.share === 1) void worksOffline();
});
setTimeout(() => void worksOffline(), 15_000);
// Files that are dropped before the examples are there are not lost to them.
const first = address.state;
if (first.file !== undefined && first.model === undefined) wanted = first;
pressControls();
forwardKeys(viewer);
isBuilt = true;
// What was chosen before anybody listened.
for (const take of takeChosen) take();
await examples.prepare();
if (!session.isOvertaken(atFirst)) void address.during(go(first, atFirst));
