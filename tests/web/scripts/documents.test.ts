// The documents of the repository: every relative link leads somewhere, headings included, and every path
// that stands in backticks exists.

import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { basename, dirname, join, normalize } from 'node:path';
import { describe, expect, test } from 'vitest';
import { anchorsOf } from '../../../web/docs/site/anchors.mjs';
import { repository } from '../../../web/scripts/run.mjs';

const notOurs = /^(build.*|dist|node_modules|\.git|wasm)$/;

/** Relative paths of all files with that ending, build products left out. */
function filesBelow(folder: string, ending: string): string[] {
  return readdirSync(join(repository, folder), { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return notOurs.test(entry.name) ? [] : filesBelow(path, ending);
    return entry.name.endsWith(ending) ? [path] : [];
  });
}

const text = (path: string) => readFileSync(join(repository, path), 'utf8');

interface Document {
  /** Without blocks of code. */
  prose: string;
  /** The names by which links refer to its headings. */
  anchors: Set<string>;
}

/** A document by its path in the repository. */
function read(path: string): Document {
  const prose = text(path).replace(/^( *)(```|~~~)[^]*?^\1\2.*$/gm, '');
  const headings = [...prose.matchAll(/^#{1,6} +(.*?) *#*$/gm)].map(([, heading = '']) => heading);
  return { prose, anchors: new Set(anchorsOf(headings)) };
}

const documents = filesBelow('.', '.md');

/** Targets of links and pictures, in Markdown and in HTML. */
function targetsOf(prose: string): string[] {
  const withoutCode = prose.replace(/`[^`\n]*`/g, '');
  return [
    ...[...withoutCode.matchAll(/\]\(<?([^)<>\s]+)>?(?: "[^"]*")?\)/g)].map(
      ([, target]) => target!,
    ),
    ...[...withoutCode.matchAll(/ (?:src|srcset|href)="([^"]+)"/g)].map(([, target]) => target!),
  ];
}

/** Whether a path with * in it names at least one file. */
function matches(pattern: string): boolean {
  if (!pattern.includes('*')) return existsSync(join(repository, pattern));
  const folder = join(repository, dirname(pattern));
  if (folder.includes('*') || !existsSync(folder)) return false;
  const [before = '', after = ''] = basename(pattern).split('*');
  return readdirSync(folder).some((name) => name.startsWith(before) && name.endsWith(after));
}

test('there are documents', () => {
  expect(documents).toContain('README.md');
});

test.each(['README.md', 'CONTRIBUTING.md'])('%s has at most 8,000 bytes', (path) => {
  expect(Buffer.byteLength(text(path))).toBeLessThanOrEqual(8_000);
});

// npm's `girth` is nobody's, or somebody else's.
test.each(documents)('%s: npx does not ask npm for girth', (path) => {
  expect(text(path)).not.toMatch(/npx girth|npm install girth/);
});

test.each(documents)('%s: links lead somewhere', (path) => {
  const { prose } = read(path);
  const broken = targetsOf(prose).filter((link) => {
    if (/^[a-z]+:/.test(link)) return false;
    const [file = '', anchor] = link.split('#');
    const target = file === '' ? path : normalize(join(dirname(path), file));
    if (target.startsWith('..') || !existsSync(join(repository, target))) return true;
    return anchor !== undefined && target.endsWith('.md') && !read(target).anchors.has(anchor);
  });
  expect(broken).toEqual([]);
});

test.each(documents)('%s: paths of the repository exist', (path) => {
  const { prose } = read(path);
  const named = [...prose.matchAll(/`((?:cpp|web|tests)\/[^`\s{}()…]+)`/g)].map(
    ([, name]) => name!,
  );
  expect(named.filter((name) => !matches(name))).toEqual([]);
});

test('the commands that measure on fewer triangles are listed', () => {
  const measuring = filesBelow('cpp/cli/commands', '.cpp').filter((path) =>
    text(path).includes('addFacesOption(table'),
  );
  const [, listed = ''] = /those that measure \(([^)]+)\)/.exec(text('web/docs/command.md')) ?? [];
  expect([...listed.matchAll(/`(\w+)`/g)].map(([, name]) => name!).sort()).toEqual(
    measuring.map((path) => basename(path, '.cpp')).sort(),
  );
});

test('the change log has one line an entry, by what happened, without benchmarks', () => {
  const log = text('CHANGELOG.md');
  const newer = log.slice(log.indexOf('## [Unreleased]'), log.indexOf('## [0.1.0]'));
  const lines = newer.split('\n').filter((line) => line !== '');
  const kinds = ['### Added', '### Changed', '### Removed', '### Fixed'];
  const [, stable = ''] = newer.split(/^## \[1\.0\.0\] - .*$/m);
  expect(stable.split('\n').filter((line) => line.startsWith('#'))).toEqual(kinds);
  const [first = ''] = stable.split('\n').filter((line) => line !== '');
  expect(first).toContain('(web/docs/stable.md)');
  const headings = lines.filter((line) => line.startsWith('###'));
  expect(headings.filter((line) => !kinds.includes(line))).toEqual([]);
  const entries = lines.filter((line) => line !== first && !line.startsWith('#'));
  expect(entries.filter((line) => !/^- \S.*[.?]$/.test(line))).toEqual([]);
  expect(entries.filter((line) => line.length > 330)).toEqual([]);
  expect(entries.filter((line) => /\b(faster|slower|times as long)\b/.test(line))).toEqual([]);
});

describe('what is stable', () => {
  const page = text('web/docs/stable.md');

  test('lists the experimental headers', () => {
    const headers = filesBelow('cpp/include/girth', '.h')
      .filter((path) => /^\/\/ GIRTH_EXPERIMENTAL/m.test(text(path)))
      .map((path) => path.slice('cpp/include/girth/'.length))
      .filter((path) => !path.startsWith('study/'));
    const [, listed = ''] = page.split('## Experimental headers');
    expect([...listed.matchAll(/`([\w/]+\.h)`/g)].map(([, name]) => name!).sort()).toEqual(
      headers.sort(),
    );
  });

  test('lists the older names of options', () => {
    const sources = filesBelow('cpp/cli', '.cpp').map(text).join('');
    const former = [...sources.matchAll(/\.formerly\("([^"]+)"\)/g)].map(([, name]) => name!);
    const listed = [...page.matchAll(/^\| `(--[\w-]+)`/gm)].map(([, name]) => name!);
    expect(listed).toEqual([...new Set(former)].sort());
  });
});

test('the citation is of the latest release', () => {
  const [, released] = /^## \[(\d[^\]]*)\] - (\S+)$/m.exec(text('CHANGELOG.md')) ?? [];
  expect(released).toBeDefined();
  const [, cited] = /^version: (.*)$/m.exec(text('CITATION.cff')) ?? [];
  expect(cited).toBe(released);
});
