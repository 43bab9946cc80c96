import { defineConfig } from 'vite';
import headers from './headers.json';
import { afterBuild } from './scripts/after-build.mjs';
import { hashedScript } from './scripts/hashed-script.mjs';
import { namedMethods } from './scripts/named-methods.mjs';
import { oneThreadScript } from './scripts/one-thread-script.mjs';
import { optionTexts } from './scripts/option-texts.mjs';
import { ownThree } from './scripts/own-three.mjs';
import { usedThree } from './scripts/used-three.mjs';
import { withoutEval } from './scripts/without-eval.mjs';
import { withoutIndents } from './scripts/without-indents.mjs';

/** Vite's own client, for development, has inline styles. */
const { 'Content-Security-Policy': _, ...isolation } = headers;

export default defineConfig({
  base: './',
  build: {
    target: 'es2022',
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 900,
    reportCompressedSize: false,
    // Compressed, scripts are 5 % smaller than by Vite's default.
    minify: 'terser',
    // Nothing is read only for what a getter does, and nothing counts the parameters of a function.
    terserOptions: {
      ecma: 2020,
      module: true,
      compress: { passes: 3, pure_getters: true, keep_fargs: false },
    },
  },
  plugins: [
    hashedScript('theme.js'),
    optionTexts(),
    usedThree(),
    namedMethods(),
    withoutIndents(),
    afterBuild(headers),
  ],
  // With them the browser gives the page threads.
  server: { headers: isolation },
  preview: { headers },
  worker: { format: 'es', plugins: () => [oneThreadScript(), ownThree(), withoutEval()] },
  // The package finds its worker and its .wasm relative to its own file.
  optimizeDeps: { exclude: ['abflat'] },
});
