// Vite plugin: leaves out the shaders of three.js that the page does not use. The renderer refers to those of all materials, so nothing else does.

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

const RENDERER = /\/three\/build\/three\.module\.js$/;
const CHUNKS = /^const ShaderChunk = \{$(.*?)^\};$/ms;
const ENTRY = /^\t(\w+): ([\w$]+),?$/gm;
const TEXT = /^(var|const) ([\w$]+) = "(?:[^"\\]|\\.)*";$/gm;

/** The renderer's source without unused shaders. */
export function withoutUnused(source) {
  const [, entries] = CHUNKS.exec(source) ?? [];
  const chunks = [...(entries ?? '').matchAll(ENTRY)];
  const unused = new Set(chunks.filter(([, name]) => !USED.has(name)).map(([, , text]) => text));
  if (chunks.length - unused.size !== USED.size)
    throw new Error('three.js keeps its shaders in another way: change used-shaders.mjs.');
  return source.replace(TEXT, (text, how, name) =>
    unused.has(name) ? `${how} ${name} = undefined;` : text,
  );
}

/** @returns {import('vite').Plugin} */
export const usedShaders = () => ({
  name: 'abflat-used-shaders',
  apply: 'build',
  transform: (source, id) =>
    RENDERER.test(id) ? { code: withoutUnused(source), map: null } : undefined,
});
