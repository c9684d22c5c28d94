import { expect, test } from 'vitest';
import { LinkedView } from '../../../web/src/element/surface/link.js';
import type { CameraView, Stage } from '../../../web/src/view/index.js';

/** A stage of which only the view matters; its motion is reported by hand, as a frame would. */
class FakeStage {
  view: CameraView = { polar: 1, azimuth: 0, distance: 5, target: [0, 0, 0] };
  isHome = false;
  companions: () => Stage[] = () => [];

  lookFrom(view: CameraView): void {
    this.view = { ...view };
  }

  resetView(): void {
    this.isHome = true;
  }

  refit(): void {
    // Stays as it is.
  }
}

function linked(count: number) {
  return Array.from({ length: count }, () => {
    const stage = new FakeStage();
    const link = new LinkedView(() => stage as unknown as Stage);
    link.join('one');
    return { stage, link, look: (distance: number) => (stage.view = { ...stage.view, distance }) };
  });
}

const distances = (views: ReturnType<typeof linked>) =>
  views.map(({ stage }) => stage.view.distance);

test('whichever is moved, the others follow', () => {
  const views = linked(3);
  for (const [i, { link, look }] of views.entries()) {
    look(6 + i);
    link.move();
    expect(distances(views)).toEqual([6 + i, 6 + i, 6 + i]);
  }
});

test('what is late in following does not bring back the one that has gone on', () => {
  const views = linked(2);
  const [first, second] = views as [(typeof views)[0], (typeof views)[0]];
  first.look(6);
  first.link.move();
  // Before the second has drawn a frame and reports its motion, the first one is elsewhere.
  first.look(7);
  second.link.move();
  expect(distances(views)).toEqual([7, 6]);
  first.link.move();
  second.link.move();
  expect(distances(views)).toEqual([7, 7]);
  // A hand's motion is news.
  second.look(3);
  second.link.move();
  expect(distances(views)).toEqual([3, 3]);
});
