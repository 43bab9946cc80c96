import { BufferAttribute, BufferGeometry, Mesh, ShaderMaterial } from 'three';
import { tileAt } from '../mesh/tiles';
import { PICTURE_GLSL } from './uv-picture';

/** Two triangles. */
const CORNERS = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 0],
  [1, 1],
  [0, 1],
];

// Positions are in uv, `uv` counts from the corner of the tile.
const VERTEX = /* glsl */ `
  uniform vec2 uvMiddle;
  uniform float uvUnit;
  varying vec2 vPoint;
  void main() {
    vPoint = uv;
    vec2 place = (position.xy - uvMiddle) / uvUnit;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 0.0, 1.0);
  }
`;

const FRAGMENT = /* glsl */ `
  ${PICTURE_GLSL}
  varying vec2 vPoint;
  void main() {
    // Else the opposite side shines through at the border.
    vec2 border = 0.5 * max(1.0 / vec2(textureSize(picture, 0)), fwidth(vPoint));
    gl_FragColor = pictureColor(clamp(vPoint, border, 1.0 - border));
    #include <colorspace_fragment>
  }
`;

/** The picture in each tile, below the charts. */
export class PictureSheet {
  readonly object: Mesh;

  /** `layout`: the material of the charts, whose picture and plane it shares. */
  constructor({ uniforms: { picture, uvMiddle, uvUnit } }: ShaderMaterial) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { picture, uvMiddle, uvUnit },
      transparent: true,
      depthTest: false,
      depthWrite: false,
    });
    this.object = new Mesh(squares(1), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = -1;
    this.object.visible = false;
  }

  /** A layout without tiles, which is in one piece, lies in the first one. */
  show(tiles: number): void {
    this.object.geometry.dispose();
    this.object.geometry = squares(tiles || 1);
  }
}

function squares(tiles: number): BufferGeometry {
  const all = Array.from({ length: tiles }, (_, i) => tileAt(i));
  const points = all.flatMap(({ u, v }) => CORNERS.flatMap(([x, y]) => [u + x, v + y, 0]));
  const inTile = all.flatMap(() => CORNERS.flat());
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(points), 3));
  geometry.setAttribute('uv', new BufferAttribute(Float32Array.from(inTile), 2));
  return geometry;
}
