// The form of the workflow files for a public host: YAML without repeated keys, the keys that GitHub knows, actions pinned
// by commit, needs that are jobs, and commands, parts, options and targets that there are. They do not run here.

import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { parseDocument } from 'yaml';
import { repository } from '../../../web/scripts/run.mjs';
import { longParts, parts } from '../../../web/scripts/test-parts.mjs';

interface Step {
  name?: string;
  uses?: string;
  run?: string;
}

interface Job {
  'runs-on': string;
  'timeout-minutes': number;
  needs?: string | string[];
  strategy?: { matrix?: Record<string, string[]> };
  steps: Step[];
}

interface Workflow {
  on: Record<string, unknown>;
  permissions: Record<string, string>;
  jobs: Record<string, Job>;
}

const folder = join(repository, '.github/workflows');
const files = readdirSync(folder);

/** Keys of a workflow, a job and a step, as GitHub's reference of the syntax of workflows has them. */
const known = {
  workflow: ['name', 'run-name', 'on', 'permissions', 'env', 'defaults', 'concurrency', 'jobs'],
  job: [
    ...['name', 'permissions', 'needs', 'if', 'runs-on', 'environment', 'concurrency', 'outputs'],
    ...['env', 'defaults', 'steps', 'timeout-minutes', 'strategy', 'continue-on-error'],
    ...['container', 'services'],
  ],
  step: [
    ...['id', 'if', 'name', 'uses', 'run', 'working-directory', 'shell', 'with', 'env'],
    ...['continue-on-error', 'timeout-minutes'],
  ],
};

function read(file: string): Workflow {
  const document = parseDocument(readFileSync(join(folder, file), 'utf8'));
  expect([...document.errors, ...document.warnings], file).toEqual([]);
  return document.toJS() as Workflow;
}

const expectKeys = (object: object, kind: keyof typeof known, where: string) =>
  expect(known[kind], where).toEqual(expect.arrayContaining(Object.keys(object)));

/** The values that expressions of a job's matrix can have in a text. */
function withMatrix(text: string, job: Job): string[] {
  const [expression, name] = /\$\{\{ *matrix\.([\w-]+) *\}\}/.exec(text) ?? [];
  if (!expression) return [text];
  const values = job.strategy?.matrix?.[name!] ?? [];
  expect(values.length, expression).toBeGreaterThan(0);
  return values.flatMap((value) => withMatrix(text.replace(expression, value), job));
}

/** All CMake files of the project, in which options and targets stand. */
const cmake = ['CMakeLists.txt', 'cpp/cli/CMakeLists.txt', 'tests/cpp/CMakeLists.txt']
  .map((file) => readFileSync(join(repository, file), 'utf8'))
  .join('\n');
/** The names of options that cpp/cmake/GirthPackages.cmake makes of headers' names. */
const folderOptions = [
  ...readFileSync(join(repository, 'cpp/cmake/GirthPackages.cmake'), 'utf8').matchAll(
    /"?([\w/]+\.hp?p?|Eigen\/Core) lib[\w-]+-dev"?|"?([\w/.]+\.hpp) nlohmann/g,
  ),
].map(([, one, other]) => `GIRTH_${(one ?? other)!.replaceAll(/\W/g, '_')}_FOLDER`);

/** Expects that whatever a command of a step names is there. */
function expectCommand(command: string, where: string) {
  const { scripts } = JSON.parse(readFileSync(join(repository, 'package.json'), 'utf8')) as {
    scripts: Record<string, string>;
  };
  for (const [, name] of command.matchAll(/\bnpm (?:run )?([\w:]+)/g)) {
    expect(Object.keys(scripts), where).toContain(name);
  }
  for (const [, program, words = ''] of command.matchAll(/\bnode (\S+)((?: [\w-]+)*)/g)) {
    expect(existsSync(join(repository, program!)), `${where}: ${program}`).toBe(true);
    if (!program!.endsWith('/test.mjs')) continue;
    for (const part of words.trim().split(' ')) {
      expect(Object.keys({ ...parts, ...longParts }), where).toContain(part);
    }
  }
  for (const [, option] of command.matchAll(/-D(GIRTH_\w+)=/g)) {
    expect(folderOptions.includes(option!) || cmake.includes(option!), `${where}: ${option}`).toBe(
      true,
    );
  }
  for (const [, targets] of command.matchAll(/--target((?: \w+)+)/g)) {
    for (const target of targets!.trim().split(' ')) {
      const made = [`add_executable(${target} `, `girth_tests(${target.replace(/_tests$/, '')} `];
      expect(
        made.some((words) => cmake.includes(words)),
        `${where}: ${target}`,
      ).toBe(true);
    }
  }
}

test('there are workflows', () => {
  expect(files).toContain('test.yml');
  expect(files.every((file) => file.endsWith('.yml'))).toBe(true);
});

test.each(files)('%s has the form of a workflow', (file) => {
  const workflow = read(file);
  expectKeys(workflow, 'workflow', file);
  expect(Object.keys(workflow.on).length, file).toBeGreaterThan(0);
  expect(workflow.permissions, 'no more rights than to read').toEqual({ contents: 'read' });
  for (const [name, job] of Object.entries(workflow.jobs)) {
    const where = `${file}: ${name}`;
    expectKeys(job, 'job', where);
    expect(job['runs-on'], `${where}: not latest, which changes`).toMatch(/^\w+-[\d.]+$/);
    expect(job['timeout-minutes'], where).toBeGreaterThan(0);
    expect(Object.keys(workflow.jobs), where).toEqual(
      expect.arrayContaining([job.needs ?? []].flat()),
    );
    expect(job.steps.length, where).toBeGreaterThan(0);
    for (const step of job.steps) {
      expectKeys(step, 'step', where);
      expect(step.name, where).toBeTruthy();
      expect('uses' in step !== 'run' in step, `${where}: uses or run`).toBe(true);
      if (step.uses)
        expect(step.uses, `${where}: pinned`).toMatch(/^[\w-]+\/[\w/-]+@[0-9a-f]{40}$/);
      for (const command of withMatrix(step.run ?? '', job)) expectCommand(command, where);
    }
  }
});
