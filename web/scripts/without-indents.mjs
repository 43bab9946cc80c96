// Vite plugin: leaves out the indents of the page's document, which are a twenty-fifth of it once compressed.

/** @returns {import('vite').Plugin} */
export const withoutIndents = () => ({
  name: 'abflat-without-indents',
  apply: 'build',
  transformIndexHtml: { order: 'post', handler: (html) => html.replace(/\n\s+/g, '\n') },
});
