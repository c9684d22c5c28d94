// How Markdown becomes the body of a page. The documents are plain Markdown, which repository views show too;
// here headings get their names, links lead to pages, code gets colours, and pictures of figures become live.

import { existsSync, statSync } from 'node:fs';
import { posix } from 'node:path';
import highlighter from 'highlight.js';
import { repository } from '../../scripts/run.mjs';
import { anchorsOf } from './anchors.mjs';
import { figureOf, posterSize } from './figures.mjs';
import { pages } from './pages.mjs';

/**
 * @typedef {object} Token of markdown-it, as far as it is used here
 * @property {string} type
 * @property {string} tag
 * @property {string} content
 * @property {string} info
 * @property {Token[] | null} children
 * @property {[string, string][] | null} attrs
 * @property {(name: string) => string | null} attrGet
 * @property {(name: string, value: string) => void} attrSet
 */

/**
 * @typedef {object} Place where a document lies
 * @property {string} file in the repository
 * @property {string} root from its page to the top of the site
 * @property {Set<string>} sources receives the files of the repository that it refers to and that are no pages
 */

/** @param {string} text */
export const escaped = (text) =>
  text.replace(/[&<>"]/g, (sign) => `&#${String(sign.charCodeAt(0))};`);

/** Where files of the repository that are no pages lie on the site. */
export const sourceAddress = (/** @type {string} */ file) =>
  file.startsWith('web/docs/images/') || file.startsWith('web/docs/bench/')
    ? file.slice('web/docs/'.length)
    : `source/${file}.txt`;

/** Whether it is an address of its own, with a scheme, rather than a path. */
const isElsewhere = (/** @type {string} */ link) => /^[a-z]+:/.test(link);

/**
 * Where a link of a document leads on the site; nothing where the site has no such thing, which folders are.
 * @param {string} link
 * @param {Place} place
 */
function onSite(link, { file, root, sources }) {
  if (isElsewhere(link) || link.startsWith('#')) return link;
  const [path = '', anchor] = link.split('#');
  const target = posix.normalize(posix.join(posix.dirname(file), path));
  const page = pages.find((page) => page.file === target);
  const suffix = anchor === undefined ? '' : `#${anchor}`;
  if (page) return `${root}${page.url}${suffix}`;
  if (target === 'cpp/include/girth/error_codes.def') return `${root}errors.html`;
  if (!existsSync(`${repository}${target}`)) throw new Error(`${file}: nothing at ${link}`);
  if (statSync(`${repository}${target}`).isDirectory()) return undefined;
  sources.add(target);
  return `${root}${sourceAddress(target)}`;
}

/**
 * @param {Token[]} tokens
 * @param {Place} place
 */
function followLinks(tokens, place) {
  /** @type {Token | undefined} */
  let nowhere;
  for (const token of tokens) {
    if (token.type === 'link_open') {
      const address = onSite(String(token.attrGet('href')), place);
      if (address === undefined) {
        // A folder: its name stays.
        token.tag = 'span';
        token.attrs = null;
        nowhere = token;
      } else {
        token.attrSet('href', address);
      }
    } else if (token.type === 'link_close' && nowhere) {
      token.tag = 'span';
      nowhere = undefined;
    } else if (token.type === 'image') {
      token.attrSet('src', String(onSite(String(token.attrGet('src')), place)));
      token.attrSet('loading', 'lazy');
    }
  }
}

/**
 * Headings get the names that links use, and a link to themselves.
 * @param {Token[]} tokens
 */
function nameHeadings(tokens) {
  const headings = tokens.flatMap((token, i) =>
    token.type === 'heading_open' ? [{ token, line: /** @type {Token} */ (tokens[i + 1]) }] : [],
  );
  const anchors = anchorsOf(headings.map(({ line }) => line.content));
  headings.forEach(({ token }, i) => token.attrSet('id', String(anchors[i])));
}

/**
 * A header cell without a word says nothing to those who hear tables: it is an ordinary cell.
 * @param {Token[]} tokens
 */
function emptyHeaders(tokens) {
  tokens.forEach((token, i) => {
    if (token.type === 'th_open' && tokens[i + 1]?.content === '') {
      token.tag = 'td';
      /** @type {Token} */ (tokens[i + 2]).tag = 'td';
    }
  });
}

/**
 * A paragraph that begins with the picture of a figure (figures.mjs) becomes that figure, the words behind the
 * picture its caption. The picture stays: it is what those see who have no script or no WebGL, and what is printed.
 * @param {Token[]} tokens
 * @param {Place} place
 * @param {new (type: string, tag: string, nesting: number) => Token} Token
 */
function liveFigures(tokens, { root }, Token) {
  const html = (/** @type {string} */ content) =>
    Object.assign(new Token('html_block', '', 0), { content });
  for (let i = 0; i + 2 < tokens.length; ++i) {
    const [open, line, close] = [tokens[i], tokens[i + 1], tokens[i + 2]];
    const picture = line?.children?.[0];
    if (open?.type !== 'paragraph_open' || picture?.type !== 'image' || !line || !close) continue;
    const name = /images\/live\/(.*)\.webp$/.exec(String(picture.attrGet('src')))?.[1];
    if (name === undefined) continue;
    const { model, attributes } = figureOf(name);
    const stated = Object.entries({ ...attributes, loading: 'lazy' })
      .map(([key, value]) => ` ${key}="${escaped(value)}"`)
      .join('');
    tokens[i] = html(`<figure class="live" id="figure-${name}">
<div class="stage">
<girth-viewer src="${root}models/${model}.glb"${stated}></girth-viewer>
<img class="poster" src="${root}images/live/${name}.webp" width="${posterSize.width}" height="${posterSize.height}" loading="lazy" alt="${escaped(picture.content)}">
</div>
<figcaption>`);
    // The break behind the picture goes too.
    line.children = (line.children ?? []).slice(2);
    tokens[i + 2] = html('</figcaption>\n</figure>\n');
  }
}

/**
 * Code in colours.
 * @param {string} code
 * @param {string} language as it stands behind the ```
 */
function coloured(code, language) {
  const known = highlighter.getLanguage(language);
  return known ? highlighter.highlight(code, { language }).value : escaped(code);
}

/**
 * Changes what Eleventy renders Markdown with.
 * @param {any} md
 */
export function amendMarkdown(md) {
  md.core.ruler.push('site', (/** @type {any} */ state) => {
    const tokens = /** @type {Token[]} */ (state.tokens);
    /** @type {Place} */
    const place = state.env.place;
    nameHeadings(tokens);
    emptyHeaders(tokens);
    liveFigures(tokens, place, state.Token);
    for (const { children } of tokens) if (children) followLinks(children, place);
  });
  const { rules } = md.renderer;
  // Tables that are wider than a phone can be scrolled, by the keyboard too.
  rules.table_open = () =>
    '<div class="wide" tabindex="0" role="group" aria-label="Table"><table>\n';
  rules.table_close = () => '</table></div>\n';
  rules.fence = (/** @type {Token[]} */ tokens, /** @type {number} */ i) => {
    const { content, info } = /** @type {Token} */ (tokens[i]);
    return `<pre tabindex="0"><code>${coloured(content, info.trim())}</code></pre>\n`;
  };
}
