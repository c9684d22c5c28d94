// Line plots as SVG, written by hand: readable on light and on dark pages, as a picture of its own.

/**
 * @typedef {{ name: string, points: { x: number, y: number }[], at?: 'left' | 'below' }} Line `at`: where the name of one that ends early stands, not on the right of its end
 * @typedef {{ title: string, xTitle: string, lines: Line[], isLog?: boolean }} Panel `isLog`: both axes by powers of ten
 */

const width = 420;
const height = 320;
const margin = { top: 40, right: 86, bottom: 46, left: 62 };

// Distinct for the colour-blind, and dark enough on white, light enough on black.
const colours = ['#2a7fc4', '#d9642b', '#2f9e6e', '#c2528f', '#8a6fd1', '#a8841c'];

const style = `
    text { font: 12px system-ui, sans-serif; fill: #333; }
    .title { font-size: 14px; font-weight: 600; }
    .axis { stroke: #888; }
    .grid { stroke: #ddd; }
    .background { fill: #fff; }
    @media (prefers-color-scheme: dark) {
      text { fill: #ddd; }
      .axis { stroke: #888; }
      .grid { stroke: #333; }
      .background { fill: #161616; }
    }
`;

/** @param {string} text */
const escaped = (text) =>
  text.replace(/[&<>"]/g, (character) => `&#${String(character.charCodeAt(0))};`);

/** @param {number} value */
const short = (value) => String(Math.round(value * 10) / 10);

/**
 * Round numbers from 0 to at least `most`, about five of them.
 * @param {number} most
 */
function ticksTo(most) {
  const rough = Math.max(most, 1e-9) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10) * power;
  const count = Math.ceil(most / step - 1e-9);
  return Array.from({ length: count + 1 }, (_, i) => Number((i * step).toPrecision(12)));
}

/**
 * Where values lie between two ends of an axis, and its ticks.
 * @param {number[]} values
 * @param {boolean} isLog
 * @returns {{ ticks: number[], share: (value: number) => number }}
 */
function axisOf(values, isLog) {
  if (!isLog) {
    const ticks = ticksTo(Math.max(...values));
    return { ticks, share: (value) => value / (ticks.at(-1) ?? 1) };
  }
  const first = Math.floor(Math.log10(Math.min(...values)));
  const last = Math.ceil(Math.log10(Math.max(...values)));
  const ticks = Array.from({ length: last - first + 1 }, (_, i) =>
    Number(`1e${String(first + i)}`),
  );
  return { ticks, share: (value) => (Math.log10(value) - first) / (last - first) };
}

/** @param {number} tick */
const tickWords = (tick) => (tick >= 1000 ? tick.toLocaleString('en') : String(tick));

/**
 * Heights of labels, moved apart until none touches the next; the order stays.
 * @param {number[]} wanted
 * @param {number} lowest the greatest height allowed
 */
function apart(wanted, lowest) {
  const gap = 14;
  const order = wanted.map((_, i) => i).sort((a, b) => (wanted[a] ?? 0) - (wanted[b] ?? 0));
  const heights = [...wanted];
  let limit = -Infinity;
  for (const i of order) limit = heights[i] = Math.max(heights[i] ?? 0, limit + gap);
  limit = lowest + gap;
  for (const i of order.reverse()) limit = heights[i] = Math.min(heights[i] ?? 0, limit - gap);
  return heights;
}

/**
 * @param {Panel} panel
 * @param {number} left
 */
function panelSvg({ title, xTitle, lines, isLog = false }, left) {
  const all = lines.flatMap(({ points }) => points);
  const across = axisOf(
    all.map(({ x }) => x),
    isLog,
  );
  const up = axisOf(
    all.map(({ y }) => y),
    isLog,
  );
  const right = width - margin.right;
  const bottom = height - margin.bottom;
  /** @param {number} value */
  const x = (value) => margin.left + across.share(value) * (right - margin.left);
  /** @param {number} value */
  const y = (value) => bottom - up.share(value) * (bottom - margin.top);
  /** @param {Line} line */
  const endsEarly = ({ points }) => x(points.at(-1)?.x ?? 0) < right - 24;
  const atRight = lines.filter((line) => !endsEarly(line));
  const heights = apart(
    atRight.map(({ points }) => y(points.at(-1)?.y ?? 0)),
    bottom,
  );
  const parts = [
    `<text class="title" x="${short(margin.left)}" y="22">${escaped(title)}</text>`,
    ...up.ticks.flatMap((tick) => [
      `<line class="grid" x1="${short(margin.left)}" x2="${short(right)}" y1="${short(y(tick))}" y2="${short(y(tick))}"/>`,
      `<text x="${short(margin.left - 8)}" y="${short(y(tick) + 4)}" text-anchor="end">${tickWords(tick)}</text>`,
    ]),
    ...across.ticks.map(
      (tick) =>
        `<text x="${short(x(tick))}" y="${short(bottom + 18)}" text-anchor="middle">${tickWords(tick)}</text>`,
    ),
    `<line class="axis" x1="${short(margin.left)}" x2="${short(right)}" y1="${short(bottom)}" y2="${short(bottom)}"/>`,
    `<text x="${short((margin.left + right) / 2)}" y="${short(bottom + 36)}" text-anchor="middle">${escaped(xTitle)}</text>`,
    ...lines.flatMap((line, i) => {
      const { name, points } = line;
      const colour = colours[i % colours.length] ?? '';
      const path = points.map((point) => `${short(x(point.x))},${short(y(point.y))}`);
      const end = points.at(-1);
      const [endX, endY] = [x(end?.x ?? 0), y(end?.y ?? 0)];
      const label = heights[atRight.indexOf(line)] ?? 0;
      return [
        `<polyline points="${path.join(' ')}" fill="none" stroke="${colour}" stroke-width="2"/>`,
        ...points.map(
          (point) =>
            `<circle cx="${short(x(point.x))}" cy="${short(y(point.y))}" r="3" fill="${colour}"/>`,
        ),
        ...(endsEarly(line)
          ? [
              line.at === 'left'
                ? `<text x="${short(endX - 7)}" y="${short(endY - 3)}" text-anchor="end">${escaped(name)}</text>`
                : `<text x="${short(endX + 7)}" y="${short(endY + (line.at === 'below' ? 16 : 4))}">${escaped(name)}</text>`,
            ]
          : [
              // From the line's end to its name, where the name had to move.
              `<path d="M${short(endX)},${short(endY)} L${short(right + 12)},${short(label)}" fill="none" stroke="${colour}"/>`,
              `<text x="${short(right + 16)}" y="${short(label + 4)}">${escaped(name)}</text>`,
            ]),
      ];
    }),
  ];
  return `  <g transform="translate(${String(left)},0)">\n    ${parts.join('\n    ')}\n  </g>`;
}

/**
 * Panels side by side.
 * @param {string} description for who cannot see it
 * @param {Panel[]} panels
 */
export function plotSvg(description, panels) {
  const total = panels.length * width;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${String(total)} ${String(height)}" width="${String(total)}" height="${String(height)}" role="img">
  <title>${escaped(description)}</title>
  <style>${style}  </style>
  <rect class="background" width="${String(total)}" height="${String(height)}"/>
${panels.map((panel, i) => panelSvg(panel, i * width)).join('\n')}
</svg>
`;
}
