// The calls of a mesh in TypeScript and Python that are the analyses of `analyses.def`.

import { analyses, functionOf, isExperimental, structOf } from './headers.mjs';
import {
  commentOf,
  inPython,
  options,
  publicName,
  sentences,
  snakeCase,
  wrapped,
} from './results.mjs';

const made =
  '// Made of cpp/include/girth/analyses.def by `npm run build:tables`: not to be edited.\n';

/** The manual of an analysis. @param {ReturnType<typeof analyses>[number]} analysis */
function manualOf({ call }) {
  const { file, comment } = functionOf(call);
  return { words: comment, isExperimental: isExperimental(file) };
}

/** Whether a member of options must be given. @param {{ type: string }} member */
const isNeeded = ({ type }) => !/^(bool|double|Index|[A-Z]\w*Kind)$/.test(type);

/** An argument list that is read, not changed. @param {string} type */
const readOnly = (type) => type.replace(/^(\w+)\[\]$/, 'readonly $1[]');

/** @param {string} struct @param {string} member */
const defaultOf = (struct, member) => structOf(struct).members[member]?.byDefault ?? '';

/** The options, and the calls of a mesh. */
export function typeScriptCalls() {
  const structs = options();
  const interfaces = structs.map(({ struct, name, comment, members }) => {
    const isOptions = analyses().some((one) => one.options === struct);
    const lines = members.map((member) => {
      const needed = !isOptions || isNeeded(member);
      const words = needed ? '' : ` Default: ${defaultOf(struct, member.name)}.`;
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
  const found = analyses().map(({ found }) => publicName(found));
  return `${made}
import type { WatchedOptions } from './call-options.js';
import type { SurfacePoint } from './points.js';
import type { ${found.join(', ')} } from './results.js';

${interfaces.join('\n')}
/** Calls of a mesh, one for each analysis. */
export interface Analyses {
${calls.join('')}}

/** The results of analyses. */
export type FoundByAnalysis = ${found.join(' | ')};

/** The analyses: the list that only their results have, by their names. */
export const analysisLists: Readonly<Record<keyof Analyses, string>> = { ${analyses()
    .map(({ name, found }) => `${name}: '${listOf(found)}'`)
    .join(', ')} };
`;
}

/** The list of a result. @param {string} found */
function listOf(found) {
  const lists = Object.entries(structOf(found).members).filter(([, { type }]) =>
    type.startsWith('std::vector<'),
  );
  if (lists.length !== 1) throw new Error(`${found} has ${lists.length} lists, not one`);
  return lists[0]?.[0];
}

/** The methods of a mesh of workers. */
export function typeScriptMethods() {
  const methods = analyses().map(
    ({ name, options, found }) =>
      `${name}(options: ${options}): Promise<${publicName(found)}> {\nreturn this.analyse('${name}', options);\n}\n`,
  );
  const names = analyses().map(({ options }) => options);
  const found = analyses().map(({ found }) => publicName(found));
  return `${made}
import type { Analyses, ${names.join(', ')} } from '../types/analyses.js';
import type { ${found.join(', ')}, WatchedOptions } from '../types/types.js';

/** A mesh that hands analyses on. */
export abstract class MeshWithAnalyses implements Analyses {
  protected abstract analyse<Found extends object>(
    name: keyof Analyses,
    options: WatchedOptions,
  ): Promise<Found>;

${methods.join('\n')}}
`;
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
  if (type === 'Vec3') return `[real_number(part, "${name}") for part in ${value}]`;
  if (type === 'SurfacePoint') return `self._point(${value})`;
  const members = options().find(({ struct }) => struct === type)?.members ?? [];
  const types = new Set(members.map((member) => member.type));
  const [only] = types;
  if (!only || types.size > 1) throw new Error(`Python has no argument of the type ${type}`);
  return `[${taken(only, 'part', name)} for part in ${value}]`;
}

/** The annotation of an argument, and its words in the manual. @param {string} type @returns {[annotation: string, words: string]} */
function passed(type) {
  const [, entry] = /^std::vector<(\w+)>$/.exec(type) ?? [];
  if (entry) return [`Iterable[${passed(entry)[0]}]`, `sequence of ${passed(entry)[1]}`];
  const plain = /** @type {Record<string, [string, string]>} */ ({
    bool: ['bool', 'bool'],
    double: ['float', 'float'],
    Index: ['int', 'int'],
    Vec3: ['Sequence[float]', 'three floats'],
    SurfacePoint: ['Any', 'point'],
    PointPair: ['tuple[Any, Any]', 'two points'],
  })[type];
  if (!plain) throw new Error(`Python has no argument of the type ${type}`);
  return plain;
}

/** A default as Python writes it. @param {string} text */
const pythonValue = (text) => ({ true: 'True', false: 'False' })[text] ?? text;

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
          `${snakeCase(member.name)}: ${passed(member.type)[0]} = ${pythonValue(defaultOf(struct, member.name))}`,
      ),
      'threads: Optional[int] = None',
      'progress: Progress = None',
    ];
    const described = [...needed, ...optional].map(({ name: member, type, comment }) => {
      const words = `${passed(type)[1]}${optional.some((one) => one.name === member) ? ', optional' : ''}`;
      const lines = wrapped(inPython(sentences(comment)), ' '.repeat(12));
      return `        ${snakeCase(member)} : ${words}\n${lines}`;
    });
    const values = members.map(({ name: member, type }) =>
      taken(type, snakeCase(member), snakeCase(member)),
    );
    const found = publicName(analysis.found);
    const [first = '', ...rest] = sentences(manualOf(analysis).words).split(/(?<=\.) (?=[A-Z])/);
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
  const classes = analyses().map(({ found }) => publicName(found));
  const readers = ['real_number', 'whole_number'].filter((one) =>
    methods.some((method) => method.includes(`${one}(`)),
  );
  return `"""The analyses of a mesh. Made of cpp/include/girth/analyses.def by \`npm run build:tables\`: not to be edited."""

from __future__ import annotations

from typing import Any, ${methods.some((one) => one.includes('Iterable[')) ? 'Iterable, ' : ''}Optional${methods.some((one) => one.includes('Sequence[')) ? ', Sequence' : ''}

from pygirth import _girth
from pygirth._arguments import Progress, ${[...readers, 'running'].join(', ')}
from pygirth._members import ${classes.join(', ')}


class Analyses:
    _surface: "_girth.Surface"

    def _point(self, point: Any) -> tuple[int, list[float]]:
        raise NotImplementedError

${methods.join('\n')}`;
}
