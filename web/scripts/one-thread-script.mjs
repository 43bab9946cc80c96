// Vite plugin for workers: threads start with the script that their worker has loaded already. Vite alone would put it into
// the worker, and copy it for the threads.

const SCRIPT = './abflat-threads.js';
const ADDRESS = /new URL\((['"])\.\/abflat-threads\.js\1, import\.meta\.url\)\.href/;

/** @returns {import('vite').Plugin} */
export const oneThreadScript = () => ({
  name: 'abflat-one-thread-script',
  apply: 'build',
  enforce: 'pre',
  async transform(code, importer) {
    if (!ADDRESS.test(code)) return undefined;
    const script = await this.resolve(SCRIPT, importer);
    const file = this.emitFile({ type: 'chunk', id: script.id, preserveSignature: 'strict' });
    return { code: code.replace(ADDRESS, `import.meta.ROLLUP_FILE_URL_${file}`), map: null };
  },
});
