// The tutorials and the pages on how to do things do what they say: every line of the command is run and every program in
// JavaScript too, on the built-in examples, and what they print is what stands below them.

import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { pages } from '../../web/docs/site/pages.mjs';
import { command, repository } from '../browser/support.js';
import { install } from '../web/package/packed.js';

interface Block {
  language: string;
  text: string;
}

/** The blocks of a document between ``` and ```, in order. */
function blocksOf(file: string): Block[] {
  const text = readFileSync(join(repository, file), 'utf8');
  return [...text.matchAll(/^```(\w*)\n([^]*?)^```$/gm)].map(([, language = '', text = '']) => ({
    language,
    text,
  }));
}

const folder = mkdtempSync(join(tmpdir(), 'girth-documents-'));
const documents = pages
  .map(({ file }) => file)
  .filter((file) => /^web\/docs\/(tutorials|how-to)\//.test(file));

beforeAll(() => {
  install(folder);
  const examples = join(repository, 'web/app/public/examples');
  cpSync(examples, folder, { recursive: true });
  for (const [kind, models] of Object.entries({
    round: ['dumbbell', 'cup'],
    branched: ['octopus', 'vessel'],
  })) {
    mkdirSync(join(folder, 'models', kind), { recursive: true });
    for (const model of models) {
      const small = join(folder, 'models', kind, `${model}.glb`);
      run(command, ['remesh', join(examples, `${model}.glb`), '--faces', '400', '-o', small]);
    }
  }
});

afterAll(() => rmSync(folder, { recursive: true }));

function run(program: string, args: string[]) {
  const done = spawnSync(program, args, { cwd: folder, encoding: 'utf8' });
  return { status: done.status ?? done.signal, output: done.stdout + done.stderr };
}

/** The lines of a block that are the command's, with the exit code that is stated behind them. */
const linesOf = ({ text }: Block) =>
  text
    .split('\n')
    .filter((line) => line.startsWith('girth '))
    .map((line) => {
      const [words = '', remark = ''] = line.split(/ +# /);
      return {
        // A name in quotes has a star that is not the shell's.
        args: words.replaceAll("'", '').split(' ').slice(1),
        code: Number(/ends with (\d)/.exec(remark)?.[1] ?? 0),
      };
    });

/** Each line of `text` stands in the output, in the same order. */
function expectLines(output: string, { text }: Block) {
  const printed = output.split('\n').map((line) => line.trimEnd());
  let at = 0;
  for (const line of text.trimEnd().split('\n')) {
    const found = printed.indexOf(line, at);
    expect(found, `'${line}' in\n${output}`).toBeGreaterThanOrEqual(0);
    at = found + 1;
  }
}

test.each(documents)('%s', (document) => {
  const blocks = blocksOf(document);
  blocks.forEach((block, i) => {
    let output = '';
    if (block.language === 'sh') {
      for (const { args, code } of linesOf(block)) {
        const done = run(command, args);
        expect(done.status, `girth ${args.join(' ')}\n${done.output}`).toBe(code);
        output += done.output;
      }
    } else if (block.language === 'js') {
      const done = run(process.execPath, ['--input-type=module', '--eval', block.text]);
      expect(done.status, `${block.text}\n${done.output}`).toBe(0);
      output = done.output;
    } else {
      return;
    }
    const next = blocks[i + 1];
    if (next?.language === 'text') expectLines(output, next);
  });
});

/** The names that the program with all calls leaves to the reader. */
const left = `const file = 'model.glb';
  const { signal } = new AbortController();
  const [onProgress, onPartial] = [() => {}, () => {}];`;

test('README.md and javascript.md: their programs', () => {
  run(command, ['remesh', 'octopus.glb', '--faces', '1500', '-o', 'model.glb']);
  const programs = ['web/docs/javascript.md', 'README.md'].flatMap((file) =>
    blocksOf(file).filter(({ language }) => language === 'js'),
  );
  expect(programs).toHaveLength(2);
  const [first = '', second = ''] = programs.map(({ text }) => text);
  for (const program of [`${left}\n${first}`, second]) {
    const done = run(process.execPath, ['--input-type=module', '--eval', program]);
    expect(done.status, `${program}\n${done.output}`).toBe(0);
  }
  expect(readFileSync(join(folder, 'values.csv'), 'utf8')).toMatch(/^vertex,igf,kind\n/);
});

/** Claims of figures' captions about the loop at a vertex. */
const claims = [
  { page: 'girth', model: 'dumbbell', vertex: 806, kind: 'loop', says: '130 mm' },
  { page: 'girth', model: 'dumbbell', vertex: 676, kind: 'antipodal', says: '1.21 m' },
  { page: 'girth', model: 'hill-high', vertex: 185, kind: 'loop', says: '425 mm' },
  { page: 'girth', model: 'hill-low', vertex: 185, kind: 'antipodal', says: '1.08 m' },
  { page: 'girth', model: 'cup', vertex: 1020, kind: 'loop', says: '33.7 mm' },
  { page: 'girth', model: 'cup', vertex: 1816, kind: 'loop', says: '128 mm' },
  { page: 'how-to/find-tips', model: 'octopus', vertex: 3843, kind: 'loop', says: '55.7 mm' },
  { page: 'how-to/find-tips', model: 'octopus', vertex: 3790, kind: 'loop', says: '829 mm' },
  { page: 'how-to/find-tips', model: 'handles', vertex: 1230, kind: 'loop', says: '306.6' },
  { page: 'how-to/find-tips', model: 'handles', vertex: 1299, kind: 'loop', says: '308.8 mm' },
  { page: 'how-to/necks-and-handles', model: 'spine', vertex: 704, kind: 'loop', says: '68.4 mm' },
  { page: 'how-to/necks-and-handles', model: 'vessel', vertex: 120, kind: 'loop', says: '40.7 mm' },
  {
    page: 'how-to/necks-and-handles',
    model: 'dumbbell',
    vertex: 806,
    kind: 'loop',
    says: '130 mm',
  },
  { page: 'how-to/necks-and-handles', model: 'hook', vertex: 456, kind: 'loop', says: '22.3 mm' },
];

test.each(claims)('$page: $model at $vertex has $says', ({ page, model, vertex, kind, says }) => {
  const text = readFileSync(join(repository, `web/docs/${page}.md`), 'utf8');
  expect(text.replace(/\s+/g, ' ')).toContain(says);
  const file = join(repository, `build/page/docs/models/${model}.glb`);
  const { output } = run(command, ['loop', file, String(vertex), '--json']);
  const loop = JSON.parse(output) as { length: number; kind: string };
  const [number = '', unit = 'mm'] = says.split(' ');
  const digits = number.split('.')[1]?.length ?? 0;
  expect((loop.length * (unit === 'm' ? 1 : 1000)).toFixed(digits)).toBe(number);
  expect(loop.kind).toBe(kind);
});

test('no line is left out for its language', () => {
  const languages = documents.flatMap((document) =>
    blocksOf(document).map(({ language }) => `${dirname(document)}: ${language}`),
  );
  // Languages that are not run here: C++ and CMake by tests/cpp/package/readme.sh, Python by tests/python/test_documents.py, HTML
  // by tests/browser/docs.test.ts.
  expect(new Set(languages.map((line) => line.split(': ')[1]))).toEqual(
    new Set(['sh', 'text', 'js', 'cpp', 'cmake', 'python', 'html']),
  );
});
