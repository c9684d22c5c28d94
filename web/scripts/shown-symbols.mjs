// Functions that the shared libraries show: every one that the public headers declare and do not define. Doxygen says which
// these are, nm which the libraries show.

import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Complaint, outputOf, run } from './run.mjs';

/**
 * The text of the first element of a name.
 * @param {string} xml
 * @param {string} name
 */
const textOf = (xml, name) =>
  (new RegExp(`<${name}>(.*?)</${name}>`, 's').exec(xml)?.[1] ?? '')
    .replace(/<[^>]*>/g, '')
    .replace(/&lt;/g, '<')
    .replace(/&gt;/g, '>')
    .replace(/&amp;/g, '&');

/**
 * The qualified names of all functions that need a library, by Doxygen's XML of the public headers.
 * @returns {string[]}
 */
export function declaredFunctions() {
  const folder = mkdtempSync(join(tmpdir(), 'girth-headers-'));
  try {
    const settings = join(folder, 'Doxyfile');
    const lines = ['@INCLUDE = web/docs/reference/Doxyfile', `OUTPUT_DIRECTORY = ${folder}`];
    lines.push('GENERATE_HTML = NO', 'GENERATE_XML = YES', 'XML_PROGRAMLISTING = NO');
    writeFileSync(settings, `${lines.join('\n')}\n`);
    run('doxygen', [settings]);
    /** @type {Set<string>} */
    const names = new Set();
    for (const file of readdirSync(join(folder, 'xml'))) {
      const xml = readFileSync(join(folder, 'xml', file), 'utf8');
      const isTemplate = /<compounddef[^>]*>(?:(?!<sectiondef)[^])*<templateparamlist>/.test(xml);
      if (isTemplate) continue;
      for (const [member] of xml.matchAll(/<memberdef kind="function"[^]*?<\/memberdef>/g)) {
        const [head] = member.split('>', 1);
        const isDefined =
          / inline="yes"/.test(head ?? '') ||
          member.includes('<templateparamlist>') ||
          / constexpr="yes"/.test(head ?? '') ||
          /=\s*(delete|default|0)\s*$/.test(textOf(member, 'argsstring'));
        if (!isDefined) names.add(textOf(member, 'qualifiedname'));
      }
    }
    return [...names].sort();
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/**
 * The qualified names of the functions that a library shows.
 * @param {string} library
 * @param {string[]} options of nm
 * @returns {Set<string>}
 */
export function shownFunctions(library, options = ['--dynamic']) {
  const listed = outputOf('nm', [...options, '--demangle', '--defined-only', library]);
  if (listed === undefined) throw new Complaint(`nm cannot read ${library}`);
  return new Set(
    [
      ...listed.matchAll(/^[0-9a-f]+ [TW] (girth::[\w:~]+(?:operator[^(]*)?)(?:\[abi:\w+\])?\(/gm),
    ].map(([, name]) => /** @type {string} */ (name)),
  );
}

/**
 * Complains of each function of the public headers that none of the libraries shows.
 * @param {string[]} libraries
 */
export function checkShownFunctions(libraries) {
  const shown = new Set(libraries.flatMap((library) => [...shownFunctions(library)]));
  const hidden = declaredFunctions().filter((name) => !shown.has(name));
  if (hidden.length > 0) {
    throw new Complaint(`shared libraries hide what the headers declare: ${hidden.join(', ')}`);
  }
}
