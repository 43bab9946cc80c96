import { Color, DoubleSide, ShaderMaterial, Vector2, Vector4 } from 'three';
import { FACE_COLORS } from '../colors/fault-colors';
import type { Palette } from '../colors/palette';
import { BEND_GLSL } from './bending';
import { FLAGS_GLSL, MOTION_GLSL } from './chart-flags';
import { heatUniforms, paintHeat } from './heat-uniforms';
import { LOOK_GLSL, LOOK_VERTEX_GLSL, lookUniforms } from './look-shader';
import { CHART_GLSL, CORNER_GLSL, EDGE_GLSL, HEAT_GLSL } from './shader-parts';
import { NONE_LIT } from './surface-material';
import { PICTURE_GLSL } from './uv-picture';

const VERTEX = /* glsl */ `
  ${CORNER_GLSL}
  ${LOOK_VERTEX_GLSL}
  uniform bool showsMaterials;
#ifdef HEAT
  attribute vec4 heat;
  flat varying vec4 vHeat;
#endif
  ${FLAGS_GLSL}
  ${MOTION_GLSL}
  ${BEND_GLSL}
  attribute float chart, piece;
  varying vec3 vCorner;
  varying vec2 vPlace;
  flat varying vec3 vFlag;
  flat varying float vChart, vPiece, vSide;
  void main() {
    vCorner = cornerOf(gl_VertexID);
    vFlag = flagsOf(piece);
    vSide = allFlagsOf(piece).a > 0.5 ? -1.0 : 1.0;
    vPlace = moved(position.xy, vFlag) + bent();
#ifdef HEAT
    vHeat = heat;
#endif
    vChart = chart;
    vPiece = piece;
#ifdef LOOK
    readLook(showsMaterials);
#endif
    gl_Position = projectionMatrix * modelViewMatrix * vec4(vPlace, 0.0, 1.0);
    // All in one plane, in their order, but for the charts that are being moved.
    gl_Position.z = vFlag.b > 0.5 ? -0.5 : 0.0;
  }
`;

// The fill is translucent: where the layout overlaps itself, it is darker.
const FRAGMENT = /* glsl */ `
  ${EDGE_GLSL}
#ifdef HEAT
  ${HEAT_GLSL}
  flat varying vec4 vHeat;
#endif
#ifdef PICTURE
  ${PICTURE_GLSL}
#endif
  ${CHART_GLSL}
  ${LOOK_GLSL}
  uniform bool marksFlipped, showsHeat, showsCharts, showsGrid, showsMaterials, showsImage;
  uniform vec2 uvMiddle;
  uniform float uvUnit;
  uniform float pixelRatio, lit;
  uniform vec3 fill, edge, flipped;
  varying vec3 vCorner;
  varying vec2 vPlace;
  flat varying vec3 vFlag;
  flat varying float vChart, vPiece, vSide;
  void main() {
#ifdef LOOK
    vec2 dx = dFdx(vTexel), dy = dFdy(vTexel);
#endif
    if (vFlag.r > 0.5) discard;
    bool isFlipped = marksFlipped && gl_FrontFacing != (vSide > 0.0);
    vec3 base = showsCharts ? chartColor(vChart) : fill;
    vec3 lines = showsCharts ? 0.35 * base : edge;
#ifdef HEAT
    if (showsHeat) base = heatColor(vHeat);
#endif
#ifdef PICTURE
    if (showsGrid) base = pictureColor(uvMiddle + uvUnit * vPlace).rgb;
#endif
    bool isPainted = showsHeat || showsCharts || showsGrid;
    float alpha = isPainted ? 0.9 : 0.75;
#ifdef LOOK
    if (showsMaterials) {
      bool isUnlit;
      vec4 look = lookColor(dx, dy, isUnlit);
      base = look.rgb;
      alpha = look.a;
    }
#endif
    // The image lies below and is to be seen as it is.
    if (showsImage) alpha = isFlipped ? 0.6 : vFlag.g > 0.5 || vPiece == lit ? 0.25 : 0.1;
    if (isFlipped) base = flipped;
    base = mix(base, vec3(1.0), 0.25 * vFlag.g);
    bool isDim = lit >= 0.0 && vPiece != lit;
#ifdef HEAT
    if (showsHeat) isDim = isDim || !isChosen(vHeat);
#endif
    if (isDim) alpha = showsImage ? 0.0 : 0.25;
    float line = edgeCoverage(vCorner, pixelRatio) * (isPainted ? 0.45 : 0.85);
    if (showsMaterials || showsImage) line = 0.0; // only the outlines of charts lie above the picture
    gl_FragColor = vec4(mix(base, lines, line), mix(alpha, min(1.0, 2.0 * alpha), line));
    #include <colorspace_fragment>
  }
`;

/**
 * Material of the uv layout. Its geometry has no index and has the attributes heat (a place on
 * the ramp for each measure), chart (number of its colour), piece (number of the chart itself),
 * source (see look-shader.ts) and, while a pin is dragged, weight (see bending.ts). HEAT, PICTURE
 * and LOOK are defined while they are needed.
 */
export function createLayoutMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    transparent: true,
    uniforms: {
      marksFlipped: { value: true },
      showsHeat: { value: false },
      showsGrid: { value: false },
      showsCharts: { value: false },
      showsMaterials: { value: false },
      showsImage: { value: false },
      pixelRatio: { value: 1 },
      lit: { value: NONE_LIT },
      fill: { value: new Color() },
      edge: { value: new Color() },
      flipped: { value: new Color() },
      ...heatUniforms(),
      picture: { value: null },
      uvMiddle: { value: new Vector2() },
      uvUnit: { value: 1 },
      flags: { value: null },
      ...lookUniforms(),
      motion: { value: new Vector4(1, 0, 0, 0) },
      bend: { value: new Vector2() },
      charts: { value: Array.from({ length: FACE_COLORS }, () => new Color()) },
    },
  });
}

export function paintLayout(material: ShaderMaterial, palette: Palette): void {
  const { uniforms } = material;
  uniforms.fill.value = palette.fill;
  uniforms.edge.value = palette.edge;
  uniforms.flipped.value = palette.flipped;
  uniforms.charts.value = palette.faces;
  paintHeat(material, palette);
}
