// How much the page fetches before its first surface is there: numbers that do not depend on how fast the machine is.

import { expect, test } from 'vitest';
import {
  bytesOf,
  fetchedBeforePicture,
  isProgram,
  mostBeforePicture,
  mostProgramsBeforePicture,
} from './first-picture.js';
import { site } from './page-support.js';
import { chromiumForTests, requireBuilt } from './support.js';

const openPage = chromiumForTests();

test('before the first surface no more is fetched than it takes', async () => {
  requireBuilt('build/page/index.html', 'build:page');
  const files = await fetchedBeforePicture(openPage, site);
  const [programs, all] = [bytesOf(files.filter(isProgram)), bytesOf(files)];
  console.info(`before the first surface: ${programs} bytes of programs by gzip, ${all} in all`);
  expect(programs).toBeLessThanOrEqual(mostProgramsBeforePicture);
  expect(all).toBeLessThanOrEqual(mostBeforePicture);
  const names = files.map(({ path }) => path);
  expect(names.some((path) => /chair\.glb$/.test(path))).toBe(true);
  // Scripts that most visitors never ask for wait until they do.
  const later = /palette|beside|tour|project|compare-panel|draco|studies|snapshot|link-/;
  expect(names.filter((path) => later.test(path))).toEqual([]);
});
