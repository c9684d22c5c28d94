// `npm run list:words`: writes all words that the page and the element show or speak into build/page-words.txt, by
// source file, so that a reader can go through them at one sitting.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import ts from 'typescript';
import { repository } from './run.mjs';
import { filesBelow } from './stale.mjs';

/** Two words or more: single ones are mostly names of classes, events and attributes. */
const severalWords = /[A-Za-z]{2,} +[A-Za-z{]/;
const isStyle = /[{;]\s*\n|^\s*[.#][\w-]+ |:scope/;

/**
 * The text of a literal; `…` stands for what a template puts in.
 * @param {import('typescript').Node} node
 */
function textOf(node) {
  if (ts.isStringLiteralLike(node)) return node.text;
  if (!ts.isTemplateExpression(node)) return '';
  return node.head.text + node.templateSpans.map((span) => `…${span.literal.text}`).join('');
}

/**
 * The words of a source file, each once, in its order.
 * @param {string} path
 */
function wordsOf(path) {
  const text = readFileSync(join(repository, path), 'utf8');
  if (path.endsWith('.html')) {
    return text
      .replace(/<(script|style)[\s\S]*?<\/\1>|<!--[\s\S]*?-->/g, '')
      .split(/<[^>]*>/)
      .map((words) => words.replace(/\s+/g, ' ').trim())
      .filter((words) => /[A-Za-z]/.test(words));
  }
  /** @type {Set<string>} */
  const words = new Set();
  /** @param {import('typescript').Node} node */
  const visit = (node) => {
    if (ts.isImportDeclaration(node) || ts.isExportDeclaration(node)) return;
    const one = textOf(node);
    if (severalWords.test(one) && !isStyle.test(one)) words.add(one.replace(/\s+/g, ' ').trim());
    ts.forEachChild(node, visit);
  };
  visit(ts.createSourceFile(path, text, ts.ScriptTarget.Latest, true));
  return [...words];
}

const paths = ['web/app', 'web/src/element']
  .flatMap(filesBelow)
  .filter((path) => /\.(ts|html)$/.test(path) && !path.includes('/examples/'));
const list = paths.flatMap((path) => {
  const words = wordsOf(path);
  return words.length === 0 ? [] : [`${path}\n${words.map((one) => `  ${one}\n`).join('')}`];
});
const output = join(repository, 'build/page-words.txt');
mkdirSync(join(repository, 'build'), { recursive: true });
writeFileSync(output, list.join('\n'));
console.log(output);
