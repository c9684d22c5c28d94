// Comments name their subject first: `npm run lint` refuses openings that point elsewhere, such as 'What' and 'Of'.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Complaint, repository } from './run.mjs';
import { filesBelow } from './stale.mjs';

/** Folders whose comments are checked: all that hold sources. */
const folders = [
  ...['cpp', 'tests'],
  ...['web/app', 'web/docs', 'web/examples', 'web/scripts'],
  ...['web/src/element', 'web/src/kernel', 'web/src/node', 'web/src/view'],
];

const opening = /^(?:And|Of|That|The same|Those|What|Who)\b/i;
/** A later sentence of a comment. */
const sentence = /[.!?] ((?:And|Of|That|The same|Those|What|Who)\b.*)$/;

/**
 * How a line of Python opens its part of a docstring: the docstring itself, or what is said of a parameter or a result.
 * @param {readonly string[]} lines
 * @param {number} i
 * @returns {string | undefined}
 */
function docstringAt(lines, i) {
  const [line = '', above = '', higher = ''] = [lines[i], lines[i - 1], lines[i - 2]];
  const begun = /^\s*"""(\S.*)$/.exec(line)?.[1];
  const isItem = /^\s+\*?[\w, *]+ : \S/.test(above) || /^\s+-{3,}$/.test(higher);
  return begun ?? (isItem ? line.trim() : undefined);
}

/**
 * The comments of a source, and sentences in them, that open without their subject, each as line and text.
 * @param {string} path its ending says how comments look
 * @param {string} text
 * @returns {{ line: number, comment: string }[]}
 */
export function openingsIn(path, text) {
  const isHash = /\.(?:cmake|in|py|pyi|sh)$|CMakeLists\.txt$/.test(path);
  const whole = isHash ? /^\s*#+!?\s*(.*)$/ : /^\s*(?:\/\/[/<]*|\/\*\*?|\*(?!\/))\s*(.*)$/;
  const behind = isHash ? /\s#\s+(.*)$/ : /\s\/\/[/<]*\s+(.*)$/;
  /** @type {{ line: number, comment: string }[]} */
  const found = [];
  let isInside = false;
  let before = '';
  const lines = text.split('\n');
  lines.forEach((line, i) => {
    const own = whole.exec(line)?.[1];
    const isBlock = !isHash && /^\s*\/\*/.test(line);
    const isLater = isInside && !isBlock;
    const comment = own === undefined ? behind.exec(line)?.[1] : isLater ? undefined : own;
    const begun = comment ?? (/\.pyi?$/.test(path) ? docstringAt(lines, i) : undefined);
    const all = own ?? behind.exec(line)?.[1] ?? '';
    // A sentence may begin where a line does.
    const later = sentence.exec(isLater ? `${before.trimEnd().slice(-1)} ${all}` : all)?.[1];
    const wrong = begun !== undefined && opening.test(begun) ? begun : later;
    if (wrong !== undefined) found.push({ line: i + 1, comment: wrong });
    before = all;
    isInside = own !== undefined && own !== '' && !line.trimEnd().endsWith('*/');
  });
  return found;
}

/** Fails where a comment of the checked folders opens so. */
export function checkOpenings() {
  const complaints = folders
    .flatMap(filesBelow)
    .filter((file) =>
      /\.(?:cjs|cmake|cpp|css|def|h|in|js|mjs|py|pyi|sh|ts)$|CMakeLists\.txt$/.test(file),
    )
    .flatMap((file) =>
      openingsIn(file, readFileSync(join(repository, file), 'utf8')).map(
        ({ line, comment }) => `${file}:${line}: name the subject first: ${comment}`,
      ),
    );
  if (complaints.length > 0) throw new Complaint(complaints.join('\n'));
}
