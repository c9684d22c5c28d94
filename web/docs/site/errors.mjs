// The page of errors, made of the one table of codes.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { repository } from '../../scripts/run.mjs';

const table = 'cpp/include/girth/error_codes.def';

const meanings = ['', 'wrong usage', 'bad input', 'a limit was met, or the work was cancelled'];

/**
 * @typedef {object} ErrorCode
 * @property {string} name in C++: girth::ErrorCode::NAME
 * @property {string} code everywhere else
 * @property {number} exit the command's exit code
 * @property {string} remedy
 * @property {string} group the table's heading above it
 */

/** The codes in the order of the table. */
export function errorCodes() {
  /** @type {ErrorCode[]} */
  const codes = [];
  let group = '';
  for (const line of readFileSync(join(repository, table), 'utf8').split('\n')) {
    const entry = /^GIRTH_ERROR_CODE\((\w+), "(\w+)", (\d), "(.*)"\)$/.exec(line);
    if (entry) {
      const [, name = '', code = '', exit, remedy = ''] = entry;
      codes.push({ name, code, exit: Number(exit), remedy, group });
    } else {
      group = /^\/\/ (\w+)$/.exec(line)?.[1] ?? group;
    }
  }
  return codes;
}

/** The page as Markdown. */
export function errorsPage() {
  const codes = errorCodes();
  const groups = [...new Set(codes.map(({ group }) => group))];
  const tables = groups.map((group) => {
    const rows = codes
      .filter((code) => code.group === group)
      .map(
        ({ name, code, exit, remedy }) =>
          `| <span id="${code}">\`${code}\`</span> | \`${name}\` | ${exit} | ${remedy} |`,
      );
    return `## ${group}\n\n| code | in C++ | exit code | what helps |\n| --- | --- | --: | --- |\n${rows.join('\n')}\n`;
  });
  const exits = [1, 2, 3].map((exit) => `${exit}: ${meanings[exit]}`).join('; ');
  return `# Errors

A failure has a code, the element it is about, a message, and a remedy. The codes are the same in C++ (\`girth::ErrorCode\`), the
command, JavaScript and Python. The command prints one line,
\`girth: FILE: CODE: what, where; hint\`, and ends with the code's exit code: ${exits}. With \`--json\` the same stands in an object,
\`{"file": ..., "error": {"code", "element", "message", "hint"}}\`. A message may have a hint of its own, which fits the case better
than the one here.

${tables.join('\n')}`;
}
