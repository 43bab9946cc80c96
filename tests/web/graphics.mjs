// The graphics card, as pages in tests have it.

/** Counts the textures of all views of a page that has not been loaded yet. */
export const prepareCounting = (page) =>
  page.addInitScript(() => {
    globalThis.textures = new Set();
    const { createTexture, deleteTexture } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.createTexture = function () {
      const made = createTexture.call(this);
      globalThis.textures.add(made);
      return made;
    };
    WebGL2RenderingContext.prototype.deleteTexture = function (texture) {
      globalThis.textures.delete(texture);
      return deleteTexture.call(this, texture);
    };
  });

export const countTextures = (page) => page.evaluate(() => globalThis.textures.size);

/** Canvases lose their contexts, one after the other, and get them back. */
export const loseContexts = (page, ids) =>
  page.evaluate(async (ids) => {
    for (const id of ids) {
      const canvas = document.querySelector(id);
      const extension = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
      const event = (name) =>
        new Promise((done) => canvas.addEventListener(name, done, { once: true }));
      const lost = event('webglcontextlost');
      extension.loseContext();
      await lost;
      const restored = event('webglcontextrestored');
      await new Promise((done) => setTimeout(done));
      extension.restoreContext();
      await restored;
    }
  }, ids);

/** Notes which programs the views of a page link, and which they draw with. */
export const prepareLinking = (page) =>
  page.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    globalThis.programs = { linked: new Set(), drawn: new Set() };
    const watch = (name, note) => {
      const original = prototype[name];
      prototype[name] = function (...parameters) {
        note(this, parameters);
        return original.apply(this, parameters);
      };
    };
    watch('linkProgram', (_, [program]) => globalThis.programs.linked.add(program));
    for (const name of ['Arrays', 'Elements', 'ArraysInstanced', 'ElementsInstanced'])
      watch(`draw${name}`, (gl) =>
        globalThis.programs.drawn.add(gl.getParameter(gl.CURRENT_PROGRAM)),
      );
  });

export const countPrograms = (page) =>
  page.evaluate(() => {
    const { linked, drawn } = globalThis.programs;
    return { linked: linked.size, drawn: drawn.size };
  });
