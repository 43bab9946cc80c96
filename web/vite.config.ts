import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  build: { target: 'es2022', chunkSizeWarningLimit: 900 },
  worker: { format: 'es' },
  // The package finds its worker and its .wasm relative to its own file.
  optimizeDeps: { exclude: ['abflat'] },
});
