import { BufferAttribute, BufferGeometry, Mesh, ShaderMaterial } from 'three';
import { tileAt } from '../mesh/tiles';

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

/**
 * The squares of all tiles, below the charts; hidden at first. `fragmentShader` has `vPoint`, which
 * runs from 0 to 1 in each tile; `layout`: the material of the charts, whose plane it shares.
 */
export function tileSheet(
  layout: ShaderMaterial,
  fragmentShader: string,
  uniforms: ShaderMaterial['uniforms'],
): Mesh<BufferGeometry, ShaderMaterial> {
  const { uvMiddle, uvUnit } = layout.uniforms;
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader,
    uniforms: { uvMiddle, uvUnit, ...uniforms },
    transparent: true,
    depthTest: false,
    depthWrite: false,
  });
  const sheet = new Mesh(tileSquares(1), material);
  sheet.frustumCulled = false;
  sheet.renderOrder = -1;
  sheet.visible = false;
  return sheet;
}

/** The geometry of such a sheet; a layout without tiles, which is in one piece, lies in the first one. */
export function tileSquares(tiles: number): BufferGeometry {
  const all = Array.from({ length: tiles || 1 }, (_, i) => tileAt(i));
  const points = all.flatMap(({ u, v }) => CORNERS.flatMap(([x, y]) => [u + x, v + y, 0]));
  const inTile = all.flatMap(() => CORNERS.flat());
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(points), 3));
  geometry.setAttribute('uv', new BufferAttribute(Float32Array.from(inTile), 2));
  return geometry;
}
