// The examples for strangers in web/examples, with the npm tarball as users get it.

import { spawnSync } from 'node:child_process';
import { copyFileSync, cpSync, mkdirSync, mkdtempSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { packed } from '../web/package/packed.js';
import { torus } from './meshes.js';
import { chromiumForTests, repository, serve, strictPolicy, trustedTypes } from './support.js';
import { fieldComplete } from './viewer-page.js';

const folder = mkdtempSync(join(tmpdir(), 'girth-examples-'));
const [element, kernel] = [join(folder, 'element'), join(folder, 'kernel')];
const folders = { '/girth/': packed().folder };
const [project, esbuild] = [join(folder, 'vite'), join(folder, 'esbuild')];
const webpack = join(folder, 'webpack');
const openPage = chromiumForTests();

const policy = `${strictPolicy}; ${trustedTypes}`;

/** A model for which there are few values: 1,600 or so. */
const model = join(repository, 'web/app/public/examples/dumbbell.glb');

beforeAll(() => {
  for (const name of ['element', 'kernel', 'vite', 'esbuild', 'webpack']) {
    cpSync(join(repository, 'web/examples', name), join(folder, name), { recursive: true });
  }
  for (const page of [element, kernel, esbuild, webpack])
    copyFileSync(model, join(page, 'chair.glb'));
});

afterAll(() => rmSync(folder, { recursive: true }));

test('a page with the element', async () => {
  const server = await serve(element, { folders, policy: trustedTypes });
  const { page, context, complaints } = await openPage(`${server.url}/index.html`);
  const viewer = page.locator('girth-viewer');
  await fieldComplete(viewer);
  await expect.poll(() => page.locator('#median').textContent()).toMatch(/^0\.\d{3} m$/);
  expect(complaints).toEqual([]);
  await context.close();
  await server.close();
});

test.each([false, true])('a page with the kernel, isolated: %s', async (isolated) => {
  const server = await serve(kernel, { isolated, folders, policy: trustedTypes });
  const { page, context, complaints } = await openPage(`${server.url}/index.html`);
  const narrowest = page.locator('#narrowest');
  await expect.poll(() => narrowest.textContent()).toMatch(/^vertex \d+: 0\.1[23]\d m around$/);
  expect(server.requests.some((path) => path.includes('girth-threads'))).toBe(isolated);
  // Modules for other files and other questions are not fetched.
  expect(
    server.requests.filter((path) =>
      /analysis|girth-fields|draco|meshopt|studies|three/.test(path),
    ),
  ).toEqual([]);
  expect(complaints).toEqual([]);
  await context.close();
  await server.close();
});

/**
 * Gives a project the package and others as `npm install` would, with what the repository has installed already.
 * Returns what runs a tool of theirs.
 */
function installed(project: string, ...names: string[]) {
  const modules = join(project, 'node_modules');
  mkdirSync(modules);
  cpSync(packed().folder, join(modules, 'girth'), { recursive: true });
  for (const name of [...names, '.bin']) {
    symlinkSync(join(repository, 'node_modules', name), join(modules, name));
  }
  return (name: string, ...args: string[]) =>
    spawnSync(join(modules, '.bin', name), args, { cwd: project, encoding: 'utf8' });
}

test('a Vite project with the kernel', async () => {
  const tool = installed(project, 'vite', 'fflate');
  expect(tool('tsc', '--project', 'tsconfig.json')).toMatchObject({ status: 0, stdout: '' });
  const { status: exit, stdout, stderr } = tool('vite', 'build', '--logLevel', 'warn');
  // Nothing in it is for Node.js only. Vite may say that it was slow.
  expect(stdout + stderr).not.toMatch(/externalized|"fs"|"path"/);
  expect(exit).toBe(0);

  const server = await serve(join(project, 'dist'), { isolated: true, policy });
  const { page, context, complaints } = await openPage(`${server.url}/index.html`);
  const status = page.locator('#status');
  await page.setInputFiles('#file', model);
  await expect.poll(() => status.textContent()).toBe('Done');
  const rows = await page.locator('#table tr').allTextContents();
  expect(rows).toEqual([
    expect.stringMatching(/^Vertices1[56]\d\d$/),
    // The neck's middle is a tube of radius 21 mm.
    expect.stringMatching(/^Least girth0\.1[23]\d* m$/),
    expect.stringMatching(/^Median girth0\.\d{3,4} m$/),
    expect.stringMatching(/^Greatest girth1\.2\d* m$/),
  ]);
  const counts = (await page.locator('#histogram').textContent())!.match(/\d+$/gm)!.map(Number);
  expect(counts).toHaveLength(10);
  expect(`Vertices${String(counts.reduce((a, b) => a + b))}`).toBe(rows[0]);

  // A file that cannot be used, and one that is cancelled.
  await page.setInputFiles('#file', join(repository, 'package.json'));
  await expect.poll(() => status.textContent()).toContain(';');
  // Minutes of work: it is in mid-run whenever the click comes.
  const endless = { name: 'endless.obj', mimeType: '', buffer: Buffer.from(torus(160, 110)) };
  await page.setInputFiles('#file', endless);
  await page.locator('#cancel').click();
  await expect.poll(() => status.textContent()).toBe('Cancelled');
  expect(complaints).toEqual([]);
  await context.close();
  await server.close();
});

test('an esbuild project with element and kernel, whose workers come from a copied folder', async () => {
  const tool = installed(
    ...([esbuild, 'esbuild', 'fflate', 'three', 'three-mesh-bvh', '@types'] as const),
  );
  expect(tool('tsc', '--project', 'tsconfig.json')).toMatchObject({ status: 0, stdout: '' });
  expect(spawnSync('npm', ['run', 'build'], { cwd: esbuild })).toMatchObject({ status: 0 });
  for (const isolated of [true, false]) {
    const server = await serve(esbuild, { isolated, policy });
    const { page, context, complaints } = await openPage(`${server.url}/index.html`);
    await expect.poll(() => page.locator('#least').textContent()).toMatch(/^0\.1[23]\d m$/);
    await fieldComplete(page.locator('girth-viewer'));
    const workers = server.requests.filter((path) => path.startsWith('/girth/workers/'));
    expect(workers.some((path) => path.includes('threads'))).toBe(isolated);
    // Nothing is looked for beside the bundle.
    expect(server.requests.filter((path) => /^\/(?!girth\/).*worker/.test(path))).toEqual([]);
    expect(complaints).toEqual([]);
    await context.close();
    await server.close();
  }
});

/** The work of `webpack` of the command line, without the package of that; to make it small would take most of the time. */
const runWebpack = `
  import webpack from 'webpack';
  import config from './webpack.config.js';
  webpack({ ...config, context: process.cwd(), optimization: { minimize: false } }, (error, stats) => {
    if (error) throw error;
    process.stdout.write(stats.toString('errors-warnings'));
    process.exitCode = stats.hasErrors() ? 1 : 0;
  });`;

test('a webpack project with element and kernel, whose workers and modules webpack carries along', async () => {
  installed(webpack, 'webpack', 'fflate', 'three');
  const built = spawnSync(process.execPath, ['--input-type=module', '--eval', runWebpack], {
    cwd: webpack,
    encoding: 'utf8',
  });
  expect(built).toMatchObject({ status: 0, stdout: 'webpack compiled successfully', stderr: '' });
  for (const isolated of [true, false]) {
    const server = await serve(webpack, { isolated, policy: `${policy} webpack` });
    const { page, context, complaints } = await openPage(`${server.url}/index.html`);
    await expect.poll(() => page.locator('#least').textContent()).toMatch(/^0\.1[23]\d m$/);
    await fieldComplete(page.locator('girth-viewer'));
    // All but page and model lies in the folder that webpack has made.
    const others = server.requests.filter((path) => !/^\/dist\/[\w.]+\.(js|wasm)$/.test(path));
    expect(others).toEqual(['/index.html', '/chair.glb', '/chair.glb']);
    expect(complaints).toEqual([]);
    await context.close();
    await server.close();
  }
});
