import { defineConfig } from 'vite';

export default defineConfig({
  // The built page works in any folder of any static host.
  base: './',
  // Girth computes in workers that are modules.
  worker: { format: 'es' },
  // Vite must not bundle the kernel ahead while developing: its workers and modules lie beside it.
  optimizeDeps: { exclude: ['girth'] },
  server: {
    // With these two headers, computing shares memory between threads. Without them it works as well.
    headers: {
      'Cross-Origin-Opener-Policy': 'same-origin',
      'Cross-Origin-Embedder-Policy': 'require-corp',
    },
  },
});
