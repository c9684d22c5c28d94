// `npm run bench:paper [-- --naive-seconds S] [-- --folder FOLDER] [-- --only PART]`: the paper's Table I and Figure 6, and
// the time of the library's methods up to a million triangles, measured here and written to
// web/docs/bench/paper.{md,json,svg} and scale.svg. The naive algorithm runs for at most about S seconds a size.
// Default: 600. Runs that would take longer are extrapolated, and marked so. Half an hour on a machine that does
// nothing else; the figures are of the machine that it runs on. --only: of `paper`, the first two, `scale`, the methods
// up to a million triangles (ten minutes), and `divided`, surfaces with flat vertices (five minutes), one alone, or
// `none`; the rest stays as paper.json has it.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { availableParallelism, cpus } from 'node:os';
import { basename, join } from 'node:path';
import { parseArgs } from 'node:util';
import { buildNative, buildWasm } from './build.mjs';
import { plotSvg } from './plot.mjs';
import { Complaint, outputOf, repository, run, runTool, script } from './run.mjs';
import { setUp } from './setup.mjs';

/**
 * @typedef {{ seconds: number, threads: number, bytes: number }} Cost
 * @typedef {{ model: string, faces: number, vertices: number, exact: Cost & { windowsPerVertex: number },
 *   naive?: Cost & { vertices: number } }} Figures
 * @typedef {{ faces: number, vertices: number, exact: { seconds: number, vertices: number },
 *   refined?: { seconds: number }, carried?: { seconds: number } }} Scale
 * @typedef {{ date: string, machine: string }} When
 * @typedef {When & { table: Figures[], paperTable: number[][],
 *   plot: { name: string, figures: Figures[] }[] }} Paper the first two parts
 * @typedef {Paper & { scale: Scale[], scaleWhen: When, divided: Scale[], dividedWhen: When }} Report
 */

const program = 'build/native/cpp/bench/paper_figures';
const scaleProgram = 'build/native/cpp/bench/scale';
const models = 'build/bench/models';
const tableSizes = [2000, 4000, 6000, 8000, 10000];
const plotSizes = [2000, 5000, 10000, 15000, 20000];

/** Table I of the paper: faces, then seconds and megabytes, naive and improved (quad core). */
const paperTable = [
  [2000, 8.0, 3.0, 0.25, 0.2],
  [4000, 55.6, 10.3, 0.76, 0.4],
  [6000, 173.3, 22.0, 2.14, 0.7],
  [8000, 395.5, 38.8, 4.39, 1.2],
  [10000, 767.6, 61.3, 7.73, 1.5],
];

const scaleSizes = [1000, 2000, 5000, 10_000, 20_000, 50_000, 100_000, 200_000, 500_000, 1_000_000];
/** Seconds of the paper's elephant of 50,000 faces, with the speed-ups. */
const paperElephant = [49_918, 507];
/** The refined method is not measured on more that is nowhere flat: half an hour each. */
const mostRefined = 200_000;

/** Every built-in example at every size, as far as its shape allows. */
function writeModels() {
  runTool('vite', [
    ...['build', '--ssr', 'web/app/examples/resolutions.ts', '--outDir', 'build/bench'],
    ...['--logLevel', 'warn'],
  ]);
  mkdirSync(join(repository, models), { recursive: true });
  run('node', [
    'build/bench/resolutions.js',
    models,
    ...new Set([...tableSizes, ...plotSizes].map(String)),
  ]);
}

/**
 * @param {string[]} args
 * @returns {Figures}
 */
function measure(args) {
  const output = outputOf(program, args);
  if (output === undefined) throw new Complaint(`${program} ${args.join(' ')}: failed`);
  /** @type {Figures} */
  const figures = JSON.parse(output);
  figures.exact.threads ||= availableParallelism();
  console.log(
    `${figures.model}: ${String(figures.faces)} faces, exact ${figures.exact.seconds.toFixed(2)} s` +
      (figures.naive ? `, naive ${figures.naive.seconds.toFixed(0)} s` : ''),
  );
  return figures;
}

/**
 * The horses of the corpus: of 6,000 and 10,000 faces as they are, the other sizes from the next coarser
 * one. Without a corpus, the octopus of the examples, from 4,000 faces on.
 * @param {string} naiveSeconds
 */
function measureTable(naiveSeconds) {
  const corpus = process.env.GIRTH_DATA;
  const options = ['--threads', '0', '--naive-seconds', naiveSeconds];
  if (!corpus) {
    const files = tableSizes.filter((faces) => faces >= 4000);
    return files.map((faces) => measure([...options, `${models}/octopus_${String(faces)}.glb`]));
  }
  return tableSizes.map((faces) => {
    if (faces === 10000) {
      return measure([...options, join(corpus, 'retrieval/tosca_iso_5k/horse0.off')]);
    }
    const base = faces < 6000 ? 'horse_1500f' : 'horse_6000f';
    const file = join(corpus, 'models', `${base}.off`);
    return measure([...options, '--refined', String(faces), file]);
  });
}

/**
 * The elephant of the corpus, remeshed to every size but its own; without a corpus the octopus of the examples.
 * @returns {Scale[]}
 */
function measureScale() {
  const corpus = process.env.GIRTH_DATA;
  const runs = corpus
    ? scaleSizes.map((faces) => [
        ...(faces === 50_000 ? [] : ['--faces', String(faces)]),
        join(corpus, 'models/elephant_49918f_g3.off'),
      ])
    : plotSizes.slice(1).map((faces) => [`${models}/octopus_${String(faces)}.glb`]);
  return runs.map((args) => scaleOf(['--refined-faces', String(1.1 * mostRefined), ...args]));
}

/**
 * The dancer of the corpus with each of its triangles cut into four and into sixteen; without a corpus the octopus.
 * @returns {Scale[]}
 */
function measureDivided() {
  const corpus = process.env.GIRTH_DATA;
  const model = corpus
    ? join(corpus, 'models/dancer_49996f_g1.off')
    : `${models}/octopus_${String(plotSizes[1])}.glb`;
  return ['1', '2'].map((times) => scaleOf(['--divided', times, model]));
}

/** @param {string[]} args */
function scaleOf(args) {
  const output = outputOf(scaleProgram, args);
  if (output === undefined) throw new Complaint(`${scaleProgram} ${args.join(' ')}: failed`);
  /** @type {Scale} */
  const scale = JSON.parse(output);
  console.log(output.trim());
  return scale;
}

/** @param {string[]} names */
function measurePlot(names) {
  return names.map((name) => ({
    name,
    figures: plotSizes
      .filter((faces) => faces >= 4000 || !['chair', 'octopus'].includes(name))
      .map((faces) => measure(['--threads', '0', `${models}/${name}_${String(faces)}.glb`])),
  }));
}

/** @param {number} bytes */
const megabytes = (bytes) => (bytes / 1e6).toFixed(bytes < 1e7 ? 2 : 1);

/** @param {number} seconds */
const rounded = (seconds) => (seconds < 10 ? seconds.toFixed(2) : seconds.toFixed(1));

/** @param {string[][]} rows the first: the headings */
function markdownTable(rows) {
  const lines = rows.map((row) => `| ${row.join(' | ')} |`);
  const rule = `| ${(rows[0] ?? []).map(() => '---:').join(' | ')} |`;
  return [lines[0], rule, ...lines.slice(1)].join('\n');
}

/** @param {Scale[]} scale */
const scaleTable = (scale) =>
  markdownTable([
    ['faces', 'exact', 'refined', 'carried back'],
    ...scale.map(({ faces, vertices, exact, refined, carried }) => [
      faces.toLocaleString('en'),
      rounded(exact.seconds) +
        (exact.vertices < vertices
          ? ` (from ${exact.vertices.toLocaleString('en')} vertices)`
          : ''),
      refined ? rounded(refined.seconds) : '',
      carried ? rounded(carried.seconds) : '',
    ]),
  ]);

/** @param {Report} report */
function markdown({ machine, date, table, plot, scale, scaleWhen, divided, dividedWhen }) {
  const horse = table.some(({ model }) => model.startsWith('horse'));
  const rows = table.map(({ faces, vertices, exact, naive }) => {
    if (!naive) throw new Complaint('the naive algorithm was not measured');
    const extrapolated =
      naive.vertices < vertices ? ` (from ${String(naive.vertices)} vertices)` : '';
    const paper = paperTable.find(([size = 0]) => Math.abs(faces / size - 1) < 0.1) ?? [];
    return [
      String(faces),
      `${rounded(naive.seconds)}${extrapolated}`,
      megabytes(naive.bytes),
      rounded(exact.seconds),
      megabytes(exact.bytes),
      ((naive.seconds * naive.threads) / (exact.seconds * exact.threads)).toFixed(0),
      ...paper.slice(1).map(String),
    ];
  });
  const headings = [
    ...['faces', 'naive s', 'naive MB', 'exact s', 'exact MB', 'naive / exact, per core'],
    ...['paper: naive s', 'MB', 'improved s', 'MB'],
  ];
  const threads = String(table[0]?.exact.threads);
  const plotRows = plot.flatMap(({ name, figures }) =>
    figures.map(({ faces, exact }) => [
      name,
      String(faces),
      rounded(exact.seconds),
      megabytes(exact.bytes),
      String(exact.windowsPerVertex),
    ]),
  );
  return `# The figures of the paper, measured again

Written by \`npm run bench:paper\` on ${date}: ${machine}.

## Table I: with and without the speed-ups

The girth at all vertices, by two methods. _naive_ is section 4.2 of the paper on one thread; a number of
vertices in brackets means that only so many were run, spread over the surface, and the time is extrapolated.
_exact_ is the default of the library on ${threads} threads, in elapsed seconds. Megabytes are the most that one
thread held in addition to the mesh. The paper's own figures stand beside ours (Xin et al. 2016, Table I: a quad core of
3.07 GHz, OpenMP).
${
  horse
    ? 'Models: horses of 6,000 and 10,000 faces as they are. The sizes 2,000 and 4,000 are made from one of 1,500 faces, and 8,000 from the one of 6,000, by halving the longest edges until the number is reached.'
    : 'Model: the octopus of the built-in examples; the paper has a horse.'
}

${markdownTable([headings, ...rows])}

## Figure 6: six models from 2,000 to 20,000 faces

![Seconds and megabytes against faces](paper.svg)

The built-in examples, each made from its description at every size; chair and octopus from 4,000 faces
on, since their limbs cannot be made of fewer. ${threads} threads; megabytes of one of them.

${markdownTable([['model', 'faces', 'seconds', 'MB', 'windows a vertex'], ...plotRows])}

## From a thousand triangles to a million

![Seconds against triangles, by powers of ten](scale.svg)

${
  process.env.GIRTH_DATA
    ? 'An elephant of 49,918 faces, and the same remeshed to other sizes'
    : 'The octopus of the built-in examples'
}, all vertices, in seconds on ${threads} threads. What the exact method
would take more than a minute for is extrapolated from some vertices, spread over the surface. _Refined_ is without its audit,
and was not measured beyond ${mostRefined.toLocaleString('en')} faces; _carried back_ is the exact girth of 10,000 faces at the vertices of all,
remeshing included. Measured on ${scaleWhen.date}: ${scaleWhen.machine}. The paper's points are those of its Table I, and its elephant of 50,000 faces: ${String(paperElephant[1])} s.

${scaleTable(scale)}

The same for ${process.env.GIRTH_DATA ? 'a dancer of 49,996 faces' : 'the octopus'} with each triangle cut into four, and into sixteen. The refined method, _divided_ in
the plot, looks for loops on the surface without its flat vertices. Measured on ${dividedWhen.date}: ${dividedWhen.machine}.

${scaleTable(divided)}
`;
}

await script(() => {
  const { values } = parseArgs({
    options: {
      'naive-seconds': { type: 'string', default: '600' },
      folder: { type: 'string', default: 'web/docs/bench' },
      only: { type: 'string' },
    },
  });
  const folder = join(repository, values.folder);
  const now = {
    date: new Date().toISOString().slice(0, 10),
    machine: `${String(availableParallelism())} cores, ${cpus()[0]?.model.trim() ?? 'unknown'}`,
  };
  const parts = {
    paper: () => ({
      ...now,
      table: measureTable(values['naive-seconds']),
      paperTable,
      plot: measurePlot(['chair', 'octopus', 'handles', 'dumbbell', 'cup', 'vessel']),
    }),
    scale: () => ({ scale: measureScale(), scaleWhen: now }),
    divided: () => ({ divided: measureDivided(), dividedWhen: now }),
    none: () => ({}),
  };
  if (values.only && !Object.hasOwn(parts, values.only)) {
    throw new Complaint(`--only ${values.only}: the parts are ${Object.keys(parts).join(', ')}`);
  }
  const only = /** @type {keyof typeof parts | undefined} */ (values.only);
  setUp();
  buildNative([program, scaleProgram].map((path) => basename(path)));
  // The other parts measure models of the corpus.
  if (!only || only === 'paper' || !process.env.GIRTH_DATA) {
    buildWasm();
    writeModels();
  }
  /** @type {() => Report} */
  const readReport = () => JSON.parse(readFileSync(join(folder, 'paper.json'), 'utf8'));
  /** @type {Report} */
  const report = only
    ? { ...readReport(), ...parts[only]() }
    : { ...parts.paper(), ...parts.scale(), ...parts.divided() };
  const { plot, scale, divided } = report;
  /**
   * @param {(figures: Figures) => number} value
   * @returns {import('./plot.mjs').Line[]}
   */
  const lines = (value) =>
    plot.map(({ name, figures }) => ({
      name,
      points: figures.map((one) => ({ x: one.faces / 1000, y: value(one) })),
    }));
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'paper.json'), `${JSON.stringify(report, null, 2)}\n`);
  writeFileSync(join(folder, 'paper.md'), markdown(report));
  writeFileSync(
    join(folder, 'paper.svg'),
    plotSvg('Seconds and megabytes for all vertices of six models against their faces', [
      {
        title: `Seconds, ${String(availableParallelism())} threads`,
        xTitle: 'thousands of faces',
        lines: lines(({ exact }) => exact.seconds),
      },
      {
        title: 'Megabytes of one thread',
        xTitle: 'thousands of faces',
        lines: lines(({ exact }) => exact.bytes / 1e6),
      },
    ]),
  );
  /**
   * @param {string} name
   * @param {Scale[]} of
   * @param {(one: Scale) => number | undefined} seconds
   */
  const scaleLine = (name, of, seconds) => ({
    name,
    points: of.flatMap((one) => {
      const y = seconds(one);
      return y === undefined ? [] : [{ x: one.faces, y }];
    }),
  });
  writeFileSync(
    join(folder, 'scale.svg'),
    plotSvg('Seconds for all vertices against triangles, by powers of ten', [
      {
        title: `Seconds, ${String(availableParallelism())} threads`,
        xTitle: 'triangles',
        isLog: true,
        lines: [
          scaleLine('exact', scale, ({ exact }) => exact.seconds),
          { ...scaleLine('refined', scale, ({ refined }) => refined?.seconds), at: 'below' },
          scaleLine('divided', divided, ({ refined }) => refined?.seconds),
          scaleLine('carried', scale, ({ carried }) => carried?.seconds),
          {
            name: 'the paper',
            at: 'left',
            points: [...paperTable.map(([x = 0, , , y = 0]) => [x, y]), paperElephant].map(
              ([x = 0, y = 0]) => ({ x, y }),
            ),
          },
        ],
      },
    ]),
  );
  runTool('oxfmt', [join(folder, 'paper.md'), join(folder, 'paper.json')]);
  console.log(`girth: wrote ${values.folder}/paper.{md,svg,json} and scale.svg`);
});
