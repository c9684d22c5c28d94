// The drop page: one screen built on <girth-viewer>.

import type { FileWithPath, MeshSource, PrepareOptions } from '../src/kernel/index.js';
import {
  type FieldDetail,
  type GirthViewer,
  type LoadDetail,
  formatCount,
} from '../src/element/index.js';
import { byId } from './dom.js';
import { acceptDrops } from './drop.js';
import { ExamplesStrip } from './examples-strip.js';
import { offerExports } from './export-menu.js';
import { HistogramPanel } from './histogram-panel.js';
import { ModelDetails } from './model-details.js';
import { listPinnedLoops } from './pinned-list.js';
import { offerColormaps } from './settings.js';

/** A model that can be read again, to be prepared otherwise. */
interface Opened {
  source: MeshSource;
  model?: string;
  prepare: PrepareOptions;
  /** What was done to it after reading, in words. */
  remeshed?: string;
}

const viewer = byId<GirthViewer>('viewer');
const invitation = byId('invitation');
const histogram = new HistogramPanel(byId('histogram'), viewer);

/** What is shown, and what will be shown when the element has it. */
let opened: Opened | undefined;
let next: Opened | undefined;

/** Shows a model; what goes wrong is written on the surface by the element itself. */
async function open(wanted: Opened): Promise<boolean> {
  next = wanted;
  const { source, model, prepare } = wanted;
  const options = model === undefined ? { prepare } : { prepare, model };
  return viewer.load(source, options).then(
    () => true,
    () => false,
  );
}

function remesh(faces: number): void {
  if (!opened || !viewer.info) return;
  const before = formatCount(opened.remeshed ? viewer.original!.faceCount : viewer.info.faceCount);
  next = { ...opened, remeshed: `remeshed from ${before} to about ${formatCount(faces)} faces` };
  viewer.remesh(faces).catch(() => undefined);
}

const details = new ModelDetails(viewer, {
  choose: (model) => opened && void open({ source: opened.source, model, prepare: {} }),
  prepare: (change) =>
    opened && void open({ ...opened, prepare: { ...opened.prepare, ...change } }),
  remesh,
  back: () => {
    if (!opened) return;
    const { source, model } = opened;
    void open(model === undefined ? { source, prepare: {} } : { source, model, prepare: {} });
  },
});

const examples = new ExamplesStrip(byId('examples'), (address) => {
  void open({ source: address, prepare: {} });
});

async function openFiles(files: readonly (File | FileWithPath)[]): Promise<void> {
  const source = files.length === 1 && files[0] instanceof File ? files[0] : files;
  if (!(await open({ source, prepare: {} }))) return;
  invitation.hidden = true;
  viewer.removeAttribute('turn');
  examples.choose(undefined);
}

viewer.addEventListener('load', (event) => {
  const { info } = (event as CustomEvent<LoadDetail>).detail;
  // A unit that was chosen stays with its model, however that is prepared.
  const isOther = opened?.source !== next?.source || opened?.model !== next?.model;
  if (isOther) viewer.removeAttribute('unit');
  opened = next;
  const { prepare = {}, remeshed } = opened ?? {};
  details.show(info, remeshed === undefined ? { prepare } : { prepare, remeshed });
  histogram.clear();
  delete document.documentElement.dataset['field'];
});
viewer.addEventListener('progress', () => histogram.refreshSoon());
viewer.addEventListener('unit', () => histogram.refresh());
viewer.addEventListener('field', (event) => {
  histogram.refresh();
  const { share } = (event as CustomEvent<FieldDetail>).detail;
  document.documentElement.dataset['field'] = share === 1 ? 'complete' : 'partial';
  if (share === 1) void details.compare();
});

acceptDrops(byId('drop'), (files) => void openFiles(files));
offerColormaps(viewer, () => histogram.refresh());
listPinnedLoops(viewer);
offerExports(viewer);

/** Lets a button choose files, or a folder. */
function choosesFiles(button: string, input: string): void {
  const chooser = byId<HTMLInputElement>(input);
  byId(button).addEventListener('click', () => chooser.click());
  chooser.addEventListener('change', () => {
    const chosen = [...(chooser.files ?? [])];
    // The same file may be chosen again after it was changed.
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

void examples.open();
