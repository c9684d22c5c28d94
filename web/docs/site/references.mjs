// The references of C++ (Doxygen) and of JavaScript (TypeDoc) as parts of the site: a way back, its colours, and their names in
// the search.

import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import { words } from './search-index.mjs';

/** Characters of a page that are searched: what a name is, and the names of its members. */
const most = 400;

/** Pages of sources and lists have no words of their own. */
const isList = (/** @type {string} */ path) =>
  /(_source|-members|^cpp\/(annotated|classes|files|functions\w*|globals\w*|hierarchy|namespaces?(members\w*)?|pages|dir_\w+)|hierarchy)\.html$/.test(
    path,
  );

/** @param {string} name of the tool's folder @param {string} html */
function contentOf(name, html) {
  const content =
    name === 'cpp'
      ? /<div class="contents">([^]*)/
      : /<div class="col-content">([^]*?)<div class="col-sidebar">/;
  return words((content.exec(html)?.[1] ?? '').replace(/<script[^]*?<\/script>/g, ''));
}

/** A name as the search shows it. @param {string} name @param {string} html */
function titleOf(name, html) {
  const [, title = ''] = /<title>([^<]*)<\/title>/.exec(html) ?? [];
  return words(name === 'cpp' ? title.replace(/^Girth: /, '') : title.replace(/ \| girth$/, ''));
}

/**
 * Gives each page of the references a way back and the site's colours.
 * @param {string} folder where they are on the site
 * @returns what the search has of them
 */
export function joinReferences(folder) {
  return [
    { name: 'cpp', language: 'C++' },
    { name: 'js', language: 'JavaScript' },
  ].flatMap(({ name, language }) =>
    readdirSync(join(folder, name), { recursive: true, encoding: 'utf8' })
      .filter((file) => file.endsWith('.html'))
      .flatMap((file) => {
        const path = posix.join(name, ...file.split('\\'));
        const html = readFileSync(join(folder, path), 'utf8');
        const top = '../'.repeat(path.split('/').length);
        const style = `<link rel="stylesheet" href="${top}site/reference.css" />`;
        const back = `<a class="girth-back ${name}" href="${top}index.html">← Documentation of Girth</a>`;
        writeFileSync(
          join(folder, path),
          html.replace('</head>', `${style}</head>`).replace(/<body[^>]*>/, `$&${back}`),
        );
        if (isList(path)) return [];
        const title = titleOf(name, html);
        const text = contentOf(name, html).slice(0, most);
        return [{ id: `reference/${path}`, page: language, heading: title, text }];
      }),
  );
}
