// The page: built into build/page, served by `npm start`.

import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { writeFileList } from './scripts/offline.mjs';

// With these two, and only with these, a page may use threads that share memory.
const isolation = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
};

/** Below /docs, without the slash, the documentation's own links would lead elsewhere. */
const docsEndWithSlash: Plugin = {
  name: 'docs-end-with-slash',
  configurePreviewServer: ({ middlewares }) => {
    middlewares.use((request, response, next) => {
      if (request.url !== '/docs') return next();
      response.writeHead(301, { Location: '/docs/' }).end();
    });
  },
};

const folder = fileURLToPath(new URL('../build/page', import.meta.url));

/** What the service worker keeps is known when everything else is written. */
const knownOffline: Plugin = {
  name: 'known-offline',
  apply: 'build',
  closeBundle: () => writeFileList(folder),
};

export default defineConfig(({ mode }) => ({
  root: fileURLToPath(new URL('app', import.meta.url)),
  base: './',
  plugins: [docsEndWithSlash, knownOffline],
  build: {
    outDir: folder,
    emptyOutDir: true,
    target: 'es2022',
    rolldownOptions: {
      input: ['index.html', 'embed.html', 'service-worker.ts'].map((name) =>
        fileURLToPath(new URL(`app/${name}`, import.meta.url)),
      ),
      // It has one address for ever, at the top of what it serves.
      output: {
        entryFileNames: ({ name }) =>
          name === 'service-worker' ? '[name].js' : 'assets/[name]-[hash].js',
      },
    },
    // Modules and workers stay files of their own: a strict content security policy allows no data: address.
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2000,
  },
  worker: { format: 'es' },
  server: { headers: isolation },
  preview: { headers: mode === 'no-isolation' ? {} : isolation },
}));
