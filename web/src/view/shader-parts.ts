import { FACE_COLORS } from '../colors/fault-colors';
import { RAMP_SIZE } from '../colors/palette';

/**
 * The triangle's corner as barycentric coordinates: without an index, corners are numbered in
 * threes.
 */
export const CORNER_GLSL = /* glsl */ `
  vec3 cornerOf(int vertex) {
    int k = vertex % 3;
    return vec3(k == 0, k == 1, k == 2);
  }
`;

/**
 * Coverage (0..1) by the triangle's edges, drawn `width` device pixels wide and anti-aliased. Fades
 * as triangles get smaller than a few pixels, so that a dense mesh does not become one dark blot.
 */
export const EDGE_GLSL = /* glsl */ `
  float edgeCoverage(vec3 corner, float width) {
    vec3 right = dFdx(corner), up = dFdy(corner);
    vec3 slope = sqrt(right * right + up * up);
    vec3 pixels = corner / slope;
    float nearest = min(pixels.x, min(pixels.y, pixels.z));
    float height = 1.0 / max(slope.x, max(slope.y, slope.z));
    float line = 1.0 - smoothstep(0.5 * width - 0.5, 0.5 * width + 0.5, nearest);
    return line * mix(0.3, 1.0, smoothstep(1.0, 8.0 * width, height));
  }
`;

/** The heat map of a measure, see heat-uniforms.ts. */
export const HEAT_GLSL = /* glsl */ `
  uniform vec3 ramp[${RAMP_SIZE}];
  uniform vec3 twoSided[3];
  uniform int measure;
  uniform bool isTwoSided;
  uniform vec2 chosen;
  uniform bool choosesByDistance;
  vec3 heatColor(vec4 places) {
    float x = clamp(places[measure], 0.0, 1.0);
    if (isTwoSided) {
      vec3 end = x < 0.5 ? twoSided[0] : twoSided[2];
      return mix(twoSided[1], end, abs(2.0 * x - 1.0));
    }
    x *= ${(RAMP_SIZE - 1).toFixed(1)};
    vec3 color = ramp[0];
    for (int i = 1; i < ${RAMP_SIZE}; ++i) color = mix(color, ramp[i], clamp(x - float(i - 1), 0.0, 1.0));
    return color;
  }
  bool isChosen(vec4 places) {
    float x = places[measure];
    if (choosesByDistance && isTwoSided) x = abs(x - 0.5);
    return x >= chosen.x && x <= chosen.y;
  }
`;

/** The colour of a chart, or of a fault, by its number. */
export const CHART_GLSL = /* glsl */ `
  uniform vec3 charts[${FACE_COLORS}];
  vec3 chartColor(float number) {
    return charts[int(number + 0.5)];
  }
`;

/** Checkerboard with cells of size 1, filtered over the pixel's footprint: no shimmer at a distance. */
export const CHECKER_GLSL = /* glsl */ `
  float checker(vec2 p) {
    vec2 w = max(abs(dFdx(p)), abs(dFdy(p))) + 1e-4;
    vec2 i = 2.0 * (abs(fract((p - 0.5 * w) * 0.5) - 0.5) - abs(fract((p + 0.5 * w) * 0.5) - 0.5)) / w;
    return 0.5 - 0.5 * i.x * i.y;
  }
`;
