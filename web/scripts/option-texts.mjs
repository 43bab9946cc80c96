// Vite plugin: leaves out the package's words on options. The page has its own, and its own copy of
// some of them, which it loads later.

const MODULE = /\/generated\.js$/;
const OPTION = /^ {2}(\w+): \{ type: .* \},?$/gm;
const TEXT = /, text: "(?:[^"\\]|\\.)*"/;

/** @returns {import('vite').Plugin} */
export const optionTexts = () => ({
  name: 'abflat-option-texts',
  apply: 'build',
  transform(code, id) {
    if (!MODULE.test(id)) return undefined;
    const rest = code.replaceAll(OPTION, (option) => option.replace(TEXT, ''));
    if (rest === code)
      throw new Error('Options are written in another way now: change option-texts.mjs.');
    return { code: rest, map: null };
  },
});
