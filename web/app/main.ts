// The drop page: one screen built on <girth-viewer>.

import type { FieldDetail, GirthViewer, LoadDetail } from '../src/element/index.js';
import '../src/element/index.js';
import { byId } from './dom.js';
import { acceptDrops } from './drop.js';
import { ExamplesStrip } from './examples-strip.js';
import { HistogramPanel } from './histogram-panel.js';
import { showModel } from './model-line.js';
import { listPinnedLoops } from './pinned-list.js';
import { offerColormaps } from './settings.js';

const viewer = byId<GirthViewer>('viewer');
const invitation = byId('invitation');
const histogram = new HistogramPanel(byId('histogram'), viewer);

const examples = new ExamplesStrip(byId('examples'), (address) => {
  // What went wrong is written on the surface by the element itself.
  viewer.load(address).catch(() => undefined);
});

function open(file: File): void {
  viewer
    .load(file)
    .then(() => {
      invitation.hidden = true;
      viewer.removeAttribute('turn');
      examples.choose(undefined);
    })
    .catch(() => undefined);
}

viewer.addEventListener('load', (event) => {
  const { info } = (event as CustomEvent<LoadDetail>).detail;
  showModel(byId('model'), info);
  histogram.clear();
  delete document.documentElement.dataset['field'];
});
viewer.addEventListener('progress', () => histogram.refreshSoon());
viewer.addEventListener('field', (event) => {
  histogram.refresh();
  const { share } = (event as CustomEvent<FieldDetail>).detail;
  document.documentElement.dataset['field'] = share === 1 ? 'complete' : 'partial';
});

acceptDrops(byId('drop'), open);
offerColormaps(viewer, () => histogram.refresh());
listPinnedLoops(viewer);

const file = byId<HTMLInputElement>('file');
byId('open').addEventListener('click', () => file.click());
file.addEventListener('change', () => {
  const chosen = file.files?.[0];
  // The same file may be chosen again after it was changed.
  file.value = '';
  if (chosen) open(chosen);
});

const explanation = byId<HTMLDialogElement>('explanation');
byId('help').addEventListener('click', () => explanation.showModal());
explanation.addEventListener('click', (event) => {
  if (event.target === explanation) explanation.close();
});

void examples.open();
