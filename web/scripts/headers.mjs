// Structs and enumerations of the public headers of C++, for the tables that are made of them.

import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { repository } from './run.mjs';

export const headers = 'cpp/include/girth';

/** @param {string} path */
export const read = (path) => readFileSync(join(repository, path), 'utf8');

/** Every header and its text. */
const texts = new Map(
  readdirSync(join(repository, headers), { recursive: true })
    .map(String)
    .filter((file) => file.endsWith('.h'))
    .map((file) => [file, read(join(headers, file))]),
);

/**
 * A comment as one line, without its marks and its examples.
 * @param {string} comment
 */
export const plain = (comment) =>
  comment
    .replace(/\\code\n[^]*?\\endcode/g, '')
    .replace(/^ *\/\/\/<? ?/gm, '')
    .trim()
    .replace(/\s+/g, ' ');

/**
 * A declaration of the public headers: its comment, its body, and its header.
 * @param {string} kind
 * @param {string} name
 */
function declarationOf(kind, name) {
  const pattern = new RegExp(
    `((?:^///.*\\n)*)^${kind} (?:GIRTH_EXPORT )?${name}(?: : [\\w:]+)? \\{\\n([^]*?)^\\};`,
    'm',
  );
  for (const [file, text] of texts) {
    const [, comment = '', body] = pattern.exec(text) ?? [];
    if (body !== undefined) return { file, text, comment: plain(comment), body };
  }
  throw new Error(`no header has a ${kind} ${name}`);
}

/**
 * A struct of the public headers: its comment, and its members, data and functions without arguments.
 * @param {string} name
 */
export function structOf(name) {
  const { file, comment, body } = declarationOf('struct', name);
  const members = body.matchAll(
    /((?:^ {2}\/\/\/.*\n)*)^ {2}(?:GIRTH_EXPORT )?([\w:<>, ]+) (\w+)(?:\{(.*?)\}|(\(\) const)(?: \{.*\})?)?(?:;|(?<=\}))(?: *\/\/\/< (.*(?:\n {10,}\/\/\/< .*)*))?/gm,
  );
  return {
    file,
    comment,
    members: Object.fromEntries(
      [...members].map(([, words, type = '', member = '', byDefault = '', isFunction, behind]) => [
        member,
        {
          type,
          comment: plain(words || (behind ?? '')),
          byDefault: byDefault.replaceAll("'", ''),
          isFunction: isFunction !== undefined,
        },
      ]),
    ),
  };
}

/**
 * An enumeration whose words `toString` gives: its comment, its words, and what each means.
 * @param {string} name
 */
export function wordsOf(name) {
  const { text, comment, body } = declarationOf('enum class', name);
  const written = new RegExp(
    `((?:^///.*\\n)+)^GIRTH_EXPORT std::string_view toString\\(${name} `,
    'm',
  );
  const words = [...(written.exec(text)?.[1] ?? '').matchAll(/"([\w ]+)"/g)].map(
    ([, word = '']) => word,
  );
  const meanings = [
    ...body.matchAll(/((?:^ {2}\/\/\/.*\n)*)^ {2}(\w+)(?: = \d+)?,(?: *\/\/\/< (.*))?/gm),
  ].map(([, before, enumerator = '', behind = '']) => {
    return { enumerator, meaning: plain(before || behind) };
  });
  if (words.length === 0 || words.length !== meanings.length) {
    throw new Error(`the comment of toString(${name}) does not list the words of ${name}`);
  }
  return {
    comment,
    words: words.map((word, i) => ({ enumerator: '', meaning: '', ...meanings[i], word })),
  };
}

/** Whether a header is marked as one that may change. @param {string} file */
export const isExperimental = (file) => texts.get(file)?.includes('// GIRTH_EXPERIMENTAL') ?? false;

/** The members that girth/describe lists, by struct. */
export function descriptions() {
  const found = [...texts].filter(([file]) => file.startsWith('describe/'));
  return found.flatMap(([file, text]) => {
    const functions = text.matchAll(/^constexpr auto describe\(Members<(\w+)>\) \{\n([^]*?)^\}/gm);
    return [...functions].map(([, struct = '', body = '']) => ({
      struct,
      members: membersOf(struct, body, join(headers, file)),
    }));
  });
}

/**
 * The members that the body of a describe() lists. All of the struct's must be among them.
 * @param {string} struct
 * @param {string} body
 * @param {string} file
 */
export function membersOf(struct, body, file) {
  const known = structOf(struct).members;
  const calls = [...body.matchAll(/\b(\w+)\((?:\s*"(\w+)",)?\s*&\w+::(\w+)/g)];
  const listed = calls.map(([, how = '', name = '', member = '']) => ({ how, name, member }));
  for (const member of Object.keys(known)) {
    if (known[member]?.isFunction || listed.some((one) => one.member === member)) continue;
    throw new Error(`${struct}::${member} is not described: list it in ${file}`);
  }
  return listed.map(({ how, name, member }) => {
    const declared = known[member];
    if (!declared) throw new Error(`${file}: ${struct} has no member ${member}`);
    if (declared.comment === '') throw new Error(`${struct}::${member} has no comment`);
    return { how, name, type: declared.type, comment: declared.comment };
  });
}

/**
 * A function of the public headers: its header and its comment.
 * @param {string} name
 */
export function functionOf(name) {
  const pattern = new RegExp(`((?:^///.*\\n)+)^GIRTH_EXPORT [^;{]*?\\b${name}\\(`, 'm');
  for (const [file, text] of texts) {
    const [, comment] = pattern.exec(text) ?? [];
    if (comment !== undefined) return { file, comment: plain(comment) };
  }
  throw new Error(`no header has a function ${name} with a comment`);
}

/**
 * The arguments of each use of a macro, as they are written; texts without their quotation marks.
 * @param {string} table
 * @param {string} macro
 */
export function entriesOf(table, macro) {
  const text = read(table).replace(/^(\/\/|#).*(\\\n.*)*$/gm, '');
  return [...text.matchAll(new RegExp(`^${macro}\\(`, 'gm'))].map((start) => {
    const words = [''];
    const rest = text.slice(start.index + start[0].length);
    let depth = 0;
    for (const [piece] of rest.matchAll(/"(?:[^"\\]|\\.)*"|[^]/g)) {
      if (/[({]/.test(piece[0] ?? '')) ++depth;
      if (/[)}]/.test(piece[0] ?? '') && --depth < 0) break;
      if (piece === ',' && depth === 0) words.push('');
      else
        words[words.length - 1] += piece.startsWith('"') && depth === 0 ? JSON.parse(piece) : piece;
    }
    return words.map((word) => word.trim());
  });
}

/** The table of analyses: names, structs and functions. */
export const analyses = () =>
  entriesOf(`${headers}/analyses.def`, 'GIRTH_ANALYSIS').map(
    ([name = '', options = '', found = '', call = '']) => ({ name, options, found, call }),
  );
