// The calls of a mesh in TypeScript and Python that are the analyses of `analyses.def`.

import { analyses, functionOf, isExperimental, structOf, wordsOf } from './headers.mjs';
import {
  commentOf,
  inPython,
  options,
  publicName,
  results,
  sentences,
  snakeCase,
  wordsText,
  wrapped,
} from './results.mjs';

const made =
  '// Made of cpp/include/girth/analyses.def by `npm run build:tables`: not to be edited.\n';

/** The manual of an analysis. @param {ReturnType<typeof analyses>[number]} analysis */
function manualOf({ call }) {
  const { file, comment } = functionOf(call);
  return { words: comment, isExperimental: isExperimental(file) };
}

/** @typedef {ReturnType<typeof options>[number]['members'][number]} Member */

/** Whether a member of options must be given. @param {Member} member */
const isNeeded = ({ how }) => how === 'needed';

/** The type of an argument that is read, not changed. @param {string} type */
function readOnly(type) {
  if (type === 'Float64Array') return 'readonly number[] | Float64Array';
  return /\]$/.test(type) ? `readonly ${type}` : type;
}

/**
 * The default of an optional member, in the languages; undefined where it stands for nothing.
 * @param {string} struct
 * @param {Member} member
 * @returns {{ typescript: string, python: string } | undefined}
 */
function defaultOf(struct, { name, type, isEnumeration }) {
  const text = structOf(struct).members[name]?.byDefault ?? '';
  if (type === 'SurfacePoint') return undefined;
  if (type.startsWith('std::vector<')) return { typescript: '[]', python: '()' };
  if (type === 'Vec3') return { typescript: `[${text}]`, python: `(${text})` };
  if (isEnumeration) {
    const word = wordsOf(type).words.find(({ enumerator }) =>
      text.endsWith(`::${enumerator}`),
    )?.word;
    return { typescript: `'${word}'`, python: `"${word}"` };
  }
  const [, sign, infinite] = /^(-?)(std::numeric_limits<double>::infinity\(\))$/.exec(text) ?? [];
  if (infinite) return { typescript: `${sign}Infinity`, python: `${sign}math.inf` };
  const python = { true: 'True', false: 'False' }[text] ?? text;
  return { typescript: text, python };
}

/** Enumerations that options have and no result. */
function ownWords() {
  const enumerationsOf = (/** @type {ReturnType<typeof options>} */ structs) =>
    structs.flatMap(({ members }) =>
      members.filter(({ isEnumeration }) => isEnumeration).map(({ type }) => type),
    );
  const known = new Set(enumerationsOf(results()));
  return [...new Set(enumerationsOf(options()))].filter((name) => !known.has(name));
}

/** The options, and the calls of a mesh. */
export function typeScriptCalls() {
  const structs = options();
  const interfaces = structs.map(({ struct, name, comment, members }) => {
    const isOptions = analyses().some((one) => one.options === struct);
    const lines = members.map((member) => {
      const needed = isNeeded(member);
      const byDefault = needed ? undefined : defaultOf(struct, member)?.typescript;
      const words = byDefault === undefined ? '' : ` Default: ${byDefault}.`;
      const text = commentOf(sentences(member.comment) + words);
      return `${text}${member.name}${needed ? '' : '?'}: ${readOnly(member.typescript)};\n`;
    });
    const base = isOptions ? ' extends WatchedOptions' : '';
    return `${commentOf(sentences(comment))}export interface ${name}${base} {\n${lines.join('')}}\n`;
  });
  const calls = analyses().map((analysis) => {
    const { words, isExperimental } = manualOf(analysis);
    const paragraphs = [sentences(words), ...(isExperimental ? ['@experimental'] : [])];
    return `${commentOf(...paragraphs)}${analysis.name}(options: ${analysis.options}): Promise<${publicName(analysis.found)}>;\n`;
  });
  const found = namesFound();
  const own = ownWords();
  const words = options()
    .flatMap(({ members }) => members)
    .filter(({ type, isEnumeration }) => isEnumeration && !own.includes(type))
    .map(({ type }) => type);
  return `${made}
import type { WatchedOptions } from './call-options.js';
import type { SurfacePoint } from './points.js';
import type { ${[...new Set([...found, ...words])].join(', ')} } from './results.js';

${own.map(wordsText).join('\n')}
${interfaces.join('\n')}
/** Calls of a mesh, one for each analysis. */
export interface Analyses {
${calls.join('')}}

/** The results of analyses. */
export type FoundByAnalysis = ${found.join(' | ')};

/** The analyses: the list that only their results have, by the names of analyses. */
export const analysisLists: Readonly<Record<keyof Analyses, string>> = { ${analyses()
    .map(({ name, found }) => `${name}: '${listOf(found)}'`)
    .join(', ')} };
`;
}

/** The public names of the results. */
const namesFound = () => [...new Set(analyses().map(({ found }) => publicName(found)))];

/** The first list of a result. @param {string} found */
function listOf(found) {
  const lists = Object.entries(structOf(found).members).filter(([, { type }]) =>
    type.startsWith('std::vector<'),
  );
  if (lists.length === 0) throw new Error(`${found} has no list`);
  return lists[0]?.[0];
}

/**
 * The value that the core takes of an argument in Python.
 * @param {string} type
 * @param {string} value
 * @param {string} name
 * @returns {string}
 */
function taken(type, value, name) {
  const [, entry] = /^std::vector<(\w+)>$/.exec(type) ?? [];
  if (entry) return `[${taken(entry, 'one', name)} for one in ${value}]`;
  if (type === 'bool') return `bool(${value})`;
  if (type === 'double') return `real_number(${value}, "${name}")`;
  if (type === 'Index') return `whole_number(${value}, "${name}")`;
  if (type === 'Vec3') return `three_numbers(${value}, "${name}")`;
  if (type === 'std::string') return `str(${value})`;
  if (type === 'SurfacePoint') return `self._point(${value})`;
  const struct = structNamed(type);
  if (!struct) {
    const words = wordsOf(type).words.map(({ word }) => `"${word}"`);
    return `one_of(${value}, "${name}", [${words.join(', ')}])`;
  }
  const [only, ...others] = new Set(struct.members.map((member) => member.type));
  if (only && others.length === 0) return `[${taken(only, 'part', name)} for part in ${value}]`;
  const parts = struct.members.map((member) => {
    const key = snakeCase(member.name);
    if (isNeeded(member)) return taken(member.type, `entry_of(${value}, "${key}")`, key);
    const byDefault = defaultOf(type, member)?.python;
    if (byDefault === undefined) {
      return `${taken(member.type, `${value}["${key}"]`, key)} if "${key}" in ${value} else None`;
    }
    return taken(member.type, `${value}.get("${key}", ${byDefault})`, key);
  });
  return `(${parts.join(', ')})`;
}

/** A struct of options. @param {string} name */
const structNamed = (name) => options().find(({ struct }) => struct === name);

/** The annotation of an argument, its words in the manual, and what more is to be said. @param {string} type @returns {[annotation: string, words: string, more?: string]} */
function passed(type) {
  const [, entry] = /^std::vector<(\w+)>$/.exec(type) ?? [];
  if (entry) {
    const [annotation, words, more] = passed(entry);
    return [`Iterable[${annotation}]`, `sequence of ${words}`, more];
  }
  const plain = /** @type {Record<string, [string, string]>} */ ({
    bool: ['bool', 'bool'],
    double: ['float', 'float'],
    Index: ['int', 'int'],
    Vec3: ['Sequence[float]', 'three floats'],
    SurfacePoint: ['Any', 'point'],
    PointPair: ['tuple[Any, Any]', 'two points'],
  })[type];
  if (plain) return plain;
  const struct = structNamed(type);
  if (!struct)
    return [
      'str',
      wordsOf(type)
        .words.map(({ word }) => `"${word}"`)
        .join(' or '),
    ];
  const keys = struct.members.map(({ name, comment }) => {
    return `\`\`"${snakeCase(name)}"\`\`: ${sentences(comment)}`;
  });
  return ['Mapping[str, Any]', 'dict', keys.join(' ')];
}

/** The methods of a mesh in Python. */
export function pythonMethods() {
  const methods = analyses().map((analysis) => {
    const { name, options: struct } = analysis;
    const members = options().find((one) => one.struct === struct)?.members ?? [];
    const needed = members.filter(isNeeded);
    const optional = members.filter((member) => !isNeeded(member));
    const parameters = [
      'self',
      ...needed.map((member) => `${snakeCase(member.name)}: ${passed(member.type)[0]}`),
      '*',
      ...optional.map(
        (member) =>
          `${snakeCase(member.name)}: ${passed(member.type)[0]} = ${defaultOf(struct, member)?.python}`,
      ),
      'threads: Optional[int] = None',
      'progress: Progress = None',
    ];
    const described = [...needed, ...optional].map(({ name: member, type, comment }) => {
      const words = `${passed(type)[1]}${optional.some((one) => one.name === member) ? ', optional' : ''}`;
      const more = passed(type)[2];
      const text = [sentences(comment), ...(more ? [more] : [])].join(' ');
      const lines = wrapped(inPython(text), ' '.repeat(12));
      return `        ${snakeCase(member)} : ${words}\n${lines}`;
    });
    const values = members.map(({ name: member, type }) =>
      taken(type, snakeCase(member), snakeCase(member)),
    );
    const found = publicName(analysis.found);
    const [first = '', ...rest] = sentences(manualOf(analysis).words).split(/(?<=\.) (?=[A-Z*])/);
    const notes = wrapped(inPython(rest.join(' ')), ' '.repeat(8));
    return `    def ${snakeCase(name)}(
${parameters.map((one) => `        ${one},\n`).join('')}    ) -> ${found}:
${wrapped(`"""${inPython(first)}`, ' '.repeat(8))}
        Parameters
        ----------
${described.join('')}        threads, progress
            As of \`igf\`.

        Returns
        -------
        ${found}

        Notes
        -----
${notes}        """
        options = (
${values.map((one) => `            ${one},\n`).join('')}        )
        return ${found}(_girth.analyse("${name}", self._surface, options, running(threads, progress)))
`;
  });
  const all = methods.join('');
  const readers = ['entry_of', 'one_of', 'real_number', 'three_numbers', 'whole_number'].filter(
    (one) => all.includes(`${one}(`),
  );
  const types = ['Iterable', 'Mapping', 'Optional', 'Sequence'].filter((one) =>
    all.includes(`${one}[`),
  );
  return `"""The analyses of a mesh. Made of cpp/include/girth/analyses.def by \`npm run build:tables\`: not to be edited."""

from __future__ import annotations

${all.includes('math.') ? 'import math\n' : ''}from typing import Any, ${types.join(', ')}

from pygirth import _girth
from pygirth._arguments import Progress, ${[...readers, 'running'].sort().join(', ')}
from pygirth.results import ${namesFound().join(', ')}


class Analyses:
    _surface: "_girth.Surface"

    def _point(self, point: Any) -> tuple[int, list[float]]:
        raise NotImplementedError

${methods.join('\n')}`;
}
