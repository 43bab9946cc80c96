// Runs in the browser: draws a mesh with its seams from four sides and from above, beside its
// layout.

import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  OrthographicCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

/**
 * Places in the sheet, and the directions from which the mesh is seen: degrees around it, and above
 * it. Alternately from above and from below.
 */
const VIEWS = [
  { column: 1, row: 0, around: 0, above: 15 },
  { column: 2, row: 0, around: 90, above: -12 },
  { column: 2, row: 1, around: 180, above: 15 },
  { column: 1, row: 1, around: 270, above: -12 },
  { column: 0, row: 1, around: 20, above: 70 },
];
const LAYOUT = { column: 0, row: 0 };
const COLUMNS = 3;
const ROWS = 2;

const SEAM = 0xd00000;
const BOUNDARY = 0x0040d0;
const OUTLINE = 0x202020;
/** In pixels. */
const LINE_WIDTH = 2.5;
/**
 * Fraction of the mesh's size by which lines are moved closer, so that the surface does not hide
 * them.
 */
const LIFT = 0.004;
/** Degrees of hue from one chart to the next: a few charts never look alike. */
const HUE_STEP = 137.508;

/** Triangles of three points each, in their charts' colours. */
function surfaceOf(points, charts, material) {
  const geometry = new BufferGeometry();
  const colors = new Float32Array(points.length);
  for (const [f, chart] of charts.entries()) {
    const color = new Color().setHSL(((chart * HUE_STEP) % 360) / 360, 0.55, 0.8);
    for (let i = 0; i < 3; i++) color.toArray(colors, 9 * f + 3 * i);
  }
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(points), 3));
  geometry.setAttribute('color', new BufferAttribute(colors, 3));
  geometry.computeVertexNormals();
  return new Mesh(geometry, material);
}

function linesOf(points, color, size) {
  const material = new LineMaterial({ color, linewidth: LINE_WIDTH });
  material.resolution.set(size, size);
  return new LineSegments2(new LineSegmentsGeometry().setPositions(points), material);
}

function layoutScene({ uv, charts, outline }, size) {
  const scene = new Scene();
  scene.add(surfaceOf(uv, charts, new MeshBasicMaterial({ vertexColors: true, side: DoubleSide })));
  scene.add(linesOf(outline, OUTLINE, size));
  const camera = new OrthographicCamera(-0.02, 1.02, 1.02, -0.02, 0.1, 10);
  camera.position.z = 2;
  return { scene, camera };
}

/** The mesh around the origin, scaled to the size of a ball of radius 1. */
function meshScene({ xyz, charts, seams, boundary, middle, radius }, size) {
  const group = new Group();
  const material = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide });
  group.add(surfaceOf(xyz, charts, material));
  const lines = [];
  if (seams.length > 0) lines.push(linesOf(seams, SEAM, size));
  if (boundary.length > 0) lines.push(linesOf(boundary, BOUNDARY, size));
  group.add(...lines);
  group.scale.setScalar(1 / radius);
  group.position.set(...middle.map((x) => -x / radius));
  const light = new DirectionalLight(0xffffff, 2);
  const scene = new Scene();
  scene.add(group, light, new AmbientLight(0xffffff, 1));
  const camera = new OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
  const lookFrom = ({ around, above }) => {
    const [a, b] = [around, above].map((degrees) => (degrees * Math.PI) / 180);
    camera.position.set(Math.sin(a) * Math.cos(b), Math.sin(b), Math.cos(a) * Math.cos(b));
    light.position.copy(camera.position);
    for (const line of lines) line.position.copy(camera.position).multiplyScalar(LIFT * radius);
    camera.position.multiplyScalar(3);
    camera.lookAt(0, 0, 0);
  };
  return { scene, camera, lookFrom };
}

/** Draws the sheet as a PNG in a data URI, with parts of `size` pixels. */
window.drawSheet = (sheet, size) => {
  const renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(COLUMNS * size, ROWS * size);
  renderer.setClearColor(0xffffff);
  renderer.setScissorTest(true);
  const draw = ({ column, row }, { scene, camera }) => {
    const place = [column * size, (ROWS - 1 - row) * size, size, size];
    renderer.setViewport(...place);
    renderer.setScissor(...place);
    renderer.render(scene, camera);
  };
  draw(LAYOUT, layoutScene(sheet, size));
  const mesh = meshScene(sheet, size);
  for (const view of VIEWS) {
    mesh.lookFrom(view);
    draw(view, mesh);
  }
  const picture = renderer.domElement.toDataURL('image/png');
  renderer.dispose();
  renderer.forceContextLoss();
  return picture;
};
