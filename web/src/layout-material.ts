import { Color, DoubleSide, ShaderMaterial } from 'three';
import type { Palette } from './palette';
import { RAMP_SIZE } from './palette';
import { CORNER_GLSL, EDGE_GLSL, RAMP_GLSL } from './shader-parts';

const VERTEX = /* glsl */ `
  ${CORNER_GLSL}
  attribute float error;
  varying vec3 vCorner;
  flat varying float vError;
  void main() {
    vCorner = cornerOf(gl_VertexID);
    vError = error;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

// The fill is translucent: where the layout overlaps itself, it is darker.
const FRAGMENT = /* glsl */ `
  ${EDGE_GLSL}
  ${RAMP_GLSL}
  uniform bool showsError;
  uniform float pixelRatio;
  uniform vec3 fill, edge, flipped;
  varying vec3 vCorner;
  flat varying float vError;
  void main() {
    vec3 base = showsError ? rampColor(vError) : fill;
    float alpha = showsError ? 0.9 : 0.75;
    if (!gl_FrontFacing) base = flipped;
    float line = edgeCoverage(vCorner, pixelRatio) * (showsError ? 0.45 : 0.85);
    gl_FragColor = vec4(mix(base, edge, line), mix(alpha, 1.0, line));
    #include <colorspace_fragment>
  }
`;

/** Material of the uv layout. Its geometry has no index and the attribute error (angle error). */
export function createLayoutMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    transparent: true,
    depthTest: false,
    depthWrite: false,
    uniforms: {
      showsError: { value: false },
      pixelRatio: { value: 1 },
      fill: { value: new Color() },
      edge: { value: new Color() },
      flipped: { value: new Color() },
      ramp: { value: Array.from({ length: RAMP_SIZE }, () => new Color()) },
    },
  });
}

export function paintLayout(material: ShaderMaterial, palette: Palette): void {
  const { uniforms } = material;
  uniforms.fill.value = palette.fill;
  uniforms.edge.value = palette.edge;
  uniforms.flipped.value = palette.flipped;
  uniforms.ramp.value = palette.ramp;
}
