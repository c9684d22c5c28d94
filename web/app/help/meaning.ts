// The meaning of the colours in one line on the surface; and a loop that shows itself until
// somebody does something.

import {
  type ColormapName,
  type GirthViewer,
  type GirthViewerEvents,
  type ShownName,
  combinationOf,
  fieldTitle,
  inSentence,
} from '../../src/element/index.js';
import { type MeshGeometry, fieldMeanings } from '../../src/kernel/index.js';
import { byId } from '../widgets/dom.js';

const words: Partial<Record<ShownName, string>> = {
  ...fieldMeanings,
  kind: 'whether a loop holds in a place, or slips off',
  state: 'how sure the loop’s length is',
  tips: 'how far the loop’s length jumps where it slips off',
  parts: 'what is thin like a tube, thin like a plate, or neither',
};

/** Vertices, at most, of a surface that the loop slides over: more would hold up the page. */
const mostVertices = 150_000;
/** Milliseconds that the loop rests at each place. */
const pace = 70;

/** The meaning of the print check's colours, which stand in place of a field. */
const printWords = 'what is too thin to print, and what is thick enough';

/** The meaning of the girth where it jumps: why ends of limbs have the colours of thick parts. */
const jumpingWords =
  'the length of the shortest loop; at tips loops slip off, so their bright ends are not thick';

/**
 * Whether the girth jumps along an edge. Where it does not, it changes by at most twice the edge's length; a little more is
 * rounding.
 */
function jumps(girth: Float64Array, { positions, indices }: MeshGeometry): boolean {
  for (let i = 0; i < indices.length; ++i) {
    // Without lists: a surface may have millions of edges.
    const u = indices[i]!;
    const v = indices[i % 3 === 2 ? i - 2 : i + 1]!;
    const x = positions[3 * u]! - positions[3 * v]!;
    const y = positions[3 * u + 1]! - positions[3 * v + 1]!;
    const z = positions[3 * u + 2]! - positions[3 * v + 2]!;
    const change = Math.abs(girth[u]! - girth[v]!);
    if (change > 2.1 * Math.sqrt(x * x + y * y + z * z)) return true;
  }
  return false;
}

/** The meaning of two fields combined in one; undefined for a single field. */
function ofTwo(name: ShownName, colormap: ColormapName | undefined): string | undefined {
  const combined = combinationOf(name);
  if (!combined) return undefined;
  const [first, second] = [combined.first, combined.second].map(fieldTitle).map(inSentence);
  if (combined.by === 'ratio') return `the ${first}, divided by the ${second}`;
  const sides = colormap === 'rdbu' ? ': red where it is more, blue where it is less' : '';
  return `the ${first} less the ${second}${sides}`;
}

/** Keeps the line up to date; returns a function to call when the print check has other colours. */
export function explainColours(viewer: GirthViewer, isPrint: () => boolean): () => void {
  const line = byId('meaning');
  /** The model whose girth was looked at; and the same, where the girth jumps. */
  let seen: object | undefined;
  let slipping: object | undefined;
  const look = async (): Promise<void> => {
    const { info } = viewer;
    if (!info || seen === info || viewer.shareOf('igf') < 1) return;
    seen = info;
    const { values } = await viewer.fieldOf('igf');
    if (viewer.info !== info || !jumps(values, viewer.geometry)) return;
    slipping = info;
    write();
  };
  const write = (): void => {
    // A failure is reported where it occurs.
    look().catch(() => undefined);
    const { name, colormap } = viewer.shown ?? {};
    const own = name === 'igf' && viewer.info && slipping === viewer.info ? jumpingWords : '';
    const known = name && (own || words[name] || ofTwo(name, colormap));
    const meaning = isPrint() ? printWords : known;
    const text = meaning ? `Colours: ${meaning}.` : '';
    if (line.textContent !== text) line.textContent = text;
  };
  for (const event of ['fieldchange', 'field', 'progress']) viewer.addEventListener(event, write);
  return write;
}

/**
 * Until the surface is touched, shows a loop when the girth is there: it slides along the surface and back, or rests
 * where the system asks for less motion.
 */
export function showUntilTouched(viewer: GirthViewer): void {
  const touched = new AbortController();
  const { signal } = touched;
  viewer.addEventListener('touch', () => touched.abort(), { signal });
  const show = ({ detail: { name, share } }: GirthViewerEvents['field']): void => {
    if (name === 'igf' && share === 1) void showLoop(viewer);
  };
  viewer.addEventListener('field', show, { signal });
}

/** Shows the loop until something is done on the page. */
async function showLoop(viewer: GirthViewer): Promise<void> {
  if ((viewer.info?.vertexCount ?? 0) > mostVertices) return;
  const ending = new AbortController();
  const { signal } = ending;
  const end = (): void => ending.abort();
  for (const type of ['pointermove', 'pointerdown', 'keydown', 'wheel', 'touchstart']) {
    window.addEventListener(type, end, { signal, capture: true, passive: true });
  }
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) restLoop(viewer, signal);
  else await slideLoop(viewer, signal);
}

/**
 * Hides the shown loop as the signal comes: what ends it may itself ask for a loop, which a later end would hide.
 */
function hideAtEnd(viewer: GirthViewer, signal: AbortSignal): void {
  const { info } = viewer;
  signal.addEventListener('abort', () => {
    if (viewer.info === info) viewer.showLoop();
  });
}

/** Shows the loop half-way along the surface, or where one is seen next to it, until the signal. */
function restLoop(viewer: GirthViewer, signal: AbortSignal): void {
  const way = viewer.longWay();
  const middle = (way.length - 1) / 2;
  const seen = way.map((_, i) => i).filter((i) => viewer.screenPosition(way[i]!).visible);
  const fromMiddle = (i: number): number => Math.abs(i - middle);
  seen.sort((i, j) => fromMiddle(i) - fromMiddle(j));
  viewer.showLoop(way[seen[0] ?? Math.floor(middle)], { quiet: true });
  hideAtEnd(viewer, signal);
}

/** Slides a loop along the surface and back, until the signal or another model. */
export async function slideLoop(viewer: GirthViewer, signal: AbortSignal): Promise<void> {
  const { info } = viewer;
  const way = viewer.longWay();
  hideAtEnd(viewer, signal);
  for (let i = 0, step = 1; !signal.aborted && way.length > 1; i += step) {
    if (viewer.info !== info) return;
    if (i + step < 0 || i + step >= way.length) step = -step;
    viewer.showLoop(way[i], { quiet: true });
    await new Promise((rested) => setTimeout(rested, pace));
  }
}
