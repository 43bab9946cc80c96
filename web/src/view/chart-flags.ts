import { DataTexture, NearestFilter, type ShaderMaterial } from 'three';

/** Texels per row: every browser allows textures this wide. */
const WIDTH = 1024;

/** How some charts are shown. */
export interface ChartStates {
  selected: ReadonlySet<number>;
  hidden: ReadonlySet<number>;
  hovered: number | null;
  /** Charts that overlap, are flipped or leave the square. */
  invalid: ReadonlySet<number>;
  stacked: StackedCharts;
}

/** Charts that abflat has put on others of the same shape. */
export interface StackedCharts {
  /** What each lies on. */
  on: ReadonlyMap<number, number>;
  /** Those whose triangles run clockwise. */
  mirrored: ReadonlySet<number>;
}

const NONE: ReadonlySet<number> = new Set();
export const NO_STATES: ChartStates = {
  selected: NONE,
  hidden: NONE,
  hovered: null,
  invalid: NONE,
  stacked: { on: new Map(), mirrored: NONE },
};

/** What the layout does not show: hidden charts, and those that lie on one that it shows. */
export function unseen({ hidden, selected, stacked }: ChartStates): ReadonlySet<number> {
  const covered = [...stacked.on].filter(
    ([chart, below]) => !selected.has(chart) && !hidden.has(below),
  );
  return covered.length > 0 ? new Set([...hidden, ...covered.map(([chart]) => chart)]) : hidden;
}

/**
 * A texel for each chart: red if it is hidden, green if it is hovered, blue if it is being moved, and opaque if it is
 * mirrored.
 */
export class ChartFlags {
  private texture = textureFor(1);

  /** All of `materials` read them. */
  constructor(private readonly materials: ShaderMaterial[]) {
    this.setUniforms();
  }

  show({ hidden, hovered, stacked }: ChartStates, moving: Iterable<number> = []): void {
    const charts = [...hidden, ...moving, ...stacked.mirrored, hovered ?? -1];
    this.makeRoom(charts.reduce((most, chart) => Math.max(most, chart + 1), 1));
    const bytes = this.texture.image.data as Uint8Array;
    bytes.fill(0);
    for (const chart of hidden) bytes[4 * chart] = 255;
    if (hovered !== null) bytes[4 * hovered + 1] = 255;
    for (const chart of moving) bytes[4 * chart + 2] = 255;
    for (const chart of stacked.mirrored) bytes[4 * chart + 3] = 255;
    this.texture.needsUpdate = true;
  }

  private makeRoom(count: number): void {
    const { width, height } = this.texture.image;
    if (count <= width * height) return;
    this.texture.dispose();
    this.texture = textureFor(count);
    this.setUniforms();
  }

  private setUniforms(): void {
    for (const { uniforms } of this.materials) uniforms.flags.value = this.texture;
  }
}

function textureFor(count: number): DataTexture {
  const height = Math.ceil(count / WIDTH);
  const texture = new DataTexture(new Uint8Array(4 * WIDTH * height), WIDTH, height);
  texture.minFilter = NearestFilter;
  texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/** `piece` is the number of a chart; charts beyond the texture have no flags. */
export const FLAGS_GLSL = /* glsl */ `
  uniform sampler2D flags;
  vec4 allFlagsOf(float piece) {
    int chart = int(piece + 0.5);
    ivec2 at = ivec2(chart % ${WIDTH}, chart / ${WIDTH});
    if (at.y >= textureSize(flags, 0).y) return vec4(0.0);
    return texelFetch(flags, at, 0);
  }
  vec3 flagsOf(float piece) {
    return allFlagsOf(piece).rgb;
  }
`;

/** Of a point of a chart with this flag. `motion` is a motion's a, b, x and y. */
export const MOTION_GLSL = /* glsl */ `
  uniform vec4 motion;
  vec2 moved(vec2 p, vec3 flag) {
    if (flag.b < 0.5) return p;
    return vec2(motion.x * p.x - motion.y * p.y, motion.y * p.x + motion.x * p.y) + motion.zw;
  }
`;
