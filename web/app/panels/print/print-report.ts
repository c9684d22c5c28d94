// The print check as one HTML file: no network, no scripts, pictures inside; good on paper too.

import type { PrintCheck, PrintLimits, WeakPlace } from '../../../src/kernel/index.js';
import { type LengthFormat, formatCount, formatLength } from '../../../src/element/plots.js';
import {
  answerWords,
  limitWords,
  measureNames,
  uncheckedWords,
  creaseWords,
} from './print-words.js';
import { formatArea } from '../../widgets/area-words.js';

export interface ReportedPlace {
  place: WeakPlace;
  /** Length of the loop at its thinnest vertex; undefined where there is none. */
  loop?: number | undefined;
  /** A PNG as a data: address; undefined where it could not be made. */
  picture?: string | undefined;
}

export interface PrintReport {
  /** The file's name and what it is, in words. */
  model: string;
  facts: string;
  /** The reasons not to trust the answer, a sentence each. */
  cautions: readonly string[];
  limits: PrintLimits;
  /** Whose numbers the limits are; '' for the reader's own. */
  source: string;
  check: PrintCheck;
  format: LengthFormat;
  /** The places of the check that are listed. */
  places: readonly ReportedPlace[];
  /** The whole shape, a PNG as a data: address. */
  overview?: string | undefined;
  date: string;
}

const listedCreases = 40;

const style = `
  :root { color-scheme: light; }
  body { font: 15px/1.5 system-ui, sans-serif; color: #1c1d21; background: #fff; margin: 40px auto;
    max-width: 46rem; padding: 0 20px; font-variant-numeric: tabular-nums; }
  h1 { font-size: 24px; margin: 0 0 4px; letter-spacing: -0.01em; overflow-wrap: anywhere; }
  h2 { font-size: 17px; margin: 32px 0 8px; }
  p { margin: 0 0 8px; }
  .quiet { color: #5d6069; }
  .answer { font-size: 19px; font-weight: 650; margin: 20px 0 8px; padding-inline-start: 14px;
    border-inline-start: 4px solid; }
  .fails { border-color: #c2410c; }
  .passes { border-color: #15803d; }
  .overview { display: block; width: 100%; max-height: 26rem; object-fit: contain; }
  table { border-collapse: collapse; width: 100%; }
  th, td { text-align: start; padding: 8px 14px 8px 0; border-block-end: 1px solid #dfe0e3; }
  th { font-weight: 600; color: #5d6069; font-size: 13px; vertical-align: bottom; }
  td.number, th.number { text-align: end; white-space: nowrap; }
  td img { display: block; width: 150px; height: 112px; object-fit: contain; }
  tr { break-inside: avoid; }
  thead { display: table-header-group; }
  @page { margin: 16mm; }
  @media print { body { margin: 0; max-width: none; padding: 0; } }
`;

function escaped(text: string): string {
  const names: Record<string, string> = {
    '&': '&amp;',
    '<': '&lt;',
    '>': '&gt;',
    '"': '&quot;',
    "'": '&#39;',
  };
  return text.replace(/[&<>"']/g, (letter) => names[letter]!);
}

/** Only what this page itself has drawn goes into the file. */
function image(address: string | undefined, name: string, alt: string): string {
  if (!address || !/^data:image\/png;base64,[A-Za-z0-9+/=]+$/.test(address)) return '';
  return `<img class="${name}" src="${address}" alt="${escaped(alt)}">`;
}

export function printReportHtml(report: PrintReport): string {
  const { model, facts, cautions, limits, source, check, format, places, overview, date } = report;
  const rows = places.map(({ place, loop, picture }, i) => {
    const name = place.kind;
    const least = formatLength(place.least, format);
    const cells = [
      `<td class="number">${i + 1}</td>`,
      `<td>${image(picture, 'place', `Place ${i + 1}: a ${name}, ${measureNames[place.kind]} ${least}`)}</td>`,
      `<td>${name}</td>`,
      `<td class="number">${escaped(least)}</td>`,
      `<td class="number">${loop === undefined ? '–' : escaped(formatLength(loop, format))}</td>`,
      `<td class="number">${escaped(formatArea(place.area, format))}</td>`,
      `<td class="number">${typeof place.thinnest === 'number' ? place.thinnest : '–'}</td>`,
    ];
    return `<tr>${cells.join('')}</tr>`;
  });
  const count = check.places.length;
  const unchecked = uncheckedWords(limits);
  const more = count - places.length;
  const table = `
    <h2>Places that fail</h2>
    <table>
      <thead><tr><th class="number">No.</th><th>Picture</th><th>What</th>
        <th class="number">Diameter, thickness or clearance</th><th class="number">Length of the loop round it</th>
        <th class="number">Area</th><th class="number">Vertex</th></tr></thead>
      <tbody>${rows.join('\n')}</tbody>
    </table>
    ${more > 0 ? `<p class="quiet">and ${formatCount(more)} smaller ones</p>` : ''}`;
  const creased = `
    <h2>Creases, which do not fail</h2>
    <table>
      <thead><tr><th>What</th><th class="number">Length</th><th class="number">Area</th></tr></thead>
      <tbody>${check.creases
        .slice(0, listedCreases)
        .map(
          ({ kind, length, area }) =>
            `<tr><td>${creaseWords[kind]}</td><td class="number">${escaped(formatLength(length, format))}</td><td class="number">${escaped(formatArea(area, format))}</td></tr>`,
        )
        .join('\n')}</tbody>
    </table>`;
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Print check: ${escaped(model)}</title>
<style>${style}</style>
</head>
<body>
<h1>Print check: ${escaped(model)}</h1>
<p class="quiet">${escaped(facts)}</p>
<p>What can be printed: ${escaped(limitWords(limits, format))}${source && ` (${escaped(source)})`}.</p>
<p class="answer ${count > 0 ? 'fails' : 'passes'}">${escaped(answerWords(check, limits))}</p>
${unchecked && `<p>Not checked: ${unchecked}.</p>`}
${cautions.map((caution) => `<p>${escaped(caution)}</p>`).join('\n')}
${image(overview, 'overview', `The whole of ${model}`)}
${count > 0 ? table : ''}
${check.creases.length > 0 ? creased : ''}
<p class="quiet">The diameter of a tube is the least width of the section inside its loop, or the loop’s length
divided by π where that is less. The thickness of a wall is the largest ball inside that touches the surface;
the clearance of a gap is the largest ball between. Creases are thin only where faces run into each other or touch. Overhangs, strength, and what
the surface does not show are not checked. Made with Girth, ${escaped(date)}.</p>
</body>
</html>
`;
}
