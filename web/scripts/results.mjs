// The interfaces of results in TypeScript, of what girth/describe lists and the headers say.

import { descriptions, isExperimental, structOf, wordsOf } from './headers.mjs';

/** Public names that differ from those of C++. */
const publicNames = /** @type {Record<string, string>} */ ({
  AxisStation: 'AxisLoop',
  CurveSide: 'LoopSide',
  GirthLoop: 'Loop',
  GirthSolver: 'Mesh',
  PersistentMaximum: 'Maximum',
});

/** @param {string} struct */
export const publicName = (struct) => publicNames[struct] ?? struct;

/** Structs that are given, not found: their types have options. */
const given = new Set(['PrintLimits']);

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
function commentOf(...paragraphs) {
  const [only = ''] = paragraphs;
  if (paragraphs.length === 1 && only.length < 90) return `/** ${only} */\n`;
  const lines = paragraphs.map((words) => words.replace(/(.{1,100})(?: |$)/g, ' * $1\n'));
  return `/**\n${lines.join(' *\n')} */\n`;
}

/** All results, with what their members are in TypeScript. */
export function results() {
  const all = descriptions().filter(({ struct }) => !given.has(struct));
  const known = new Set(all.map(({ struct }) => struct));
  return all.map(({ struct, members }) => ({
    name: publicName(struct),
    ...structOf(struct),
    members: members
      .filter(({ how }) => how !== 'unwritten')
      .map((member) => {
        const [, entry = member.type] = /^std::vector<(\w+)>$/.exec(member.type) ?? [];
        const isList = known.has(entry) && entry !== member.type;
        const type = known.has(entry)
          ? publicName(entry) + (isList ? '[]' : '')
          : types[member.type];
        return { ...member, typescript: type ?? member.type, isEnumeration: type === undefined };
      }),
  }));
}

/** @param {ReturnType<typeof results>[number]['members'][number]} member */
function memberText({ how, name, type, comment, typescript }) {
  const none = type === 'Vertex' && /\bnone\b/.test(comment) ? ' None is -1.' : '';
  const words = commentOf(sentences(comment) + none);
  if (how === 'line') return polyline;
  const optional = how === 'memberWhere' ? '?' : '';
  return `${words}${name}${optional}: ${typescript};\n${how === 'curve' ? polyline : ''}`;
}

/** @param {string} name */
function wordsText(name) {
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
  const interfaces = all.map(({ name, file, comment, members }) => {
    const paragraphs = [sentences(comment), ...(isExperimental(file) ? ['@experimental'] : [])];
    return `${commentOf(...paragraphs)}export interface ${name} {\n${members.map(memberText).join('')}}\n`;
  });
  return `// Made of the headers in cpp/include/girth by \`npm run build:tables\`: not to be edited.

import type { SurfacePoint } from './points.js';

${[...new Set(enumerations)].map(wordsText).join('\n')}
${interfaces.join('\n')}`;
}
