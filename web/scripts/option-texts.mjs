// Vite plugin: of the package's words on options, leaves out those that the page has its own words for.

const MODULE = /\/generated\.js$/;
const OPTION = /^ {2}(\w+): \{ type: .* \},?$/gm;
const TEXT = /, text: "(?:[^"\\]|\\.)*"/;

/**
 * @param {string[]} shown the options whose words are shown
 * @returns {import('vite').Plugin}
 */
export const optionTexts = (shown) => ({
  name: 'abflat-option-texts',
  apply: 'build',
  transform(code, id) {
    if (!MODULE.test(id)) return undefined;
    const rest = code.replaceAll(OPTION, (option, name) =>
      shown.includes(name) ? option : option.replace(TEXT, ''),
    );
    if (rest === code)
      throw new Error('Options are written in another way now: change option-texts.mjs.');
    return { code: rest, map: null };
  },
});
