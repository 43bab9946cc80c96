import { defineConfig } from 'vite';
import headers from './headers.json';

export default defineConfig({
  base: './',
  build: { target: 'es2022', chunkSizeWarningLimit: 900 },
  // With them the browser gives the page threads.
  server: { headers },
  preview: { headers },
  worker: { format: 'es' },
  // The package finds its worker and its .wasm relative to its own file.
  optimizeDeps: { exclude: ['abflat'] },
});
