import { expect, test } from 'vitest';
import { type PrintReport, printReportHtml } from '../../../web/app/print-report.js';

const report: PrintReport = {
  model: 'bracket.stl',
  facts: '9,872 faces · genus 3',
  cautions: [],
  limits: { tubeDiameter: 3, wallThickness: 1 },
  format: { unit: 'mm', scale: 1, decimals: 2 },
  places: [
    {
      place: {
        kind: 'tube',
        vertices: new Uint32Array([1, 2]),
        area: 20.5,
        least: 2.125,
        thinnest: 2,
      },
      loop: 6.676,
      picture: 'data:image/png;base64,AAAA',
    },
    { place: { kind: 'plate', vertices: new Uint32Array([9]), area: 4, least: 0.5, thinnest: -1 } },
  ],
  more: 0,
  date: '2026-01-31',
};

test('every place with kind, thickness, loop, area and picture', () => {
  const html = printReportHtml(report);
  for (const words of [
    'Fails: 2 places are too thin.',
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
  const html = printReportHtml({ ...report, places: [] });
  expect(html).toContain('Passes: nothing is too thin.');
  expect(html).not.toContain('<table');
});

test('cautions stand under the answer', () => {
  const cautions = ['The surface has 2 holes.'];
  expect(printReportHtml({ ...report, cautions })).toContain('<p>The surface has 2 holes.</p>');
});
