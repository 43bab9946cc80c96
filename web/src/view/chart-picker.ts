import {
  Color,
  DoubleSide,
  type Mesh,
  NoBlending,
  type OrthographicCamera,
  type PerspectiveCamera,
  ShaderMaterial,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { FLAGS_GLSL } from './chart-flags';
import type { Pixel } from './sight';

const VERTEX = /* glsl */ `
  attribute float piece;
  flat varying float vPiece;
  void main() {
    vPiece = piece;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

const FRAGMENT = /* glsl */ `
  ${FLAGS_GLSL}
  flat varying float vPiece;
  void main() {
    if (flagsOf(vPiece).r > 0.5) discard;
    int chart = int(vPiece + 0.5);
    gl_FragColor = vec4(vec3(chart & 255, (chart >> 8) & 255, chart >> 16) / 255.0, 1.0);
  }
`;

interface Frame {
  width: number;
  height: number;
}

/** Finds the chart at a pixel by drawing the charts' numbers into a picture of that pixel alone. */
export class ChartPicker {
  private readonly target = new WebGLRenderTarget(1, 1);
  private readonly bytes = new Uint8Array(4);
  readonly material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    blending: NoBlending,
    uniforms: { flags: { value: null } },
  });

  /** Without `depthTest` the triangle that is drawn last counts. */
  constructor(
    private readonly renderer: WebGLRenderer,
    depthTest: boolean,
  ) {
    this.material.depthTest = depthTest;
    this.material.depthWrite = depthTest;
  }

  chartAt(
    { x, y }: Pixel,
    object: Mesh,
    camera: PerspectiveCamera | OrthographicCamera,
    { width, height }: Frame,
  ): number | null {
    const { renderer } = this;
    const [color, alpha] = [renderer.getClearColor(new Color()), renderer.getClearAlpha()];
    const painted = object.material;
    camera.setViewOffset(width, height, Math.floor(x), Math.floor(y), 1, 1);
    object.material = this.material;
    renderer.setClearColor(0, 0);
    renderer.setRenderTarget(this.target);
    renderer.render(object, camera);
    renderer.readRenderTargetPixels(this.target, 0, 0, 1, 1, this.bytes);
    renderer.setRenderTarget(null);
    renderer.setClearColor(color, alpha);
    object.material = painted;
    camera.clearViewOffset();
    const [red, green, blue, isHit] = this.bytes;
    return isHit > 0 ? red + 256 * (green + 256 * blue) : null;
  }
}
