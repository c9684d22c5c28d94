// The drop page: one screen built on <girth-viewer>.

import type { FileWithPath } from '../src/kernel/index.js';
import { type FieldDetail, type GirthViewer, type LoadDetail } from '../src/element/index.js';
import { type PageState, type PanelName, panelNames, writeState } from './address-state.js';
import { Address } from './address.js';
import { ComparePanel } from './compare-panel.js';
import { ComputedFields } from './computed-fields.js';
import { byId } from './dom.js';
import { acceptDrops } from './drop.js';
import { type Example, ExamplesStrip } from './examples-strip.js';
import { offerExports } from './export-menu.js';
import { FieldPanel } from './field-panel.js';
import { ModelDetails } from './model-details.js';
import type { Panel } from './panel.js';
import { PartsPanel } from './parts-panel.js';
import { PinnedList } from './pinned-list.js';
import { PrintPanel } from './print-panel.js';
import { type Opened, Session } from './session.js';
import { offerLink } from './share-sheet.js';
import { explainTerms } from './terms.js';
import { TipsPanel } from './tips-panel.js';

const viewer = byId<GirthViewer>('viewer');
const invitation = byId('invitation');
const session = new Session(viewer);
const computed = new ComputedFields(viewer);
const changed = (): void => address.changed();

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
const parts = new PartsPanel(viewer, {
  changed,
  found: () => field.refresh(),
  colour: (wanted) => field.colourForPanel('parts', wanted),
});
const print = new PrintPanel(viewer, changed);
const compare = new ComparePanel({
  present: () => session.opened && { opened: session.opened, name: viewer.info?.name ?? '' },
  gallery: () =>
    examples.all.map((example) => ({ opened: exampleToOpen(example), name: example.file })),
  show: (opened) => void session.open(opened),
  changed,
});
const panels: Record<PanelName, Panel> = {
  loops: loops.panel,
  tips: tips.panel,
  parts: parts.panel,
  print: print.panel,
  compare: compare.panel,
};

// ---- what is shown, and the address that holds it

/** What a link asks for, until the model that it is about is there. */
let wanted: PageState | undefined;
/** From where the model was seen at first: only another view is worth being in a link. */
let home = '';

function read(): PageState {
  const state: PageState = {
    ...session.read(),
    ...field.read(),
    ...tips.read(),
    ...parts.read(),
    ...loops.read(),
  };
  if (!viewer.info?.unit && viewer.unit) state.unit = viewer.unit;
  const { camera } = viewer;
  if (camera && writeState({ camera }) !== home) state.camera = camera;
  const open = panelNames.find((name) => panels[name].isOpen);
  if (open && open !== 'loops') state.panel = open;
  return state;
}

/** Brings about what a link asks for, on the model that is shown. */
function apply(state: PageState): void {
  if (!viewer.info?.unit && state.unit) viewer.setAttribute('unit', state.unit);
  field.apply(state);
  tips.apply(state);
  parts.apply(state);
  panels[state.panel ?? 'loops'].open();
  if (state.camera) viewer.camera = state.camera;
  address.settle();
  void address.during(loops.apply(state));
}

/** Opens the model that a link names, or the first example, and then applies the rest. */
async function go(state: PageState): Promise<void> {
  if (viewer.info && session.isOf(state)) {
    apply(state);
    return;
  }
  const example = examples.all.find(({ name }) => name === state.model) ?? examples.all[0];
  const isAddress = state.model?.includes(':') ?? false;
  if (state.file !== undefined && state.model === undefined) {
    // A link cannot have a file in it: wait for it, with an example meanwhile.
    invitation.textContent = `Drop ${state.file} here to see it as in the link.`;
    if (!viewer.info && example) await openExample(example);
    wanted = state;
    return;
  }
  wanted = state;
  const prepare = {
    ...(state.closed ? { closeHoles: true } : {}),
    ...(state.components ? { components: state.components } : {}),
  };
  if (isAddress)
    await session.open({ source: state.model!, link: { model: state.model! }, prepare });
  else if (example) await openExample(example, prepare);
}

const address = new Address(read, (state) => void address.during(go(state)));

// ---- opening models

const details = new ModelDetails(viewer, {
  choose: (model) => session.choose(model),
  prepare: (change) => session.reopen(change),
  remesh: (faces) => void session.remesh(faces),
  back: () => session.back(),
});

const examples = new ExamplesStrip(byId('examples'), (example) => {
  wanted = undefined;
  void openExample(example);
});

function exampleToOpen(example: Example, prepare = {}): Opened {
  return { source: examples.addressOf(example), link: { model: example.name }, prepare };
}

async function openExample(example: Example, prepare = {}): Promise<void> {
  examples.mark(example);
  await session.open(exampleToOpen(example, prepare));
}

async function openFiles(files: readonly (File | FileWithPath)[]): Promise<void> {
  const source = files.length === 1 && files[0] instanceof File ? files[0] : files;
  const names = files.map((file) => (file instanceof File ? file.name : file.path));
  if (!names.some((name) => name === wanted?.file)) wanted = undefined;
  const file = wanted?.file ?? names[0]!;
  if (!(await session.open({ source, link: { file }, prepare: {} }))) return;
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
  }
}

viewer.addEventListener('load', (event) => {
  const { info } = (event as CustomEvent<LoadDetail>).detail;
  // A unit that was chosen stays with its model, however that is prepared.
  if (session.arrived()) viewer.removeAttribute('unit');
  const { prepare = {}, remeshed, link } = session.opened ?? {};
  examples.mark(examples.all.find(({ name }) => name === link?.model));
  details.show(info, remeshed === undefined ? { prepare } : { prepare, remeshed: remeshed.words });
  home = viewer.camera ? writeState({ camera: viewer.camera }) : '';
  for (const panel of [field, tips, parts, print]) panel.clear();
  delete document.documentElement.dataset['field'];
  if (wanted?.faces !== undefined && remeshed?.faces !== wanted.faces) {
    void session.remesh(wanted.faces);
    return;
  }
  // A file's link is for the file, not for the example that is there meanwhile.
  if (wanted && (wanted.model !== undefined || link?.file === wanted.file)) {
    const state = wanted;
    wanted = undefined;
    apply(state);
  } else changed();
});
viewer.addEventListener('field', (event) => {
  const { name, share } = (event as CustomEvent<FieldDetail>).detail;
  if (name !== 'igf') return;
  document.documentElement.dataset['field'] = share === 1 ? 'complete' : 'partial';
  if (share < 1) return;
  void details.compare();
  void tips.compute();
});
for (const event of ['camera', 'unit']) viewer.addEventListener(event, changed);

acceptDrops(byId('drop'), (files) => void openFiles(files));
offerExports(viewer, computed, parts);
offerLink(
  () => address.link,
  () => session.opened?.link.file,
);

/** Lets a button choose files, or a folder. */
function choosesFiles(button: string, input: string): void {
  const chooser = byId<HTMLInputElement>(input);
  byId(button).addEventListener('click', () => chooser.click());
  chooser.addEventListener('change', () => {
    const chosen = [...(chooser.files ?? [])];
    // The same file may be chosen again after it was changed. Nobody types here.
    // eslint-disable-next-line no-restricted-syntax
    chooser.value = '';
    if (chosen.length > 0) void openFiles(chosen);
  });
}
choosesFiles('open', 'file');
choosesFiles('open-folder', 'folder');

const explanation = byId<HTMLDialogElement>('explanation');
byId('help').addEventListener('click', () => explanation.showModal());
byId('folder').addEventListener('change', () => explanation.close());
explanation.addEventListener('click', (event) => {
  if (event.target === explanation) explanation.close();
});

explainTerms();
await examples.prepare();
void address.during(go(address.state));
