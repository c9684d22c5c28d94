// The documentation as it is built: whatever its pages refer to is there, on the site itself, and every code of errors is
// on its page.

import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import MiniSearch from 'minisearch';
import { beforeAll, expect, test } from 'vitest';
import { errorCodes } from '../../../web/docs/site/errors.mjs';
import { figures } from '../../../web/docs/site/figures.mjs';
import { pages } from '../../../web/docs/site/pages.mjs';
import { searchOptions } from '../../../web/docs/site/client/search-options.js';
import { repository } from '../../../web/scripts/run.mjs';

/** The page, with the documentation below it. */
const served = join(repository, 'build/page');
const site = join(served, 'docs');

const text = (path: string) => readFileSync(join(site, path), 'utf8');

beforeAll(() => {
  if (!existsSync(join(site, 'index.html'))) throw new Error('first: npm run build:docs');
});

const own = [...pages.map(({ url }) => url)];

/** Targets that a page refers to, by the attribute that names them. */
function targetsOf(html: string): { name: string; target: string }[] {
  return [...html.matchAll(/<(\w[\w-]*)[^>]*? (href|src|srcset|poster)="([^"]*)"/g)].map(
    ([, tag = '', attribute = '', target = '']) => ({ name: `${tag} ${attribute}`, target }),
  );
}

const namesOf = (html: string) =>
  new Set([...html.matchAll(/ (?:id|name)="([^"]*)"/g)].map(([, name]) => name));

test.each(own)('%s: all that it refers to is there', (page) => {
  const broken = targetsOf(text(page)).filter(({ target }) => {
    if (/^(https:|mailto:)/.test(target)) return false;
    const [path = '', anchor] = target.split('#');
    let file = path === '' ? join(site, page) : join(site, dirname(page), path);
    if (relative(served, file).startsWith('..') || !existsSync(file)) return true;
    if (statSync(file).isDirectory()) file = join(file, 'index.html');
    if (!existsSync(file)) return true;
    return (
      anchor !== undefined &&
      file.endsWith('.html') &&
      !namesOf(readFileSync(file, 'utf8')).has(decodeURIComponent(anchor))
    );
  });
  expect(broken).toEqual([]);
});

test.each(own)('%s: loads nothing from elsewhere, and has one title', (page) => {
  const html = text(page);
  const loaded = targetsOf(html).filter(
    ({ name, target }) => name !== 'a href' && /^(\w+:)?\/\//.test(target),
  );
  expect(loaded).toEqual([]);
  expect(html).not.toMatch(/<script(?![^>]* src=)|<style| on\w+="/);
  expect(html.match(/<h1\b/g)).toHaveLength(1);
  expect(html).toMatch(/<title>[^<]*Girth<\/title>/);
});

test('the page links to the documentation', () => {
  expect(readFileSync(join(served, 'index.html'), 'utf8')).toContain('href="./docs/"');
});

test('every code of errors has its row', () => {
  const codes = errorCodes();
  const table = readFileSync(join(repository, 'cpp/include/girth/error_codes.def'), 'utf8');
  expect(codes.length).toBe(table.match(/^GIRTH_ERROR_CODE\(/gm)!.length);
  const html = text('errors.html');
  for (const { code, remedy } of codes) {
    expect(html).toContain(`id="${code}"`);
    expect(html).toContain(remedy.replace(/"/g, '&quot;'));
  }
});

test('words are found where they stand', () => {
  const index = MiniSearch.loadJSON(text('site/search.json'), searchOptions);
  const found = (words: string) => index.search(words).map(({ id }) => String(id));
  expect(found('persistence')).toContain('definitions.html#persistent-girth');
  expect(found('NON_MANIFOLD_EDGE')[0]).toMatch(/^errors\.html/);
  expect(found('content security policy')).toContain('embedding.html#content-security-policy');
  expect(found('zzzzzz')).toEqual([]);
});

test('the search has all four references', () => {
  const index = MiniSearch.loadJSON(text('site/search.json'), searchOptions);
  const found = (words: string) => index.search(words).map(({ id }) => String(id));
  expect(found('girth bottleneck options')).toContain('reference/command.html#girth-bottleneck');
  expect(found('print_check')).toContain('reference/python.html#meshprint_check');
  expect(found('PersistentMaximum')).toContain(
    'reference/cpp/structgirth_1_1PersistentMaximum.html',
  );
  expect(found('createKernel')).toContain('reference/js/functions/girth.createKernel.html');
});

test('every page of the references leads back, in colours of the site', () => {
  for (const name of ['cpp', 'js']) {
    const folder = join(site, 'reference', name);
    const files = readdirSync(folder, { recursive: true, encoding: 'utf8' });
    for (const file of files.filter((one) => one.endsWith('.html'))) {
      const html = readFileSync(join(folder, file), 'utf8');
      const [, back = ''] = /<a class="girth-back \w+" href="([^"]*)"/.exec(html) ?? [];
      expect(join(folder, dirname(file), back), file).toBe(join(site, 'index.html'));
      const [, style = ''] = /href="([^"]*reference\.css)"/.exec(html) ?? [];
      expect(existsSync(join(folder, dirname(file), style)), file).toBe(true);
    }
  }
});

test('the references of command and Python say what the programs say', () => {
  const command = text('reference/command.html');
  const sources = readdirSync(join(repository, 'cpp/cli/commands'));
  const names = sources.filter((name) => /^(igf|[a-z]+\.cpp)$/.test(name));
  const others = ['command.cpp', 'help.cpp', 'table.cpp'];
  for (const name of names.filter((one) => !others.includes(one))) {
    expect(command).toContain(`id="girth-${name.replace('.cpp', '')}"`);
  }
  const python = text('reference/python.html');
  const init = readFileSync(join(repository, 'cpp/python/pygirth/__init__.py'), 'utf8');
  const [, list = ''] = /__all__ = \[([^\]]*)\]/.exec(init) ?? [];
  const modules = ['FIELDS', 'collection', 'errors', 'results'];
  for (const [, name = ''] of list.matchAll(/"(\w+)"/g)) {
    if (!modules.includes(name)) expect(python).toContain(`<code>pygirth.${name}</code>`);
  }
});

test('every figure is on a page, with its model and its picture', () => {
  const all = own.map(text).join();
  for (const [name, { model }] of Object.entries(figures)) {
    expect(all).toContain(`id="figure-${name}"`);
    expect(existsSync(join(site, `models/${model}.glb`)), model).toBe(true);
  }
  const pictures = readdirSync(join(repository, 'web/docs/images/live'));
  expect(pictures.sort()).toEqual(
    Object.keys(figures)
      .map((name) => `${name}.webp`)
      .sort(),
  );
});
