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

/** A pixel holds numbers up to this one. */
const DEEPEST = 0xffffff;

const FRAGMENT = /* glsl */ `
  ${FLAGS_GLSL}
  uniform bool isDepth;
  flat varying float vPiece;
  void main() {
    if (flagsOf(vPiece).r > 0.5) discard;
    int n = int(isDepth ? ${DEEPEST}.0 * gl_FragCoord.z : vPiece + 0.5);
    gl_FragColor = vec4(vec3(n & 255, (n >> 8) & 255, n >> 16) / 255.0, 1.0);
  }
`;

type Place = [
  at: Pixel,
  object: Mesh,
  camera: PerspectiveCamera | OrthographicCamera,
  frame: { width: number; height: number },
];

/** Finds what is at a pixel by drawing numbers into a picture of that pixel alone. */
export class ChartPicker {
  private readonly target = new WebGLRenderTarget(1, 1);
  private readonly bytes = new Uint8Array(4);
  readonly material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    blending: NoBlending,
    uniforms: { flags: { value: null }, isDepth: { value: false } },
  });

  /** Without `depthTest` the triangle that is drawn last counts. */
  constructor(
    private readonly renderer: WebGLRenderer,
    depthTest: boolean,
  ) {
    this.material.depthTest = depthTest;
    this.material.depthWrite = depthTest;
  }

  chartAt(...where: Place): number | null {
    return this.numberAt(...where);
  }

  /** 0 at the near plane of the camera, 1 at the far one. */
  depthAt(...where: Place): number | null {
    const { isDepth } = this.material.uniforms;
    isDepth.value = true;
    const depth = this.numberAt(...where);
    isDepth.value = false;
    return depth === null ? null : depth / DEEPEST;
  }

  private numberAt(...[{ x, y }, object, camera, { width, height }]: Place): number | null {
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
