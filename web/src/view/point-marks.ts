import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial } from 'three';

// Slightly nearer than the surface that the point lies on, which would otherwise hide parts of the
// mark.
const VERTEX = /* glsl */ `
  uniform float size;
  #ifdef TINTED
    attribute vec3 tint;
    varying vec3 shade;
  #endif
  void main() {
    #ifdef TINTED
      shade = tint;
    #endif
    gl_PointSize = size;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_Position.z -= 0.0015 * gl_Position.w;
  }
`;

// `hole`: radius of the hole relative to that of the mark.
const FRAGMENT = /* glsl */ `
  uniform float size, hole;
  #ifdef TINTED
    varying vec3 shade;
    #define color shade
  #else
    uniform vec3 color;
  #endif
  void main() {
    float radius = length(gl_PointCoord - 0.5) * size;
    float outer = size / 2.0 - 0.5;
    float cover = 1.0 - smoothstep(outer - 0.5, outer + 0.5, radius);
    if (hole > 0.0) cover *= smoothstep(hole * outer - 0.5, hole * outer + 0.5, radius);
    if (cover <= 0.0) discard;
    gl_FragColor = vec4(color, cover);
    #include <colorspace_fragment>
  }
`;

export interface MarkStyle {
  /** Css pixels across. */
  size: number;
  /** Radius of a ring's hole relative to its own; 0 for a dot. */
  hole: number;
  depthTest: boolean;
  /** Whether each has a color of its own. */
  isTinted?: boolean;
}

/** Tightened vertices: small enough to tell neighbours apart. */
export const DOT = { size: 7, hole: 0 };
/** Vertices with a bound of their own. */
export const OWN_BOUND = { size: 10, hole: 0, isTinted: true };
/** Crossings: what is inside the ring stays visible. */
export const RING = { size: 26, hole: 0.82 };

/** Dots or rings of one size on the screen. */
export class PointMarks {
  private readonly material: ShaderMaterial;
  readonly object: Points<BufferGeometry, ShaderMaterial>;

  constructor(private readonly style: MarkStyle) {
    this.material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      defines: style.isTinted ? { TINTED: '' } : {},
      depthTest: style.depthTest,
      uniforms: {
        size: { value: style.size },
        hole: { value: style.hole },
        color: { value: new Color() },
      },
    });
    this.object = new Points(new BufferGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 2;
    this.show(new Float32Array());
  }

  /** xyz per point, and rgb if they are tinted. */
  show(points: Float32Array, tints: Float32Array = new Float32Array(points.length)): void {
    this.object.geometry.dispose();
    this.object.geometry = new BufferGeometry();
    this.object.geometry.setAttribute('position', new BufferAttribute(points, 3));
    if (this.style.isTinted)
      this.object.geometry.setAttribute('tint', new BufferAttribute(tints, 3));
    this.object.visible = points.length > 0;
  }

  setColor(color: Color): void {
    this.material.uniforms.color.value = color;
  }

  setPixelRatio(ratio: number): void {
    this.material.uniforms.size.value = this.style.size * ratio;
  }
}
