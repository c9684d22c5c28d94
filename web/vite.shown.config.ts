// What a saved page runs, in one file: build/shown/girth-shown.js, which is put into the Python package.

import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

/** What is left out, and what stands for it. */
const leftOut: Record<string, string> = {
  // The page has a kernel of its own, which has the values already.
  [path('src/kernel/index.ts')]:
    'export const createKernel = () => Promise.reject(new Error("this page computes nothing"));',
  // There is no file of a worker; the page does its work itself.
  'three-mesh-bvh/worker':
    'export class GenerateMeshBVHWorker { constructor() { throw new Error("no worker"); } }',
};

const onePageOnly: Plugin = {
  name: 'girth-one-page-only',
  enforce: 'pre',
  resolveId: (id) => (id in leftOut ? id : undefined),
  load: (id) => leftOut[id],
};

export default defineConfig({
  root: path('src'),
  base: './',
  publicDir: false,
  plugins: [onePageOnly],
  build: {
    outDir: path('../build/shown'),
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    rolldownOptions: {
      input: { 'girth-shown': path('src/element/saved-page.ts') },
      output: { entryFileNames: '[name].js', codeSplitting: false },
    },
  },
  worker: { format: 'es' },
});
