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

/**
 * No lights or shadows around, no materials but our own, no background, no headsets: what the renderer still asks of these
 * classes and functions.
 */
const UNUSED = {
  PMREMGenerator: 'class PMREMGenerator {}',
  WebXRManager: `class WebXRManager extends EventDispatcher {
  enabled = false;
  isPresenting = false;
  getEnvironmentBlendMode() {}
  setAnimationLoop() {}
  dispose() {}
}`,
  WebGLOutput: 'class WebGLOutput {}',
  WebGLShadowMap: `function WebGLShadowMap() {
  return { enabled: false, type: PCFShadowMap, render() {} };
}`,
  WebGLMorphtargets: 'function WebGLMorphtargets() {}',
  WebGLUniformsGroups: `function WebGLUniformsGroups() {
  return { dispose() {} };
}`,
  WebGLEnvironments: `function WebGLEnvironments() {
  return { get: () => null, dispose() {} };
}`,
  WebGLMaterials: `function WebGLMaterials() {
  return { refreshMaterialUniforms: (_, material) => { material.uniformsNeedUpdate = false; } };
}`,
  WebGLLights: `function WebGLLights() {
  const names = 'sun directional point spot spotLightMap rectArea hemi sunShadowMap directionalShadowMap pointShadowMap spotShadowMap';
  const state = { version: 0, numSpotLightShadowsWithMaps: 0, numLightProbes: 0 };
  for (const name of names.split(' ')) state[name] = [];
  return { setup() {}, setupView() {}, state };
}`,
  WebGLBackground: `function WebGLBackground(renderer, environments, state, objects, alpha, premultipliedAlpha) {
  const clearColor = new Color(0);
  let clearAlpha = alpha ? 0 : 1;
  const setClear = () => {
    clearColor.getRGB(_rgb, getUnlitUniformColorSpace(renderer));
    state.buffers.color.setClear(_rgb.r, _rgb.g, _rgb.b, clearAlpha, premultipliedAlpha);
  };
  return {
    getClearColor: () => clearColor,
    getClearAlpha: () => clearAlpha,
    setClearColor(color, alpha = 1) {
      clearColor.set(color);
      clearAlpha = alpha;
      setClear();
    },
    setClearAlpha(alpha) {
      clearAlpha = alpha;
      setClear();
    },
    render() {
      setClear();
      if (!renderer.autoClear) return;
      state.buffers.depth.setTest(true);
      state.buffers.depth.setMask(true);
      state.buffers.color.setMask(true);
      renderer.clear(renderer.autoClearColor, renderer.autoClearDepth, renderer.autoClearStencil);
    },
    addToRenderList() {},
    dispose() {},
  };
}`,
  getDFGLUT: 'function getDFGLUT() {}',
};

/** Nothing is stored as JSON; what is under the pointer, and what keys do, is up to the page itself. */
const UNUSED_METHODS =
  /^\t(?:static )?(?:toJSON|fromJSON|raycast|_handleKeyDown|saveState)\(.*\) \{$[\s\S]*?^\t\}$/gm;

/** The colours of the page are numbers. */
const COLOR_NAMES = /^(const _colorKeywords = )\{[\s\S]*?\};$/m;

const THREE = /\/three\/(build|examples)\/.*\.js$/;
const CORE = /\/three\/build\/three\.core\.js$/;
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
    const [found] = new RegExp(`^(class|function) ${name}\\b[^]*?^}$`, 'm').exec(text) ?? [];
    if (!found) throw changed();
    text = text.replace(found, () => rest);
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
    const code = RENDERER.test(id) ? withoutClasses(withoutShaders(source)) : source;
    return { code: withoutMethods(code, id), map: null };
  },
});
