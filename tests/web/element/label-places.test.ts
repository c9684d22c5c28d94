// Where labels stand on the canvas.

import { expect, test } from 'vitest';
import { type Label, placeLabels } from '../../../web/src/element/surface/label-places.js';
import { type Box, Silhouette } from '../../../web/src/view/silhouette.js';

const canvas = { width: 400, height: 300 };
const taken = (...boxes: Box[]): Silhouette => {
  const silhouette = new Silhouette(canvas.width, canvas.height, 8);
  for (const box of boxes) silhouette.add(box);
  return silhouette;
};
const body = { left: 120, top: 40, width: 160, height: 220 };
const label = (about: Box, before?: Label['before']): Label => ({
  about,
  width: 90,
  height: 28,
  before,
});
const boxOf = (place: { left: number; top: number }): Box => ({ ...place, width: 90, height: 28 });
const overlap = (a: Box, b: Box): boolean =>
  a.left < b.left + b.width &&
  b.left < a.left + a.width &&
  a.top < b.top + b.height &&
  b.top < a.top + a.height;

test('a label stands beside the body, at the height of what it is about', () => {
  const about = { left: 150, top: 140, width: 40, height: 10 };
  const [place] = placeLabels([label(about)], taken(body), canvas);
  expect(overlap(boxOf(place!), body)).toBe(false);
  // The left side is nearer.
  expect(place!.left + 90).toBeLessThanOrEqual(120);
  expect(Math.abs(place!.top + 14 - 145)).toBeLessThan(16);
});

test('several labels of one place stand clear of each other, of the body and of what else is there', () => {
  const legend = { left: 0, top: 180, width: 110, height: 120 };
  const about = { left: 150, top: 140, width: 40, height: 10 };
  const labels = [label(about), label(about), label(about)];
  const boxes = placeLabels(labels, taken(body, legend), canvas).map(boxOf);
  boxes.forEach((box, i) => {
    for (const other of [body, legend, ...boxes.slice(0, i)])
      expect(overlap(box, other)).toBe(false);
    expect(box.left).toBeGreaterThanOrEqual(0);
    expect(box.left + box.width).toBeLessThanOrEqual(canvas.width);
  });
});

test('a label that is clear stays where it is while the body moves, and leaves when it is covered', () => {
  const about = { left: 150, top: 140, width: 40, height: 10 };
  const [first] = placeLabels([label(about)], taken(body), canvas);
  const moved = { ...about, top: 160 };
  const [second] = placeLabels([label(moved, first)], taken(body), canvas);
  expect(second).toEqual(first);
  const wider = { ...body, left: 60, width: 220 };
  const [third] = placeLabels([label(moved, second)], taken(wider), canvas);
  expect(overlap(boxOf(third!), wider)).toBe(false);
});

test('where there is no room at all, a label stays on the canvas', () => {
  const all = { left: 0, top: 0, ...canvas };
  const [place] = placeLabels(
    [label({ left: 300, top: 280, width: 60, height: 10 })],
    taken(all),
    canvas,
  );
  expect(place!.left).toBeGreaterThanOrEqual(4);
  expect(place!.left + 90).toBeLessThanOrEqual(396);
  expect(place!.top + 28).toBeLessThanOrEqual(296);
});
