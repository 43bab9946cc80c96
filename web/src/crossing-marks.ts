import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial } from 'three';

/** Css pixels across. */
const SIZE = 26;

const VERTEX = /* glsl */ `
  uniform float size;
  void main() {
    gl_PointSize = size;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

const FRAGMENT = /* glsl */ `
  uniform float size;
  uniform vec3 color;
  void main() {
    float radius = length(gl_PointCoord - 0.5) * size;
    float width = size / 12.0;
    float ring = 1.0 - smoothstep(width / 2.0 - 0.5, width / 2.0 + 0.5, abs(radius - size / 2.0 + width));
    if (ring <= 0.0) discard;
    gl_FragColor = vec4(color, ring);
    #include <colorspace_fragment>
  }
`;

/** Rings round the points where the boundary crosses itself. */
export class CrossingMarks {
  private readonly material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    transparent: true,
    depthTest: false,
    uniforms: { size: { value: SIZE }, color: { value: new Color() } },
  });
  readonly object = new Points(new BufferGeometry(), this.material);

  constructor() {
    this.object.frustumCulled = false;
    this.object.renderOrder = 2;
    this.show(new Float32Array());
  }

  /** xyz per point. */
  show(points: Float32Array): void {
    this.object.geometry.dispose();
    this.object.geometry = new BufferGeometry();
    this.object.geometry.setAttribute('position', new BufferAttribute(points, 3));
    this.object.visible = points.length > 0;
  }

  setColor(color: Color): void {
    this.material.uniforms.color.value = color;
  }

  setPixelRatio(ratio: number): void {
    this.material.uniforms.size.value = SIZE * ratio;
  }
}
