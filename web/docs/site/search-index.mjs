// The words of all pages, as the index that `client/search.js` searches.

import MiniSearch from 'minisearch';
import { searchOptions } from './client/search-options.js';

/** @param {string} html */
export const words = (html) =>
  html
    .replace(/<[^>]*>/g, ' ')
    .replace(/&#(\d+);/g, (_, code) => String.fromCharCode(Number(code)))
    .replace(/&lt;/g, '<')
    .replace(/&gt;/g, '>')
    .replace(/&quot;/g, '"')
    .replace(/&amp;/g, '&')
    .replace(/\s+/g, ' ')
    .trim();

/**
 * Each page in pieces, one for each heading.
 * @param {{ url: string, content: string }} page
 */
function pieces({ url, content }) {
  const [, body = ''] = /<main[^>]*>([^]*)<\/main>/.exec(content) ?? [];
  const headings = [...body.matchAll(/<h[1-3] id="([^"]*)"[^>]*>(.*?)<\/h[1-3]>/gs)];
  const page = words(headings[0]?.[2] ?? '');
  return headings.map(({ 1: anchor = '', 2: heading = '', index, 0: whole }, i) => ({
    id: i === 0 ? url : `${url}#${anchor}`,
    page,
    heading: words(heading),
    text: words(body.slice(index + whole.length, headings[i + 1]?.index)),
  }));
}

/**
 * The index as JSON.
 * @param {{ url: string, content: string }[]} pages
 * @param {{ id: string, page: string, heading: string, text: string }[]} references pieces of pages that others make
 */
export function searchIndex(pages, references) {
  const index = new MiniSearch(searchOptions);
  index.addAll([...pages.flatMap(pieces), ...references]);
  return JSON.stringify(index);
}
