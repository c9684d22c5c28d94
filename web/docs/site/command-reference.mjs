// The reference of the command, made of its help.

import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { repository } from '../../scripts/run.mjs';

/**
 * The help of a command, as it is printed.
 * @param {string[]} words behind `girth`
 */
function helpOf(words) {
  const program = join(repository, 'dist/command/girth.cjs');
  const done = spawnSync(process.execPath, [program, ...words, '--help'], { encoding: 'utf8' });
  if (done.status !== 0) throw new Error(`girth ${words.join(' ')} --help: ${done.stderr}`);
  return done.stdout;
}

/**
 * The commands that a help lists.
 * @param {string} help
 */
export const listedCommands = (help) => {
  const [, list = ''] = /^Commands:\n((?: .*\n)+)/m.exec(help) ?? [];
  return [...list.matchAll(/^ {2}(\w+) /gm)].map(([, name = '']) => name);
};

/**
 * A section for a command, and those of the commands below it.
 * @param {string[]} words
 * @returns {string[]}
 */
function sectionsOf(words) {
  const help = helpOf(words);
  const section = `## \`girth ${words.join(' ')}\`\n\n\`\`\`text\n${help}\`\`\`\n`;
  return [section, ...listedCommands(help).flatMap((name) => sectionsOf([...words, name]))];
}

/** The page as Markdown. */
export function commandPage() {
  const help = helpOf([]);
  const commands = listedCommands(help).filter((name) => name !== 'help');
  return `# The command, option by option

The help of every command, as \`girth COMMAND --help\` prints it. [The command](web/docs/command.md) has examples.

\`\`\`text
${help}\`\`\`

${commands.flatMap((name) => sectionsOf([name])).join('\n')}`;
}
