// The types of results in TypeScript and Python, of what girth/describe lists and the headers say.

import { analyses, descriptions, isExperimental, read, structOf, wordsOf } from './headers.mjs';

/** Public names that differ from those of C++. */
const publicNames = /** @type {Record<string, string>} */ ({
  AxisStation: 'AxisLoop',
  CurveSide: 'LoopSide',
  GeodesicPath: 'SurfacePath',
  GirthLoop: 'Loop',
  GirthSolver: 'Mesh',
  PersistentMaximum: 'Maximum',
});

/** @param {string} struct */
export const publicName = (struct) => publicNames[struct] ?? struct;

/** Names of generated types that `types.ts` extends by members of JavaScript alone, under the public name. */
const extended = /** @type {Record<string, string>} */ ({
  Barcode: 'MeasuredBarcode',
  Loop: 'MeasuredLoop',
  PathStation: 'MeasuredStation',
  Segment: 'MeasuredSegment',
  SurfacePath: 'MeasuredPath',
});

/** The generated type of a struct in TypeScript. @param {string} struct */
const typeName = (struct) => extended[publicName(struct)] ?? publicName(struct);

/** Classes of Python that have a name of their own. */
const pythonNames = /** @type {Record<string, string>} */ ({
  ContourLine: 'Contour',
  GeodesicPath: 'Path',
  PersistentMaximum: 'Maximum',
});

/** The class of a struct in Python. @param {string} struct */
const pythonName = (struct) => pythonNames[struct] ?? publicName(struct);

/** Structs, with those that their members are made of. @param {string[]} structs */
function withEntries(structs) {
  const all = descriptions();
  const found = new Set(structs);
  for (const struct of found) {
    for (const { type } of all.find((one) => one.struct === struct)?.members ?? []) {
      const [entry = ''] = /\w+(?=>*$)/.exec(type) ?? [];
      if (all.some((one) => one.struct === entry)) found.add(entry);
    }
  }
  return found;
}

/** Classes of Python that `results.py` extends by what is only there. */
const extendedInPython = () =>
  new Set(
    [...read('cpp/python/pygirth/results.py').matchAll(/\b_members\.([A-Z]\w+)/g)].map(
      ([, name]) => name ?? '',
    ),
  );

/** Structs that are given, not found. The type of `PrintLimits` is written by hand: it has options. */
const given = () => withEntries(['PrintLimits', ...analyses().map(({ options }) => options)]);

/** @typedef {ReturnType<typeof descriptions>[number]['members'][number]} Member */

/** A comment as sentences, with public names. @param {string} words */
export function sentences(words) {
  const text = (words.charAt(0).toUpperCase() + words.slice(1)).replace(
    /\b([A-Z]\w+)::(\w+)/g,
    (_, struct, member) => `\`${publicName(struct)}.${member}\``,
  );
  return /[.!?]$/.test(text) ? text : `${text}.`;
}

/** Types of members in TypeScript. */
const types = /** @type {Record<string, string>} */ ({
  bool: 'boolean',
  double: 'number',
  Index: 'number',
  Vertex: 'number',
  Vec3: '[number, number, number]',
  SurfacePoint: 'SurfacePoint',
  'std::string': 'string',
  GirthProfile: 'GirthStation[]',
  'std::string_view': 'string',
  'std::vector<double>': 'Float64Array',
  'std::vector<Index>': 'number[]',
  'std::vector<Vertex>': 'Uint32Array',
  'std::vector<Face>': 'Uint32Array',
  'std::vector<SurfacePoint>': 'SurfacePoint[]',
});

const polyline =
  '/** x, y, z of its points, relative to `MeshGeometry.origin`. */\npolyline: Float32Array;\n';

/** Comments in lines that are not too long. @param {string[]} paragraphs */
export function commentOf(...paragraphs) {
  const [only = ''] = paragraphs;
  if (paragraphs.length === 1 && only.length < 90) return `/** ${only} */\n`;
  const lines = paragraphs.map((words) => words.replace(/(.{1,100})(?: |$)/g, ' * $1\n'));
  return `/**\n${lines.join(' *\n')} */\n`;
}

/** All results, with what their members are in TypeScript. */
export function results() {
  const without = given();
  return typed(descriptions().filter(({ struct }) => !without.has(struct)));
}

/** The options of analyses, in the same way. */
export function options() {
  const all = withEntries(analyses().map(({ options }) => options));
  return typed(descriptions().filter(({ struct }) => all.has(struct)));
}

/** @param {ReturnType<typeof descriptions>} all */
function typed(all) {
  const known = new Set(all.map(({ struct }) => struct));
  return all.map(({ struct, members }) => ({
    struct,
    name: publicName(struct),
    ...structOf(struct),
    members: members
      .filter(({ how }) => how !== 'unwritten')
      .map((member) => {
        const [, entry = member.type] = /^std::vector<(\w+)>$/.exec(member.type) ?? [];
        const isList = known.has(entry) && entry !== member.type;
        const type = known.has(entry)
          ? typeName(entry) + (isList ? '[]' : '')
          : member.how === 'drawnPoint'
            ? '[number, number, number]'
            : types[member.type];
        return { ...member, typescript: type ?? member.type, isEnumeration: type === undefined };
      }),
  }));
}

/** @param {ReturnType<typeof results>[number]['members'][number]} member */
function memberText({ how, name, type, comment, typescript }) {
  const drawn = how === 'drawnPoint' ? ' x, y, z, relative to `MeshGeometry.origin`.' : '';
  const none = type === 'Vertex' && /\bnone\b/.test(comment) ? ' None is -1.' : '';
  const words = commentOf(sentences(comment) + none + drawn);
  if (how === 'line') return polyline;
  const optional = how === 'memberWhere' ? '?' : '';
  return `${words}${name}${optional}: ${typescript};\n${how === 'curve' ? polyline : ''}`;
}

/** @param {string} name */
export function wordsText(name) {
  const { comment, words } = wordsOf(name);
  const meanings = words.map(({ word, meaning }) => `- \`'${word}'\`: ${meaning}`).join('\n * ');
  const type = words.map(({ word }) => `'${word}'`).join(' | ');
  return `/**\n * ${sentences(comment)}\n *\n * ${meanings}\n */\nexport type ${name} = ${type};\n`;
}

export function resultsText() {
  const all = results();
  const enumerations = all.flatMap(({ members }) =>
    members.filter(({ isEnumeration }) => isEnumeration).map(({ typescript }) => typescript),
  );
  const interfaces = all.map(({ struct, file, comment, members }) => {
    const paragraphs = [sentences(comment), ...(isExperimental(file) ? ['@experimental'] : [])];
    return `${commentOf(...paragraphs)}export interface ${typeName(struct)} {\n${members.map(memberText).join('')}}\n`;
  });
  return `// Made of the headers in cpp/include/girth by \`npm run build:tables\`: not to be edited.

import type { SurfacePoint } from './points.js';

${[...new Set(enumerations)].map(wordsText).join('\n')}
${interfaces.join('\n')}`;
}

/** Types of members in Python: of the attribute, and in words where these say more. */
const pythonTypes = /** @type {Record<string, [string, string?]>} */ ({
  bool: ['bool'],
  double: ['float'],
  Index: ['int'],
  Vertex: ['int'],
  Vec3: ['np.ndarray', 'ndarray of float64, shape (3,)'],
  SurfacePoint: ['np.ndarray', 'ndarray of float64, shape (3,)'],
  GirthProfile: ['np.ndarray', 'ndarray of float64, shape (stations, 4)'],
  'std::string': ['str'],
  'std::string_view': ['str'],
  KindShares: ['dict[str, float]', 'dict of str to float'],
  'std::vector<CurveSide>': ['np.ndarray', 'ndarray of float64, shape (sides, 2)'],
  'std::vector<double>': ['np.ndarray', 'ndarray of float64'],
  'std::vector<Index>': ['list[int]', 'list of int'],
  'std::vector<Vertex>': ['np.ndarray', 'ndarray of int64'],
  'std::vector<Face>': ['np.ndarray', 'ndarray of int64'],
  'std::vector<SurfacePoint>': ['np.ndarray', 'ndarray of float64, shape (k, 3)'],
});

/** @param {string} name */
export const snakeCase = (name) => name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);

/** A member as Python has it. @param {ReturnType<typeof results>[number]['members'][number]} member */
function pythonMember({ how, name, type, comment, typescript, isEnumeration }) {
  const [, entry = ''] = /^std::vector<(\w+)>$/.exec(type) ?? [];
  const ofClass = pythonName(entry);
  const isOfMembers = descriptions().some(({ struct }) => struct === type);
  const [annotation, words = annotation] = isEnumeration
    ? ['str']
    : (pythonTypes[type] ??
      (entry
        ? [`list["${ofClass}"]`, `list of ${ofClass}`]
        : isOfMembers
          ? [`"${pythonName(type)}"`, pythonName(type)]
          : []));
  if (/^(from|in|is|class|with|global|lambda)$/.test(name)) {
    throw new Error(`${name} is no name of a member in Python`);
  }
  if (annotation === undefined) throw new Error(`${name} has a type that Python has not: ${type}`);
  const columns = /** @type {Record<string, string>} */ ({
    GirthProfile: 'GirthStation',
    'std::vector<CurveSide>': 'CurveSide',
  })[type];
  const more = [
    ...(isEnumeration
      ? wordsOf(typescript).words.map(
          ({ word, meaning }) => `\`\`"${word}"\`\`: ${sentences(meaning)}`,
        )
      : []),
    ...(columns ? columnsOf(columns) : []),
    ...(type === 'Vertex' ? ['-1 where there is none, or the preparation made it.'] : []),
  ];
  const text = [sentences(comment), ...more].join(' ');
  const isOptional = how === 'memberWhere';
  return {
    name: snakeCase(name),
    annotation: isOptional ? `Optional[${annotation}]` : annotation,
    words: isOptional ? `${words}, or None` : words,
    text: inPython(text),
  };
}

/** The numbers of each row, where a list of structs is an array. @param {string} struct */
function columnsOf(struct) {
  const found = results().find((one) => one.struct === struct);
  const columns = (found?.members ?? []).filter(({ type }) => type === 'double');
  return ['Columns:', ...columns.map(({ name, comment }) => `${name}: ${sentences(comment)}`)];
}

/** Names of members as Python has them. @param {string} text */
export const inPython = (text) =>
  text.replace(/`([a-z]\w*)`/g, (_, name) => `\`\`${snakeCase(name)}\`\``);

/** @param {string} text @param {string} indent */
export const wrapped = (text, indent) =>
  text.replace(new RegExp(`(.{1,${96 - indent.length}})(?: |$)`, 'g'), `${indent}$1\n`);

export function pythonText() {
  const hand = extendedInPython();
  const made = [...withEntries(analyses().map(({ found }) => found))]
    .map(pythonName)
    .filter((name) => !hand.has(name));
  const wanted = new Set([...hand, ...made]);
  const classes = results().flatMap(({ struct, comment, members }) => {
    const name = pythonName(struct);
    if (!wanted.has(name)) return [];
    const own = members.map(pythonMember);
    const attributes = own.map(
      ({ name: attribute, words, text }) =>
        `    ${attribute} : ${words}\n${wrapped(text, '        ')}`,
    );
    const kept = members.flatMap(({ how, type }) => [
      ...(how === 'curve' ? ['_curve'] : []),
      ...(type === 'GirthProfile' ? ['_places'] : []),
    ]);
    const entries = own.flatMap(({ name: attribute, annotation }) => {
      const [, entry] = /^(?:list\[)?"(\w+)"\]?$/.exec(annotation) ?? [];
      return entry ? [`"${attribute}": "${entry}"`] : [];
    });
    const annotations = [
      ...(entries.length > 0 ? [`    _entries = {${entries.join(', ')}}\n`] : []),
      ...own.map(({ name: attribute, annotation }) => `    ${attribute}: ${annotation}\n`),
      ...kept.map((attribute) => `    ${attribute}: tuple[np.ndarray, np.ndarray]\n`),
    ];
    const summary = wrapped(`"""${inPython(sentences(comment))}`, '    ');
    return `class ${name}(_Members):\n${summary}\n    Attributes\n    ----------\n${attributes.join('')}    """\n\n${annotations.join('')}`;
  });
  return `"""The members of results. Made of the headers in cpp/include/girth by \`npm run build:tables\`: not to be edited."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from pygirth._result import Result

__all__ = [${made
    .sort()
    .map((name) => `"${name}"`)
    .join(', ')}]


class _Members(Result):
    #: The names of the classes of results within a result, alone or in lists, by member.
    _entries: dict[str, str] = {}
    #: The classes by their names: of two with one name the later one, which extends the other.
    _classes: dict[str, Any] = {}

    def __init_subclass__(cls) -> None:
        if cls.__module__.startswith("pygirth."):
            _Members._classes[cls.__name__] = cls

    def __init__(self, found: dict[str, Any]) -> None:
        self.__dict__.update(found)
        for member, name in self._entries.items():
            entry, given = self._classes[name], found[member]
            made = [entry(one) for one in given] if isinstance(given, list) else entry(given)
            setattr(self, member, made)

    def _line(self) -> str:
        found = self.__dict__.items()
        lists = [name for name in self._entries if isinstance(self.__dict__[name], list)]
        counts = [f"{len(self.__dict__[name])} {name}" for name in lists]
        numbers = [f"{name} {value:.6g}" for name, value in found if isinstance(value, float)]
        return ", ".join(counts + numbers)


${classes.join('\n\n')}`;
}

/** The unit that a comment states, as documents name it. @param {string} comment */
export function unitOf(comment) {
  const [, power] = /\b(squared |cubed )?model units\b/.exec(comment) ?? [];
  if (power !== undefined) return power === 'squared ' ? 'area' : 'volume';
  if (/\bmodel units\b/.test(comment)) return 'length';
  return /\bradians\b/.test(comment) ? 'radian' : '';
}

/** Tables of the members of results in JSON. */
export function documentTables() {
  return results()
    .map((found) => {
      const rows = found.members.map(({ name, type, typescript, comment, isEnumeration }) => {
        const words = isEnumeration
          ? wordsOf(typescript).words.map(({ word }) => `\`${word}\``)
          : [];
        const meaning = [sentences(comment), ...(words.length > 0 ? [`${words.join(', ')}.`] : [])];
        return `| \`${name}\` | ${/double|Vec3/.test(type) ? unitOf(comment) : ''} | ${meaning.join(' ')} |`;
      });
      return `### ${found.name}\n\n${sentences(found.comment)}\n\n| member | unit | meaning |\n| --- | --- | --- |\n${rows.join('\n')}`;
    })
    .join('\n\n');
}
