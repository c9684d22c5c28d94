// The search: an index of all words, fetched when the field is first used, and asked on the reader's machine.

import { searchOptions } from './search-options.js';

/** Results that are shown. */
const most = 12;
/** Characters of a result's text. */
const excerptLength = 140;

/** The top of the site. */
const top = new URL('../', import.meta.url);

/** @type {Promise<{ search: (words: string) => any[] }> | undefined} */
let index;

// By address: both lie beside this script on the site only.
const script = new URL('minisearch.js', import.meta.url).href;
const wordIndex = new URL('search.json', import.meta.url).href;

/** Lets the search work without a network, where the page's service worker keeps what is fetched here. */
export async function keepSearch() {
  if (!navigator.serviceWorker?.controller) return;
  for (const address of [script, wordIndex]) {
    const isKept = (await caches.match(address)) !== undefined;
    if (!isKept) await fetch(address).catch(() => undefined);
  }
}

async function fetchIndex() {
  const { default: MiniSearch } = await import(script);
  const answer = await fetch(wordIndex);
  if (!answer.ok) throw new Error(`${answer.status} ${answer.url}`);
  return MiniSearch.loadJSON(await answer.text(), searchOptions);
}

/**
 * The place of a text where a word stands.
 * @param {string} text
 * @param {string[]} terms
 */
function excerptOf(text, terms) {
  const lower = text.toLowerCase();
  const places = terms.map((term) => lower.indexOf(term)).filter((place) => place >= 0);
  const start = Math.max(0, Math.min(...places, text.length) - 40);
  const from = places.length === 0 ? 0 : text.lastIndexOf(' ', start) + 1;
  const excerpt = text.slice(from, from + excerptLength);
  return `${from > 0 ? '… ' : ''}${excerpt}${from + excerptLength < text.length ? ' …' : ''}`;
}

/**
 * @param {{ id: string, page: string, heading: string, text: string, terms: string[] }} result
 */
function itemOf({ id, page, heading, text, terms }) {
  const item = document.createElement('li');
  const link = document.createElement('a');
  link.href = new URL(id, top).href;
  const title = document.createElement('b');
  title.textContent = heading === page ? page : `${page}: ${heading}`;
  const excerpt = document.createElement('span');
  excerpt.textContent = excerptOf(text, terms);
  link.append(title, excerpt);
  item.append(link);
  return item;
}

/** Brings a page's search to life. */
export function startSearch() {
  const form = /** @type {HTMLFormElement} */ (document.querySelector('form.search'));
  const field = /** @type {HTMLInputElement} */ (form.querySelector('input'));
  const results = /** @type {HTMLElement} */ (form.querySelector('.results'));
  const list = /** @type {HTMLElement} */ (results.querySelector('ol'));
  const status = /** @type {HTMLElement} */ (results.querySelector('[role=status]'));
  const links = () => [...list.querySelectorAll('a')];
  form.hidden = false;

  const show = async () => {
    const words = field.value.trim();
    results.hidden = words === '';
    if (words === '') return;
    try {
      index ??= fetchIndex();
      const found = (await index).search(words);
      // Something else has been typed meanwhile.
      if (words !== field.value.trim()) return;
      list.replaceChildren(...found.slice(0, most).map(itemOf));
      const count = found.length === 1 ? '1 place' : `${found.length} places`;
      status.textContent = found.length === 0 ? 'Nothing found' : count;
    } catch (error) {
      index = undefined;
      list.replaceChildren();
      status.textContent = `The index could not be loaded: ${/** @type {Error} */ (error).message}`;
    }
  };
  const hide = () => {
    results.hidden = true;
  };

  field.addEventListener('input', show);
  field.addEventListener('focus', show);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    links()[0]?.click();
  });
  form.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      hide();
      field.focus();
      hide();
    }
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step || results.hidden) return;
    event.preventDefault();
    const stops = [field, ...links()];
    const at = stops.indexOf(/** @type {HTMLInputElement} */ (document.activeElement));
    stops[(at + step + stops.length) % stops.length]?.focus();
  });
  form.addEventListener('focusout', ({ relatedTarget }) => {
    if (!form.contains(/** @type {Node | null} */ (relatedTarget))) hide();
  });
  document.addEventListener('keydown', (event) => {
    const inText = /** @type {HTMLElement} */ (event.target).closest?.('input, girth-viewer');
    if (event.key !== '/' || inText || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    field.focus();
  });
}
