// The pages of the documentation, in the order in which they are offered: where each document lies in the
// repository, and where on the site. Documents of web/docs that have no place in this list stand at its end.

import { filesBelow } from '../../scripts/stale.mjs';

/**
 * @typedef {object} Page
 * @property {string} file the document, relative to the top of the repository
 * @property {string} url relative to the top of the site
 * @property {string} [label] in the list of pages, where the document's title is too long for it
 */

/**
 * @typedef {object} Section
 * @property {string} title
 * @property {Page[]} pages
 * @property {{ url: string, label: string }[]} [others] made by other generators
 */

/**
 * A document of web/docs: its place on the site is that in the folder.
 * @param {string} name
 * @param {string} [label]
 * @returns {Page}
 */
const document = (name, label) => ({
  file: `web/docs/${name}.md`,
  url: `${name.replace(/(^|\/)README$/, '$1index')}.html`,
  ...(label ? { label } : {}),
});

/** @type {Section[]} */
const placed = [
  {
    title: 'Begin',
    pages: [
      document('README', 'Start'),
      document('girth', 'What the girth is'),
      document('tutorials/page', 'The page'),
      document('tutorials/command', 'The command'),
      document('tutorials/javascript', 'JavaScript'),
      document('tutorials/cpp', 'C++'),
      document('tutorials/python', 'Python'),
      document('tutorials/element', 'The element'),
    ],
  },
  {
    title: 'How to',
    pages: [
      document('how-to/check-a-print'),
      document('how-to/find-tips'),
      document('how-to/necks-and-handles', 'Necks, handles and cuts'),
      document('how-to/measure-a-tube'),
      document('how-to/part-tubes-and-plates'),
      document('how-to/compare-shapes'),
      document('how-to/study-a-collection'),
      document('how-to/measure-a-large-scan'),
      document('how-to/embed-on-a-static-host', 'Embed on a static host'),
      document('how-to/live-under-a-strict-policy'),
    ],
  },
  {
    title: 'Look up',
    pages: [
      { file: 'README.md', url: 'readme.html', label: 'At a glance' },
      document('choosing', 'Choosing'),
      document('projects'),
      document('outputs', 'Outputs'),
      document('print-check', 'The print check'),
      document('page', 'The page, in full'),
      document('command', 'The command, in full'),
      document('javascript', 'JavaScript, all calls'),
      document('cpp', 'C++, all ways to link'),
      document('python', 'Python, all calls'),
      document('element', 'The element, in full'),
      document('collections', 'Collections'),
      document('embedding', 'Embedding'),
      document('browsers', 'Browsers'),
      document('machines', 'Machines'),
      // Made of the table of codes (errors.mjs).
      { file: 'errors', url: 'errors.html' },
      document('definitions', 'Definitions'),
      document('stable'),
      // Made of help and of docstrings (command-reference.mjs, python-reference.mjs).
      { file: 'command-reference', url: 'reference/command.html', label: 'Command reference' },
      { file: 'python-reference', url: 'reference/python.html', label: 'Python reference' },
    ],
    others: [
      { url: 'reference/cpp/index.html', label: 'C++ reference' },
      { url: 'reference/js/index.html', label: 'JavaScript reference' },
    ],
  },
  {
    title: 'Studies',
    pages: [
      document('algorithm', 'How it is computed'),
      document('results', 'Results'),
      document('robustness', 'Robustness'),
      document('retrieval', 'Shape retrieval'),
      document('bench/paper', 'Timings'),
      { file: 'cpp/bench/README.md', url: 'benchmarks.html', label: 'Benchmarks' },
    ],
  },
  {
    title: 'How it is made',
    pages: [
      { file: 'ARCHITECTURE.md', url: 'architecture.html' },
      document('decisions/README'),
      document('decisions/definition-of-the-answer'),
      document('decisions/exactness-to-the-bit'),
      document('decisions/two-ways-of-being-parallel'),
      document('decisions/remeshing-defaults'),
      document('decisions/tinygltf-behind-guards'),
      document('decisions/what-outlives-what'),
      { file: 'CONTRIBUTING.md', url: 'contributing.html' },
      document('how-to-add', 'How to add'),
      document('vocabulary'),
      { file: 'tests/README.md', url: 'tests.html' },
      { file: 'tests/fuzz/README.md', url: 'fuzzing.html', label: 'Fuzzing' },
      { file: 'SECURITY.md', url: 'security.html' },
      { file: 'CHANGELOG.md', url: 'changes.html' },
    ],
  },
];

/** Whether a document has its place. */
const hasPlace = (/** @type {string} */ file) =>
  placed.some((section) => section.pages.some((page) => page.file === file));

const others = filesBelow('web/docs')
  .filter((file) => file.endsWith('.md') && !hasPlace(file))
  .map((file) => document(file.slice('web/docs/'.length, -'.md'.length)));

export const sections = others.length > 0 ? [...placed, { title: 'More', pages: others }] : placed;

/** All of them, in order. */
export const pages = sections.flatMap((section) => section.pages);
