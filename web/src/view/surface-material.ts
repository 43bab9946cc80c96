import { Color, DoubleSide, ShaderMaterial, Vector2 } from 'three';
import { FACE_COLORS } from '../colors/fault-colors';
import type { Palette } from '../colors/palette';
import { FLAGS_GLSL } from './chart-flags';
import { heatUniforms, paintHeat } from './heat-uniforms';
import { LOOK_GLSL, LOOK_VERTEX_GLSL, lookUniforms } from './look-shader';
import { CHART_GLSL, CHECKER_GLSL, CORNER_GLSL, EDGE_GLSL, HEAT_GLSL } from './shader-parts';
import { PICTURE_GLSL } from './uv-picture';

/** What the surface is painted with. */
export const SurfacePaint = {
  Clay: 0,
  Checker: 1,
  Heat: 2,
  Charts: 3,
  Picture: 4,
  Materials: 5,
} as const;
export type SurfacePaint = (typeof SurfacePaint)[keyof typeof SurfacePaint];

/** In place of the number of the highlighted chart. */
export const NONE_LIT = -1;

const VERTEX = /* glsl */ `
  ${CORNER_GLSL}
  ${LOOK_VERTEX_GLSL}
  uniform int paint;
  attribute float chart, piece;
  varying vec3 vNormal;
#ifdef WIRE
  varying vec3 vCorner;
#endif
#ifdef HEAT
  attribute vec4 heat;
  flat varying vec4 vHeat;
#endif
  varying vec3 vView;
  varying vec2 vUv;
  flat varying float vChart, vPiece;
  void main() {
    vec4 view = modelViewMatrix * vec4(position, 1.0);
    vNormal = normalMatrix * normal;
#ifdef WIRE
    vCorner = cornerOf(gl_VertexID);
#endif
    vView = -view.xyz;
    vUv = uv;
#ifdef HEAT
    vHeat = heat;
#endif
    vChart = chart;
    vPiece = piece;
#ifdef LOOK
    readLook(paint == 5);
#endif
    gl_Position = projectionMatrix * view;
  }
`;

// Three lights (key, fill, rim) fixed to the camera, plus a sky: shape is readable from every side.
const FRAGMENT = /* glsl */ `
#ifdef WIRE
  ${EDGE_GLSL}
  varying vec3 vCorner;
#endif
#ifdef HEAT
  ${HEAT_GLSL}
  flat varying vec4 vHeat;
#endif
#ifdef PICTURE
  ${PICTURE_GLSL}
#endif
  ${CHECKER_GLSL}
  ${CHART_GLSL}
  ${FLAGS_GLSL}
  ${LOOK_GLSL}
  uniform int paint;
  uniform vec2 uvOrigin;
  uniform float uvCell;
  uniform float wire;
  uniform float pixelRatio;
  uniform float lit;
  uniform vec3 clay, checkA, checkB, back, wireColor, background;
  varying vec3 vNormal;
  varying vec3 vView;
  varying vec2 vUv;
  flat varying float vChart, vPiece;

  vec3 shade(vec3 base, vec3 n, vec3 v) {
    vec3 key = normalize(vec3(-0.45, 0.65, 0.75));
    vec3 fill = normalize(vec3(0.8, -0.1, 0.6));
    float sky = 0.5 + 0.5 * n.y;
    float light = mix(0.12, 0.26, sky) + 0.74 * pow(max(0.5 + 0.5 * dot(n, key), 0.0), 2.2) +
                  0.18 * max(dot(n, fill), 0.0);
    float gloss = pow(max(dot(n, normalize(key + v)), 0.0), 42.0);
    float away = 1.0 - max(dot(n, v), 0.0);
    float rim = away * away;
    return base * light + 0.06 * gloss + 0.05 * rim * rim;
  }

  void main() {
    vec3 flag = flagsOf(vPiece);
#ifdef LOOK
    vec2 dx = dFdx(vTexel), dy = dFdy(vTexel);
#endif
    if (flag.r > 0.5) discard;
    vec3 base = clay;
    bool isUnlit = false;
    if (paint == 1 || paint == 3) {
      float light = checker(vUv);
      base = paint == 1 ? mix(checkB, checkA, light) : chartColor(vChart) * mix(0.8, 1.0, light);
    }
#ifdef PICTURE
    if (paint == 4) {
      vec4 texel = pictureColor(uvOrigin + uvCell * vUv);
      base = mix(clay, texel.rgb, texel.a);
    }
#endif
#ifdef LOOK
    if (paint == 5) {
      vec4 look = lookColor(dx, dy, isUnlit);
      if (isLeftOut(look.a)) discard;
      base = look.rgb;
    }
#endif
    bool isDim = lit >= 0.0 && vPiece != lit;
#ifdef HEAT
    if (paint == 2) {
      base = heatColor(vHeat);
      isDim = isDim || !isChosen(vHeat);
    }
#endif
    if (isDim) base = mix(base, background, 0.75);
    base = mix(base, vec3(1.0), 0.25 * flag.g);
    vec3 n = normalize(vNormal);
    if (!gl_FrontFacing) {
      n = -n;
      if (paint != 5) base = mix(base, back, 0.6);
    }
    vec3 color = isUnlit ? base : shade(base, n, normalize(vView));
#ifdef WIRE
    color = mix(color, wireColor, wire * edgeCoverage(vCorner, pixelRatio));
#endif
    gl_FragColor = vec4(color, 1.0);
    #include <colorspace_fragment>
  }
`;

/**
 * Material of the mesh in 3D. Its geometry has no index and has the attributes normal, uv (in
 * cells), heat (a place on the ramp for each measure), chart (number of its colour), piece (number
 * of the chart itself) and source (see look-shader.ts). WIRE, HEAT, PICTURE and LOOK are
 * defined while they are needed.
 */
export function createSurfaceMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    // The boundary line lies exactly on the surface and must win.
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    uniforms: {
      paint: { value: SurfacePaint.Clay },
      wire: { value: 0 },
      lit: { value: NONE_LIT },
      background: { value: new Color() },
      pixelRatio: { value: 1 },
      clay: { value: new Color() },
      checkA: { value: new Color() },
      checkB: { value: new Color() },
      back: { value: new Color() },
      wireColor: { value: new Color() },
      ...heatUniforms(),
      picture: { value: null },
      uvOrigin: { value: new Vector2() },
      uvCell: { value: 1 },
      flags: { value: null },
      ...lookUniforms(),
      charts: { value: Array.from({ length: FACE_COLORS }, () => new Color()) },
    },
  });
}

export function paintSurface(material: ShaderMaterial, palette: Palette): void {
  const { uniforms } = material;
  uniforms.background.value = palette.background;
  uniforms.clay.value = palette.clay;
  uniforms.checkA.value = palette.checkA;
  uniforms.checkB.value = palette.checkB;
  uniforms.back.value = palette.back;
  uniforms.wireColor.value = palette.wire;
  uniforms.charts.value = palette.faces;
  paintHeat(material, palette);
}
