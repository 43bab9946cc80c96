// Vite plugin: leaves out what the page does not use of three.js. The renderer refers to all of it, so bundlers keep it.

import { NEVER, UNUSED, UNUSED_FUNCTIONS } from './unused-three.mjs';

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
]);

/**
 * Nothing is stored as JSON; what is under the pointer, and what keys do, is up to the page itself, and its colours are
 * numbers.
 */
const UNUSED_METHODS =
  /^\t(?:static )?(?:toJSON|fromJSON|raycast|_handleKeyDown|saveState|setStyle|getStyle|setColorName|offsetHSL|lerpHSL)\(.*\) \{$[\s\S]*?^\t\}$/gm;

/** The colours of the page are numbers. */
const COLOR_NAMES = /^(const _colorKeywords = )\{[\s\S]*?\};$/m;

const THREE = /\/three\/(build|examples)\/.*\.js$/;
const CORE = /\/three\/build\/three\.core\.js$/;
const RENDERER = /\/three\/build\/three\.module\.js$/;
/** Shaders of materials that the page does not have; of their uniforms, what LineMaterial has as well. */
const SHADERS = /^(?:const ShaderLib = |ShaderLib\.physical = )\{[\s\S]*?^\};$/gm;
const UNIFORMS = /^const UniformsLib = \{[\s\S]*?^\};$/m;
const UNIFORM_SET = /^\t(?!common:|fog:)\w+: \{[\s\S]*?^\t\},?$/gm;
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

function withoutMaterials(source) {
  const [uniforms] = UNIFORMS.exec(source) ?? [];
  if (!uniforms || [...source.matchAll(SHADERS)].length !== 2) throw changed();
  return source
    .replace(uniforms, () => uniforms.replace(UNIFORM_SET, ''))
    .replace(SHADERS, (text) => (text.startsWith('const') ? 'const ShaderLib = {};' : ''));
}

function withoutClasses(source) {
  let text = source;
  for (const [name, rest] of Object.entries(UNUSED)) {
    const [found] = new RegExp(`^(class|function) ${name}\\b[^]*?^}$`, 'm').exec(text) ?? [];
    if (!found) throw changed();
    text = text.replace(found, () => rest);
  }
  return text;
}

function withoutFunctions(source) {
  let text = source;
  for (const name of UNUSED_FUNCTIONS) {
    const whole = new RegExp(`^(\\t+)function ${name}\\(.*\\) \\{$[^]*?^\\1\\}$`, 'm');
    if (!whole.test(text)) throw changed();
    text = text.replace(whole, `function ${name}() {}`);
  }
  return text;
}

/** The minifier leaves out what is done if something is one of those. */
function withoutKinds(source) {
  let text = source;
  for (const name of NEVER) {
    const asked = new RegExp(
      `(?<![\\w$.\\])])[\\w$.]+(?:\\[ \\w+ \\])?\\.is${name}\\b(?! = )`,
      'g',
    );
    if (!asked.test(text)) throw changed();
    text = text.replaceAll(asked, 'false');
  }
  return text;
}

function withoutMethods(source, id) {
  const text = source.replace(UNUSED_METHODS, '');
  if (!CORE.test(id)) return text;
  const named = text.replace(COLOR_NAMES, '$1{};');
  if (text === source || named === text) throw changed();
  return named;
}

/** @returns {import('vite').Plugin} */
export const usedThree = () => ({
  name: 'abflat-used-three',
  apply: 'build',
  transform: (source, id) => {
    if (!THREE.test(id)) return undefined;
    const code = RENDERER.test(id)
      ? withoutKinds(withoutFunctions(withoutClasses(withoutMaterials(withoutShaders(source)))))
      : source;
    return { code: withoutMethods(code, id), map: null };
  },
});
