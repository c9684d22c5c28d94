import { Quaternion, Ray, Sphere, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { writeSection } from '../../../web/src/element/controls/section-tool.js';
import { parseSection } from '../../../web/src/element/attributes/section-words.js';
import { SectionPlane, sectionAcross } from '../../../web/src/view/section-plane.js';
import { SurfaceSpace } from '../../../web/src/view/surface-space.js';

const plane = new SectionPlane([1, 0, 0], 2);
const ray = (from: number[], to: number[]) =>
  new Ray(new Vector3().fromArray(from), new Vector3().fromArray(to).normalize());

test('a ray reaches what is left of a surface: from the plane on, or up to it', () => {
  expect(plane.reach(ray([5, 0, 0], [-1, 0, 0]))).toEqual([3, Infinity]);
  expect(plane.reach(ray([-1, 0, 0], [1, 0, 0]))).toEqual([0, 3]);
  expect(plane.reach(ray([1, 0, 0], [-1, 0, 0]))).toEqual([0, Infinity]);
  // Along the plane, on either side; and away from it, where all is cut away.
  expect(plane.reach(ray([1, 0, 0], [0, 1, 0]))).toEqual([0, Infinity]);
  for (const direction of [
    [0, 1, 0],
    [1, 1, 0],
  ]) {
    const [near, far] = plane.reach(ray([3, 0, 0], direction));
    expect(near).toBeGreaterThan(far);
  }
  // The plane reaches all that is not cut away: looked at point by point.
  const slanted = new SectionPlane([0.6, 0, 0.8], 0.3);
  for (let i = 0; i < 50; ++i) {
    const at = (k: number) => Math.sin(7 * i + k);
    const one = ray([at(1), at(2), at(3)], [at(4), at(5), at(6)]);
    const [near, far] = slanted.reach(one);
    for (const t of [0.01, 0.2, 0.7, 1.9]) {
      if (Math.min(Math.abs(t - near), Math.abs(t - far)) < 1e-9) continue;
      const isLeft = !slanted.cuts(one.at(t, new Vector3()));
      expect(t > near && t < far).toBe(isLeft);
    }
  }
});

test('in the scene it divides the same points', () => {
  const space = new SurfaceSpace();
  const upright = new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), 0.7);
  space.fit(new Sphere(new Vector3(1, 2, 3), 5), upright);
  const scene = space.planeOf(plane);
  for (const x of [-3, 1.9, 2.1, 6]) {
    const point = space.toScene(new Vector3(x, -1, 4));
    expect(scene.distanceToPoint(point)).toBeCloseTo((2 - x) / 5, 12);
  }
});

test('it lies at a share of the surface’s extent', () => {
  const points = [
    [1, 0, 0],
    [3, 2, 0],
    [2, -2, 5],
  ] as const;
  const surface = {
    eachPosition: (see: (x: number, y: number, z: number) => void) =>
      points.forEach(([x, y, z]) => see(x, y, z)),
  };
  expect(sectionAcross(surface, [2, 0, 0], 0.25)).toEqual(new SectionPlane([1, 0, 0], 1.5));
  expect(sectionAcross(surface, [0, -1, 0], 1).offset).toBe(2);
});

test('its words are read as they are written', () => {
  for (const words of ['x 40%', '-z 0.5%', '0.5,-0.25,0.8 33.3%', 'y 100%']) {
    expect(writeSection(parseSection(words)!)).toBe(words);
  }
  expect(parseSection('-y 25%')).toEqual({ direction: [0, -1, 0], share: 0.25 });
  expect(writeSection({ direction: [0.123456, 0.9, -0.00001], share: 1 / 3 })).toBe(
    '0.1235,0.9,0 33.3%',
  );
});
