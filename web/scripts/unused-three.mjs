// No lights or shadows around, no materials but our own, no background, no clipping, no compressed textures, no headsets:
// what the renderer of three.js still asks of these classes and functions.

export const UNUSED = {
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
  WebGLClipping: `function WebGLClipping() {
  return { uniform: { value: null, needsUpdate: false }, numPlanes: 0, numIntersection: 0, init: () => false };
}`,
  WebGLUtils: `function WebGLUtils(gl) {
  const constants = {
    [UnsignedByteType]: gl.UNSIGNED_BYTE,
    [UnsignedIntType]: gl.UNSIGNED_INT,
    [FloatType]: gl.FLOAT,
    [RGBAFormat]: gl.RGBA,
    [RGBAIntegerFormat]: gl.RGBA_INTEGER,
  };
  return { convert: (p) => constants[p] ?? null };
}`,
  getDFGLUT: 'function getDFGLUT() {}',
};

/** Functions within those that stay: nothing here is a cube, a video or seen through, and what is drawn into has one sample and no texture of depths. */
export const UNUSED_FUNCTIONS = [
  'renderTransmissionPass',
  'setupDepthTexture',
  'updateMultisampleRenderTarget',
  'uploadCubeTexture',
];

/** Kinds of things that the renderer asks for, and that the page never makes: an object's `isSprite` is false. */
export const NEVER = [
  ...['ArrayCamera', 'BatchedMesh', 'InstancedMesh', 'LineLoop', 'LOD', 'Light', 'SkinnedMesh'],
  ...['Sprite', 'CompressedArrayTexture', 'CompressedTexture', 'CubeTexture', 'Data3DTexture'],
  ...['DepthTexture', 'ExternalTexture', 'HTMLTexture', 'PMREMTexture', 'VideoTexture'],
  ...['WebGL3DRenderTarget', 'WebGLArrayRenderTarget', 'WebGLCubeRenderTarget', 'XRRenderTarget'],
  ...['MeshBasicMaterial', 'MeshLambertMaterial', 'MeshPhongMaterial', 'MeshPhysicalMaterial'],
  ...['MeshStandardMaterial', 'MeshToonMaterial', 'NodeMaterial', 'ShadowMaterial'],
  'SpriteMaterial',
];
