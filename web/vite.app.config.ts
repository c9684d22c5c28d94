// The page: built into build/page, served by `npm start`.

import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

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

export default defineConfig(({ mode }) => ({
  root: fileURLToPath(new URL('app', import.meta.url)),
  base: './',
  plugins: [docsEndWithSlash],
  build: {
    outDir: fileURLToPath(new URL('../build/page', import.meta.url)),
    emptyOutDir: true,
    target: 'es2022',
    rolldownOptions: {
      input: ['index.html', 'embed.html'].map((name) =>
        fileURLToPath(new URL(`app/${name}`, import.meta.url)),
      ),
    },
    // Modules and workers stay files of their own: a strict content security policy allows no data: address.
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2000,
  },
  worker: { format: 'es' },
  server: { headers: isolation },
  preview: { headers: mode === 'no-isolation' ? {} : isolation },
}));
