import { expect, test } from 'vitest';
import { type PrintReport, printReportHtml } from '../../../web/app/panels/print/print-report.js';
import { answerWords } from '../../../web/app/panels/print/print-words.js';
import type { Crease, WeakPlace } from '../../../web/src/kernel/index.js';

const tube: WeakPlace = {
  kind: 'tube',
  measure: 'diameter',
  vertices: new Uint32Array([1, 2]),
  area: 20.5,
  faces: new Uint32Array(),
  least: 2.125,
  thinnest: 2,
};
const wall: WeakPlace = {
  kind: 'wall',
  measure: 'thickness',
  vertices: new Uint32Array([9]),
  area: 4,
  faces: new Uint32Array([3]),
  least: 0.5,
  thinnest: { face: 3, weights: [0.5, 0.25, 0.25] },
  opposite: [0, 0, 1],
};
const check = {
  passes: false,
  places: [tube, wall],
  creases: [],
  failingShare: 0.1249,
  passingScale: 1.412,
};
const passed = { ...check, passes: true, places: [], failingShare: 0, passingScale: 0.6149 };
const crease: Crease = {
  kind: 'crease',
  length: 2.5,
  area: 0.75,
  least: 0,
  thinnest: 4,
  opposite: [0, 0, 1],
  vertices: new Uint32Array([4]),
  faces: new Uint32Array([5]),
};
const report: PrintReport = {
  model: 'bracket.stl',
  facts: '9,872 faces · genus 3',
  cautions: [],
  limits: { tubeDiameter: 3, wallThickness: 1 },
  source: 'Some shop',
  check,
  format: { unit: 'mm', scale: 1, decimals: 2 },
  places: [{ place: tube, loop: 6.676, picture: 'data:image/png;base64,AAAA' }, { place: wall }],
  date: '2026-01-31',
};

test('every place with kind, thickness, loop, area and picture', () => {
  const html = printReportHtml(report);
  for (const words of [
    'Fails: 2 places are too thin, 12% of the surface. Passes from 142% of this size.',
    '(Some shop)',
    'tubes from a diameter of 3.00\u202fmm, walls from a thickness of 1.00\u202fmm',
    '<td>tube</td><td class="number">2.13\u202fmm</td><td class="number">6.68\u202fmm</td>',
    '<td class="number">20.5\u202fmm²</td><td class="number">2</td>',
    '<td>wall</td><td class="number">0.50\u202fmm</td><td class="number">–</td>',
    'src="data:image/png;base64,AAAA"',
  ]) {
    expect(html).toContain(words);
  }
});

test('one file that needs no network and runs nothing', () => {
  const html = printReportHtml(report);
  expect(html).not.toMatch(/<script|<link|@import|url\(/);
  expect([...html.matchAll(/(?:src|href)="([^"]*)"/g)].map((match) => match[1])).toEqual([
    'data:image/png;base64,AAAA',
  ]);
});

test('a name is text, whatever it has in it', () => {
  const html = printReportHtml({ ...report, model: `<img src=x onerror="alert('1')">&` });
  expect(html).not.toContain('<img src=x');
  expect(html).toContain('&lt;img src=x onerror=&quot;alert(&#39;1&#39;)&quot;&gt;&amp;');
  const picture = '" onerror="alert(1)';
  expect(printReportHtml({ ...report, overview: picture })).not.toContain(picture);
});

test('what passes says so, and has no table', () => {
  const html = printReportHtml({ ...report, check: passed, places: [] });
  expect(html).toContain('Passes: nothing is too thin, down to 62% of this size.');
  expect(html).not.toContain('<table');
});

test('creases are listed apart, and do not fail', () => {
  const creased = { ...passed, creases: [crease], passingScale: 1 };
  expect(answerWords(creased)).toBe(
    'Passes: nothing is too thin, down to 100% of this size. Creases: 1.',
  );
  const html = printReportHtml({ ...report, check: creased, places: [] });
  expect(html).toContain('<h2>Creases, which do not fail</h2>');
  expect(html).toContain('<td>sharp edge</td><td class="number">2.50\u202fmm</td>');
  expect(printReportHtml(report)).not.toContain('Creases, which');
});

test('cautions stand under the answer', () => {
  const cautions = ['The surface has 2 holes.'];
  expect(printReportHtml({ ...report, cautions })).toContain('<p>The surface has 2 holes.</p>');
});

test('the answer says of how much, and what would help', () => {
  const one = { ...check, places: [wall], failingShare: 0.001, passingScale: 12.345 };
  expect(answerWords(one)).toBe(
    'Fails: one place is too thin, <1% of the surface. Passes from 12.4 times this size.',
  );
  const edge = { ...wall, least: 0 };
  expect(answerWords({ ...one, places: [wall, edge], passingScale: Infinity })).toContain(
    'It passes at no size: at one place faces meet in a sharp edge or lie on each other.',
  );
  expect(answerWords(passed)).toContain('Passes');
});
