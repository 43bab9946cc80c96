import {
  BufferAttribute,
  BufferGeometry,
  Mesh,
  PerspectiveCamera,
  Scene,
  Spherical,
  Vector3,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { checkerCells } from './checker';
import { EdgeLines } from './edge-lines';
import { fitInView } from './fit-in-view';
import type { DisplayMesh } from './mesh';
import { facing, perCorner, toCorners, vertexNormals } from './mesh';
import type { Palette } from './palette';
import type { FlatPicture, Picture } from './picture';
import { DOT, PointMarks } from './point-marks';
import { type SeamMarks, SeamOverlay } from './seams/seam-overlay';
import { Sight } from './seams/sight';
import { Stage } from './stage';
import { createSurfaceMaterial, NONE_LIT, paintSurface, SurfacePaint } from './surface-material';
import { toUnitSphere } from './unit-sphere';

const FIELD_OF_VIEW = 32;
/** Share of the view's width or height that a fitted mesh takes. */
const FILLED = 0.88;
/** Radians per key press, and zoom factor. */
const TURN = Math.PI / 24;
const ZOOM = 1.15;
/** A surface that faces one way as clearly as this is first seen from there. */
const CLEAR_FACING = 0.4;
/** Where others are first seen from, and the steepest first look at a surface that faces up or down. */
const USUAL_FRONT = new Vector3(0.42, 0.2, 1).normalize();
const STEEPEST = (40 * Math.PI) / 180;
/** A surface that faces mostly up or down, such as a car without its floor, has its front where others have it. */
const LEVEL = 0.6;
const USUAL_AROUND = Math.PI / 7;

/** The mesh in 3D. */
export class MeshView {
  private readonly stage: Stage;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
  private readonly controls: OrbitControls;
  private readonly material = createSurfaceMaterial();
  private readonly surface = new Mesh(new BufferGeometry(), this.material);
  private readonly boundary = new EdgeLines(1.75, true);
  private readonly dots = new PointMarks({ ...DOT, depthTest: true });
  private readonly seams = new SeamOverlay();
  /** The chart of each shown triangle. */
  private pieces = new Float32Array();
  private front = new Vector3(0, 0, 1);
  /** Corners of the shown triangles, within the unit sphere. */
  private corners: Float32Array = new Float32Array();
  /** Until the user turns or zooms, the mesh stays fitted whatever happens to the pane. */
  private isFitted = true;
  private isFlat = false;
  private flatPaint: SurfacePaint = SurfacePaint.Checker;
  private showsDistortion = false;
  private wireOpacity = 0.5;
  private showsWireframe = false;

  constructor(
    readonly canvas: HTMLCanvasElement,
    reducedMotion: boolean,
  ) {
    this.stage = new Stage(
      canvas,
      () => this.draw(),
      () => this.resized(),
    );
    this.surface.frustumCulled = false;
    this.scene.add(this.surface, this.boundary.object, this.dots.object, this.seams.object);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = !reducedMotion;
    this.controls.dampingFactor = 0.12;
    this.controls.minDistance = 0.4;
    this.controls.maxDistance = 30;
    this.controls.addEventListener('change', () => this.stage.invalidate());
    this.controls.addEventListener('start', () => {
      this.isFitted = false;
    });
    canvas.addEventListener('keydown', (event) => this.onKey(event));
    this.stage.resize();
  }

  /** Shows a mesh, with a checkerboard when it is flattened. Keeps the point of view unless `isNew`. */
  show(picture: Picture | FlatPicture, isNew: boolean): void {
    const { mesh, edges, normals = vertexNormals(mesh) } = picture;
    const flat = 'errors' in picture ? picture : null;
    const geometry = new BufferGeometry();
    const unit = toUnitSphere(mesh);
    this.corners = perCorner(unit, 3, mesh.indices);
    geometry.setAttribute('position', new BufferAttribute(this.corners, 3));
    geometry.setAttribute('normal', new BufferAttribute(perCorner(normals, 3, mesh.indices), 3));
    const cells = flat ? checkerCells(flat.mesh) : new Float32Array((2 * unit.length) / 3);
    geometry.setAttribute('uv', new BufferAttribute(perCorner(cells, 2, mesh.indices), 2));
    const perTriangle = flat?.errors ?? new Float32Array(mesh.indices.length / 3);
    geometry.setAttribute('error', new BufferAttribute(toCorners(perTriangle), 1));
    const charts = flat?.chartColors ?? new Float32Array(perTriangle.length);
    geometry.setAttribute('chart', new BufferAttribute(toCorners(charts), 1));
    this.pieces = Float32Array.from(flat?.charts ?? charts);
    geometry.setAttribute('piece', new BufferAttribute(toCorners(this.pieces), 1));
    this.surface.geometry.dispose();
    this.surface.geometry = geometry;
    this.boundary.show(unit, edges);
    this.dots.show(perCorner(unit, 3, flat?.tightened ?? new Uint32Array()));
    this.flatPaint = flat?.chartColors ? SurfacePaint.Charts : SurfacePaint.Checker;
    this.isFlat = flat !== null;
    this.paint();
    if (!isNew) return;
    this.front = frontOf(mesh, USUAL_FRONT);
    this.reset();
  }

  /** What the camera sees now. */
  get sight(): Sight {
    return new Sight(this.camera, this.stage.width, this.stage.height);
  }

  /** `turned` is called when the point of view has changed. */
  onTurn(turned: () => void): void {
    this.controls.addEventListener('change', turned);
  }

  /** `points` has xyz per vertex, in the unit sphere. */
  markSeams(points: Float32Array, marks: SeamMarks): void {
    this.seams.show(points, marks);
    this.stage.invalidate();
  }

  setPalette(palette: Palette): void {
    this.stage.renderer.setClearColor(palette.background);
    paintSurface(this.material, palette);
    this.boundary.setColor(palette.boundary);
    this.dots.setColor(palette.tightened);
    this.seams.setPalette(palette);
    this.wireOpacity = palette.wireOpacity;
    this.paint();
  }

  setWireframe(shows: boolean): void {
    this.showsWireframe = shows;
    this.paint();
  }

  setDistortion(shows: boolean): void {
    this.showsDistortion = shows;
    this.paint();
  }

  /** Shows one chart clearer than the others; null: all alike. */
  light(chart: number | null): void {
    this.material.uniforms.lit.value = chart ?? NONE_LIT;
    this.stage.invalidate();
  }

  /** Looks at one chart. */
  goTo(chart: number): void {
    const part = partOf(this.corners, this.pieces, chart);
    const positions = Float64Array.from(part);
    const indices = Uint32Array.from({ length: part.length / 3 }, (_, v) => v);
    const now = this.camera.position.clone().sub(this.controls.target).normalize();
    this.look(part, frontOf({ positions, indices }, now));
    this.isFitted = false;
  }

  reset(): void {
    this.look(this.corners, this.front);
    this.isFitted = true;
  }

  /** `front`: from the points (xyz each) to the eye. */
  private look(points: Float32Array, front: Vector3): void {
    this.stopDamping();
    const up = Math.tan((this.camera.fov * Math.PI) / 360) * FILLED;
    const { target, distance } = fitInView(points, front, up * this.camera.aspect, up);
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(front, distance);
    this.controls.update();
    this.stage.invalidate();
  }

  /** Ends a motion that is dying down: without damping an update uses up all of it. */
  private stopDamping(): void {
    const { enableDamping } = this.controls;
    this.controls.enableDamping = false;
    this.controls.update();
    this.controls.enableDamping = enableDamping;
  }

  private paint(): void {
    const flatPaint = this.showsDistortion ? SurfacePaint.Distortion : this.flatPaint;
    this.material.uniforms.paint.value = this.isFlat ? flatPaint : SurfacePaint.Clay;
    this.material.uniforms.wire.value = this.showsWireframe ? this.wireOpacity : 0;
    this.stage.invalidate();
  }

  private resized(): void {
    this.camera.aspect = this.stage.width / this.stage.height;
    this.camera.updateProjectionMatrix();
    this.material.uniforms.pixelRatio.value = this.stage.pixelRatio;
    this.dots.setPixelRatio(this.stage.pixelRatio);
    this.boundary.setResolution(this.stage.width, this.stage.height);
    this.seams.setSize(this.stage.width, this.stage.height, this.stage.pixelRatio);
    if (this.isFitted) this.reset();
  }

  private draw(): void {
    // With damping, update() moves on and asks for the next frame through its change event.
    this.controls?.update();
    this.stage?.renderer.render(this.scene, this.camera);
  }

  private onKey(event: KeyboardEvent): void {
    const turn = (theta: number, phi: number) => this.turn(theta, phi, 1);
    const actions: Record<string, () => void> = {
      ArrowLeft: () => turn(-TURN, 0),
      ArrowRight: () => turn(TURN, 0),
      ArrowUp: () => turn(0, -TURN),
      ArrowDown: () => turn(0, TURN),
      '+': () => this.turn(0, 0, 1 / ZOOM),
      '=': () => this.turn(0, 0, 1 / ZOOM),
      '-': () => this.turn(0, 0, ZOOM),
      Home: () => this.reset(),
      '0': () => this.reset(),
    };
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  }

  private turn(theta: number, phi: number, zoom: number): void {
    this.isFitted = false;
    const offset = this.camera.position.clone().sub(this.controls.target);
    const spherical = new Spherical().setFromVector3(offset);
    spherical.theta += theta;
    spherical.phi += phi;
    spherical.radius *= zoom;
    offset.setFromSpherical(spherical.makeSafe());
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.stage.invalidate();
  }
}

/** Unit vector from the mesh to the point from which it is first seen, `otherwise` where it faces nowhere; y is up. */
function frontOf(mesh: DisplayMesh, otherwise: Vector3): Vector3 {
  const { direction, clarity } = facing(mesh);
  if (clarity < CLEAR_FACING) return otherwise;
  const [x, y, z] = direction;
  const elevation = Math.asin(Math.min(1, Math.max(-1, y)));
  const around = Math.hypot(x, z) > LEVEL ? Math.atan2(x, z) : USUAL_AROUND;
  const polar = Math.PI / 2 - Math.min(STEEPEST, Math.max(-STEEPEST, elevation));
  return new Vector3().setFromSphericalCoords(1, polar, around);
}

/** The corners (xyz each) of one chart's triangles. */
function partOf(corners: Float32Array, pieces: Float32Array, chart: number): Float32Array {
  const part: number[] = [];
  pieces.forEach((piece, f) => {
    if (piece === chart) for (let i = 9 * f; i < 9 * f + 9; ++i) part.push(corners[i]);
  });
  return Float32Array.from(part);
}
