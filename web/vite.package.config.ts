// The npm package, in four builds. Mode `element`: dist/element.js, which imports the kernel's modules
// beside it and the three.js of whoever uses it. Mode `kernel`: dist/girth-kernel.js, and mode `viewer`:
// dist/girth-viewer.js, which imports it; with all that they need, for pages without a bundler. Mode `plots`:
// dist/plots.js and its style, with uPlot inside. The kernel's own modules are not bundled: see the package
// build.

import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { listBundledPackages } from './scripts/bundled-packages.mjs';
import { leanThree } from './scripts/lean-three.mjs';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

export default defineConfig(({ mode }) => {
  const kernel = path('src/kernel/index.ts');
  // Where the element finds the kernel, by mode.
  const kernels: Record<string, string> = {
    element: './kernel/index.js',
    viewer: './girth-kernel.js',
  };
  const three = mode === 'element' ? [/^three(\/|$)/] : [];
  const inputs: Record<string, Record<string, string>> = {
    element: { element: path('src/element/index.ts') },
    kernel: { 'girth-kernel': kernel },
    viewer: { 'girth-viewer': path('src/element/index.ts') },
    plots: { plots: path('src/element/plots.ts'), 'plots-style': path('src/element/plots.css') },
  };
  return {
    root: path('src'),
    plugins: [listBundledPackages(mode), ...(mode === 'viewer' ? [leanThree()] : [])],
    base: './',
    publicDir: false,
    build: {
      outDir: path('../dist'),
      emptyOutDir: false,
      target: 'es2022',
      assetsInlineLimit: 0,
      modulePreload: false,
      chunkSizeWarningLimit: 2000,
      rolldownOptions: {
        input: inputs[mode]!,
        preserveEntrySignatures: 'strict',
        external: mode in kernels ? [...three, kernel] : three,
        output: {
          entryFileNames: '[name].js',
          ...(mode === 'plots' ? { assetFileNames: 'plots.css' } : {}),
          ...(mode in kernels ? { paths: { [kernel]: kernels[mode]! } } : {}),
        },
      },
    },
    worker: { format: 'es', plugins: () => [listBundledPackages(`${mode}-worker`)] },
  };
});
