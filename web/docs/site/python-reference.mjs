// The reference of the Python package, made of its docstrings.

import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { repository } from '../../scripts/run.mjs';

/**
 * @typedef {object} PythonName
 * @property {string} name such as `pygirth.load` or `Mesh.igf`
 * @property {string} doc
 * @property {string} [signature] of functions; empty for properties
 */

/** The public names with their docstrings. @returns {PythonName[]} */
export function pythonNames() {
  const program = join(repository, 'web/docs/site/python_names.py');
  const folder = join(repository, 'cpp/python/pygirth');
  const printed = execFileSync('python3', ['-B', program, folder], { encoding: 'utf8' });
  return JSON.parse(printed);
}

/** A docstring in NumPy's form as Markdown. @param {string} doc */
export function markdownOf(doc) {
  const [summary = '', ...sections] = doc.split(/^(?=[A-Z][a-z]+\n-{3,}$)/m);
  const code = (/** @type {string} */ text) =>
    text
      .replace(/``([^`]+)``/g, '`$1`')
      .replace(/((?:^>>> .*\n?(?:^(?!>>>|\n).*\n?)*)+)/gm, '\n```python\n$1\n```\n');
  const written = sections.map((section) => {
    const [title = '', , ...lines] = section.trimEnd().split('\n');
    if (title === 'Notes' || title === 'Examples') return `**${title}**\n\n${lines.join('\n')}`;
    const entries = lines.map((line) => {
      if (/^\s*$/.test(line)) return '';
      if (/^\s/.test(line)) return `  ${line.trim()}`;
      const [, name = '', type = ''] = /^([^:]+?)(?: : (.*))?$/.exec(line) ?? [];
      return `- \`${name.replace(/`/g, '')}\`${type ? `: _${type.replace(/[_*]/g, '\\$&')}_` : ''}.`;
    });
    return `**${title}**\n\n${entries.join('\n')}`;
  });
  return code([summary.trim(), ...written].join('\n\n'));
}

/** The page as Markdown. */
export function pythonPage() {
  const parts = pythonNames().map(({ name, doc, signature }) => {
    const rank = name.startsWith('pygirth') ? '##' : '###';
    const short = name.split('.').at(-1);
    const line = signature ? `\`\`\`python\n${short}${signature}\n\`\`\`\n\n` : '';
    return `${rank} \`${name}\`\n\n${line}${markdownOf(doc)}\n`;
  });
  return `# Python, name by name

What \`help()\` says of every public name. [Girth in Python](web/docs/python.md) has an overview.

${parts.join('\n')}`;
}
