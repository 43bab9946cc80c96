import { Color, DoubleSide, ShaderMaterial } from 'three';
import { CHART_COLORS } from '../colors/chart-colors';
import { type Palette, RAMP_SIZE } from '../colors/palette';
import { CHART_GLSL, CORNER_GLSL, EDGE_GLSL, RAMP_GLSL } from './shader-parts';
import { NONE_LIT } from './surface-material';

const VERTEX = /* glsl */ `
  ${CORNER_GLSL}
  attribute float error;
  attribute float chart, piece;
  varying vec3 vCorner;
  flat varying float vError;
  flat varying float vChart, vPiece;
  void main() {
    vCorner = cornerOf(gl_VertexID);
    vError = error;
    vChart = chart;
    vPiece = piece;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

// The fill is translucent: where the layout overlaps itself, it is darker.
const FRAGMENT = /* glsl */ `
  ${EDGE_GLSL}
  ${RAMP_GLSL}
  ${CHART_GLSL}
  uniform bool showsError, showsCharts;
  uniform float pixelRatio, lit;
  uniform vec3 fill, edge, flipped;
  varying vec3 vCorner;
  flat varying float vError;
  flat varying float vChart, vPiece;
  void main() {
    vec3 base = showsCharts ? chartColor(vChart) : fill;
    vec3 lines = showsCharts ? 0.35 * base : edge;
    if (showsError) base = rampColor(vError);
    float alpha = showsError || showsCharts ? 0.9 : 0.75;
    if (!gl_FrontFacing) base = flipped;
    if (lit >= 0.0 && vPiece != lit) alpha = 0.25;
    float line = edgeCoverage(vCorner, pixelRatio) * (showsError || showsCharts ? 0.45 : 0.85);
    gl_FragColor = vec4(mix(base, lines, line), mix(alpha, min(1.0, 2.0 * alpha), line));
    #include <colorspace_fragment>
  }
`;

/**
 * Material of the uv layout. Its geometry has no index and has the attributes error (angle error),
 * chart (number of its colour) and piece (number of the chart itself).
 */
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
      showsCharts: { value: false },
      pixelRatio: { value: 1 },
      lit: { value: NONE_LIT },
      fill: { value: new Color() },
      edge: { value: new Color() },
      flipped: { value: new Color() },
      ramp: { value: Array.from({ length: RAMP_SIZE }, () => new Color()) },
      charts: { value: Array.from({ length: CHART_COLORS }, () => new Color()) },
    },
  });
}

export function paintLayout(material: ShaderMaterial, palette: Palette): void {
  const { uniforms } = material;
  uniforms.fill.value = palette.fill;
  uniforms.edge.value = palette.edge;
  uniforms.flipped.value = palette.flipped;
  uniforms.ramp.value = palette.ramp;
  uniforms.charts.value = palette.charts;
}
