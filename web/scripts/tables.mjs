// Makes the tables of TypeScript and of documents from those in C++ (`fields.def`, `analyses.def`, `length_units.def`, `describe/`), and the
// manual of the element's attributes from their rules: `npm run build:tables`.

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { format } from 'oxfmt';
import { attributes } from './element-manifest.mjs';
import { entriesOf, headers, read, structOf } from './headers.mjs';
import { optionNamesText } from './option-names.mjs';
import { pythonMethods, typeScriptCalls } from './analyses.mjs';
import { pythonFields } from './python-fields.mjs';
import { documentTables, pythonText, resultsText } from './results.mjs';
import { repository } from './run.mjs';

/**
 * The default of a member of a struct, as C++ has it.
 * @param {string} struct
 * @param {string} member
 */
export function defaultOf(struct, member) {
  const found = structOf(struct).members[member];
  if (!found) throw new Error(`${struct} has no member ${member}`);
  return found.byDefault;
}

/** The fields in the order of the table, those of the spectrum last. */
export function fields() {
  const table = `${headers}/fields.def`;
  const vertex = entriesOf(table, 'GIRTH_VERTEX_FIELD').map(
    ([name = '', unit = '', module = '', title = '', listTitle = '', meaning = '']) => {
      return { name, unit, module, title, listTitle, meaning, number: 0, count: 1 };
    },
  );
  const spectral = entriesOf(table, 'GIRTH_SPECTRAL_FIELD').map(
    ([name = '', unit = '', title = '', listTitle = '', meaning = '', , number, many = '']) => {
      const [, struct = '', member = ''] = /^(\w+)\{\}\.(\w+)$/.exec(many) ?? [];
      const count = struct ? Number(defaultOf(struct, member)) : 1;
      const module = 'girth-studies';
      return { name, unit, module, title, listTitle, meaning, number: Number(number), count };
    },
  );
  return [...vertex, ...spectral];
}

/** A member of FieldOptions. @param {string} name */
function fieldOption(name) {
  const found = structOf('FieldOptions').members[name];
  if (!found) throw new Error(`FieldOptions has no ${name}`);
  return found;
}

/** Parameters of fields, with the comments and defaults of the structs that hold them. */
export function parameters() {
  return entriesOf(`${headers}/fields.def`, 'GIRTH_FIELD_PARAMETER').map(
    ([keyword = '', , of = '', kind = '', path = '', , , words = '']) => {
      const [outer = '', inner] = path.split('.');
      const holder = fieldOption(outer);
      const group = inner === undefined ? undefined : { name: outer, type: holder.type };
      const member = group ? structOf(group.type).members[inner ?? ''] : holder;
      if (!member) throw new Error(`FieldOptions has no ${path}`);
      return { keyword, fields: of.split(' '), kind, path, group, words, ...member };
    },
  );
}

/** @param {{ kind: string, byDefault: string }} parameter */
function defaultWords({ kind, byDefault }) {
  if (kind === 'Method') return "'fast-marching'";
  if (kind === 'Points') return 'the first vertex';
  if (byDefault.includes('infinity')) return 'Infinity';
  if (kind !== 'Degrees') return byDefault;
  return `${byDefault}, ${Math.round((Number(byDefault) * 180e6) / Math.PI) / 1e6}°`;
}

/** As a comment, in lines that are not too long. @param {string} words */
const commentOf = (words) =>
  words.length < 90
    ? `/** ${words} */`
    : `/**\n${words.replace(/(.{1,100})(?: |$)/g, ' * $1\n')} */`;

/** @param {ReturnType<typeof parameters>[number]} parameter */
const memberText = (parameter) => {
  const type = { Method: "'fast-marching' | 'exact'", Points: 'readonly SurfacePoint[]' }[
    parameter.kind
  ];
  const name = parameter.path.split('.').at(-1);
  const words = `${parameter.comment} Default: ${defaultWords(parameter)}.`;
  return `${commentOf(words)}\n${name}?: ${type ?? 'number'};\n`;
};

const unitWords = {
  Length: 'in model units',
  Radian: 'in radians',
  PerArea: 'in 1 / squared model units',
  Number: 'without a unit',
};

/** @param {ReturnType<typeof fields>} list */
const nameType = (list) =>
  `${list.map(({ name, unit, meaning }) => ` * - \`'${name}'\`: ${meaning}; ${unitWords[/** @type {keyof typeof unitWords} */ (unit)]}.`).join('\n')}\n`;

/** @param {ReturnType<typeof fields>} list */
const union = (list) => list.map(({ name }) => `'${name}'`).join(' | ');

/** The first line of everything that is made here. @param {string} table */
const made = (table) =>
  `// Made of cpp/include/girth/${table} by \`npm run build:tables\`: not to be edited.\n`;

const heatTime = () =>
  Number(/kHeatMaximaTime = (.*);/.exec(read(`${headers}/heat_maxima.h`))?.[1]);

function fieldsText() {
  const all = fields();
  const spectral = all.filter(({ module }) => module === 'girth-studies');
  const vertex = all.filter((one) => !spectral.includes(one));
  const given = parameters();
  const groups = [...new Set(given.flatMap(({ group }) => (group ? [group.name] : [])))];
  const interfaces = groups.map((name) => {
    const members = given.filter(({ group }) => group?.name === name);
    const type = members[0]?.group?.type ?? '';
    return `/** ${structOf(type).comment} */\nexport interface ${type} {\n${members.map(memberText).join('')}}\n`;
  });
  const own = given.filter(({ group }) => !group);
  const grouped = groups.map((name) => {
    const member = fieldOption(name);
    return `/** ${member.comment} */\n${name}?: ${member.type};\n`;
  });
  const record = (
    /** @type {(one: ReturnType<typeof fields>[number]) => unknown} */ valueOf,
    list = all,
  ) => `{ ${list.map((one) => `${one.name}: ${JSON.stringify(valueOf(one))}`).join(', ')} }`;
  return `${made('fields.def')}
import type { SurfacePoint } from './points.js';

/**
 * Fields that are computed vertex by vertex.
 *
${nameType(vertex)} */
export type VertexFieldName = ${union(vertex)};

/**
 * Fields that are computed from the surface's spectrum. They come all at once, without partial values. Each value is one
 * number of the vertex's signature.
 *
${nameType(spectral)} */
export type SpectralFieldName = ${union(spectral)};

/** All fields that the kernel computes. */
export type FieldName = VertexFieldName | SpectralFieldName;

${interfaces.join('\n')}
/** Parameters of single fields. Each field reads its own. */
export interface FieldParameters {
${own.map(memberText).join('')}${grouped.join('')}}

/** Where these are in \`FieldParameters\`. */
export const parameterPaths = ${JSON.stringify(given.map(({ path }) => path))} as const;

/** The kind of unit of each field. */
export const fieldUnits: Readonly<Record<FieldName, 'Length' | 'Radian' | 'PerArea' | 'Number'>> = ${record(({ unit }) => unit)};

/** Names in words, for a legend. */
export const fieldTitles: Readonly<Record<FieldName, string>> = ${record(({ title }) => title)};

/** Names in a list, with what papers call them. */
export const fieldListTitles: Readonly<Record<FieldName, string>> = ${record(({ listTitle }) => listTitle)};

/** The meaning of a value, as the middle of a sentence. */
export const fieldMeanings: Readonly<Record<FieldName, string>> = ${record(({ meaning }) => meaning)};

/** Fields that the small module has where their persistence is 0. */
export const girthModuleFields: readonly string[] = ${JSON.stringify(vertex.filter(({ module }) => module === 'girth').map(({ name }) => name))};

/** Fields that depend on how long saddles must last. */
export const persistentFields: readonly FieldName[] = ${JSON.stringify(given.find(({ path }) => path === 'persistence')?.fields)};

/** The time of heat by default, as a share of the area. */
export const usualTime = ${heatTime()};

/** The numbers of a signature, of which a field is one. */
export interface SignatureNumbers {
  /** How many there are. */
  readonly count: number;
  /** Which one is taken by default, counted from 1. */
  readonly usual: number;
}

/** The numbers of each signature. */
export const signatureNumbers: Readonly<Record<SpectralFieldName, SignatureNumbers>> = ${record(({ count, number }) => ({ count, usual: number }), spectral)};
`;
}

function unitsText() {
  const units = entriesOf(`${headers}/io/length_units.def`, 'GIRTH_LENGTH_UNIT').map(
    ([symbol, name, metres]) => `{ symbol: '${symbol}', name: '${name}', metres: ${metres} },`,
  );
  return `${made('io/length_units.def')}
/** A unit of length. */
export interface LengthUnit {
  /** 'mm' */
  readonly symbol: string;
  /** 'millimetre' */
  readonly name: string;
  /** In one of it: 0.001. */
  readonly metres: number;
}

/** Units of length, small ones first. */
export const lengthUnits: readonly LengthUnit[] = [${units.join('')}];

/** The unit with that symbol or name; undefined where there is none. */
export function findLengthUnit(symbolOrName: string): LengthUnit | undefined {
  return lengthUnits.find(({ symbol, name }) => symbol === symbolOrName || name === symbolOrName);
}
`;
}

/** Defaults that JavaScript hands to operations of workers: the member of a struct. */
const handedOn = [
  ['RefinedOptions', 'coarseFaces'],
  ['RefinedOptions', 'audit'],
  ['RefinedOptions', 'seed'],
  ['LimbOptions', 'stations'],
  ['HandleOptions', 'basePoints'],
  ['PathProfileOptions', 'samples'],
];

function defaultsText() {
  const members = handedOn.map(
    ([struct = '', member = '']) => `${member}: ${defaultOf(struct, member)},`,
  );
  return `// Made of the headers in cpp/include/girth by \`npm run build:tables\`: not to be edited.

/** The defaults of options of analyses. */
export const defaults = { ${members.join('')} } as const;
`;
}

const documentUnits = { Length: 'length', Radian: 'radian', PerArea: '1 / area', Number: '' };

/** The table of fields in a document. */
function documentTable() {
  const rows = fields().map(({ name, unit, meaning }) => {
    return `| \`${name}\` | ${documentUnits[/** @type {keyof typeof documentUnits} */ (unit)]} | ${meaning} |`;
  });
  return `| field | unit | a value is |\n| --- | --- | --- |\n${rows.join('\n')}`;
}

const ruleFile = 'web/src/element/attributes/attributes.ts';

/** The table of attributes in a document. */
function attributeTable() {
  const rows = attributes().map(({ name, description }) => `| \`${name}\` | ${description} |`);
  return `| attribute | what it does, and what it can be |\n| --- | --- |\n${rows.join('\n')}`;
}

/** Comments of the attributes' types. */
function attributeTypes() {
  const path = 'web/src/element/attributes/attribute-types.ts';
  return attributes().reduce((text, { name, description }) => {
    const member = new RegExp(`  /\\*\\*(?:(?!\\*/)[^])*\\*/\\n(?=  '?${name}'?\\?:)`);
    if (!member.test(text)) throw new Error(`${path} has no commented member for ${name}`);
    return text.replace(member, () => commentWith(description));
  }, read(path));
}

/**
 * A member's comment.
 * @param {string} words
 */
function commentWith(words) {
  if (words.length < 90) return `  /** ${words} */\n`;
  const lines = [''];
  for (const word of words.split(' ')) {
    if (`${lines.at(-1)} ${word}`.length > 94) lines.push('');
    lines.push(`${lines.pop()} ${word}`);
  }
  return `  /**\n${lines.map((line) => `   *${line}\n`).join('')}   */\n`;
}

/** Parts that are made here, each between two comments, by their documents. */
const parts = {
  'web/docs/outputs.md': [
    { name: 'fields', of: 'cpp/include/girth/fields.def', text: documentTable },
    { name: 'results', of: 'cpp/include/girth/describe', text: documentTables },
  ],
  'web/docs/embedding.md': [{ name: 'attributes', of: ruleFile, text: attributeTable }],
};

/** @param {keyof typeof parts} document */
function documentText(document) {
  return parts[document].reduce((text, { name, of, text: partText }) => {
    const begin = `<!-- ${name}: made of ${of} by \`npm run build:tables\` -->`;
    const [from, to] = [text.indexOf(begin), text.indexOf(`<!-- ${name} end -->`)];
    if (from < 0 || to < from) throw new Error(`${document} has no place for the part ${name}`);
    return `${text.slice(0, from)}${begin}\n\n${partText()}\n\n${text.slice(to)}`;
  }, read(document));
}

/** Every file that is made of tables, by its path. */
export async function tables() {
  const types = {
    'web/src/kernel/types/fields.ts': fieldsText(),
    'web/src/kernel/types/length-units.ts': unitsText(),
    'web/src/kernel/types/defaults.ts': defaultsText(),
    'web/src/kernel/types/results.ts': resultsText(),
    'web/src/kernel/types/analyses.ts': typeScriptCalls(),
  };
  const texts = {
    ...types,
    'web/src/kernel/types/option-names.ts': optionNamesText(types),
    'web/docs/outputs.md': documentText('web/docs/outputs.md'),
    'web/docs/embedding.md': documentText('web/docs/embedding.md'),
    'web/src/element/attributes/attribute-types.ts': attributeTypes(),
  };
  const style = /** @type {const} */ ({ singleQuote: true, printWidth: 100 });
  const formatted = Object.entries(texts).map(async ([path, text]) => {
    return /** @type {const} */ ([path, (await format(path, text, style)).code]);
  });
  return {
    ...Object.fromEntries(await Promise.all(formatted)),
    'cpp/python/pygirth/_members.py': pythonText(),
    'cpp/python/pygirth/_analyses.py': pythonMethods(),
    'cpp/python/pygirth/_fields.py': pythonFields(parameters()),
  };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  for (const [path, text] of Object.entries(await tables()))
    writeFileSync(join(repository, path), text);
}
