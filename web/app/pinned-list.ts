// The pinned loops, each with its length and a cross.

import { type GirthViewer, type PinnedLoop, formatLength, make } from '../src/element/index.js';
import { byId } from './dom.js';

function row(viewer: GirthViewer, { id, loop }: PinnedLoop): HTMLElement {
  const length = formatLength(loop.length, viewer.lengthFormat);
  const remove = make(
    'button',
    { type: 'button', 'aria-label': `Remove loop ${id}, ${length}`, title: 'Remove' },
    '✕',
  );
  remove.addEventListener('click', () => viewer.unpin(id));
  const { base, kind } = loop;
  const place = typeof base === 'number' ? `vertex ${base}` : `face ${base.face}`;
  const words = { loop: place, antipodal: 'there and back', unresolved: 'or more' }[kind];
  return make(
    'li',
    {},
    make('i', {}, String(id)),
    make('b', {}, length),
    make('span', {}, words),
    remove,
  );
}

/** Keeps the list as the element has it. */
export function listPinnedLoops(viewer: GirthViewer): void {
  const list = byId('loops');
  const hint = byId('no-loops');
  const refresh = (): void => {
    list.replaceChildren(...viewer.pinned.map((pinned) => row(viewer, pinned)));
    hint.hidden = viewer.pinned.length > 0;
  };
  for (const event of ['load', 'unit', 'field', 'pick']) viewer.addEventListener(event, refresh);
}
