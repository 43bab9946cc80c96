// Vite plugin: leaves out what the page does not use of three.js. The renderer refers to all of it, so bundlers keep it.

/** What the page's shaders and LineMaterial include, and what the renderer adds to them. Including any other one is an error in three.js. */
const USED = new Set([
  'clipping_planes_fragment',
  'clipping_planes_pars_fragment',
  'clipping_planes_pars_vertex',
  'clipping_planes_vertex',
  'color_fragment',
  'color_pars_fragment',
  'color_pars_vertex',
  'color_vertex',
  'colorspace_fragment',
  'colorspace_pars_fragment',
  'common',
  'fog_fragment',
  'fog_pars_fragment',
  'fog_pars_vertex',
  'fog_vertex',
  'logdepthbuf_fragment',
  'logdepthbuf_pars_fragment',
  'logdepthbuf_pars_vertex',
  'logdepthbuf_vertex',
  'premultiplied_alpha_fragment',
  'tonemapping_fragment',
  'tonemapping_pars_fragment',
]);

/** No lights around, no headsets: what the renderer still asks of these classes. */
const UNUSED = {
  PMREMGenerator: 'class PMREMGenerator {}',
  WebXRManager: `class WebXRManager extends EventDispatcher {
  enabled = false;
  isPresenting = false;
  getEnvironmentBlendMode() {}
  setAnimationLoop() {}
  dispose() {}
}`,
};

const RENDERER = /\/three\/build\/three\.module\.js$/;
const CHUNKS = /^const ShaderChunk = \{$(.*?)^\};$/ms;
const ENTRY = /^\t(\w+): ([\w$]+),?$/gm;
const TEXT = /^(var|const) ([\w$]+) = "(?:[^"\\]|\\.)*";$/gm;

const changed = () => new Error('three.js is written in another way now: change used-three.mjs.');

function withoutShaders(source) {
  const [, entries] = CHUNKS.exec(source) ?? [];
  const chunks = [...(entries ?? '').matchAll(ENTRY)];
  const unused = new Set(chunks.filter(([, name]) => !USED.has(name)).map(([, , text]) => text));
  if (chunks.length - unused.size !== USED.size) throw changed();
  return source.replace(TEXT, (text, how, name) =>
    unused.has(name) ? `${how} ${name} = undefined;` : text,
  );
}

function withoutClasses(source) {
  let text = source;
  for (const [name, rest] of Object.entries(UNUSED)) {
    const [found] = new RegExp(`^class ${name} [^]*?^}$`, 'm').exec(text) ?? [];
    if (!found) throw changed();
    text = text.replace(found, () => rest);
  }
  return text;
}

/** @returns {import('vite').Plugin} */
export const usedThree = () => ({
  name: 'abflat-used-three',
  apply: 'build',
  transform: (source, id) =>
    RENDERER.test(id) ? { code: withoutClasses(withoutShaders(source)), map: null } : undefined,
});
