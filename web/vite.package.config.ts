// The npm package, in three builds. Mode `element`: dist/element.js, which imports the kernel's modules
// beside it and the three.js of whoever uses it. Mode `bundle`: dist/girth-viewer.js with all inside,
// for a page with one script line. Mode `plots`: dist/plots.js and its style, with uPlot inside. The
// kernel's own modules are not bundled: see the package build.

import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

export default defineConfig(({ mode }) => {
  const isBundle = mode === 'bundle';
  const inputs: Record<string, Record<string, string>> = {
    element: { element: path('src/element/index.ts') },
    bundle: { 'girth-viewer': path('src/element/index.ts') },
    plots: { plots: path('src/element/plots.ts'), 'plots-style': path('src/element/plots.css') },
  };
  return {
    root: path('src'),
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
        external: isBundle ? [] : [/^three(\/|$)/, path('src/kernel/index.ts')],
        output: {
          entryFileNames: '[name].js',
          ...(mode === 'plots' ? { assetFileNames: 'plots.css' } : {}),
          ...(isBundle ? {} : { paths: { [path('src/kernel/index.ts')]: './kernel/index.js' } }),
        },
      },
    },
    worker: { format: 'es' },
  };
});
