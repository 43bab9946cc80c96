import { PerspectiveCamera, type Texture } from 'three';
import type { Palette } from '../colors/palette';
import { frontOf } from '../drawing/front';
import { facingOf } from '../mesh/mesh';
import type { Appearance } from '../model/appearance';
import { type Drawing, type FlatDrawing, FRAME } from '../model/drawing';
import { define } from './define';
import { FIELD_OF_VIEW, Orbit } from './orbit';
import { type SeamMarks, SeamOverlay } from './seam-overlay';
import { isMeasure, type Shading } from './shading';
import { type Pixel, Sight } from './sight';
import { createSurfaceMaterial, paintSurface, SurfacePaint } from './surface-material';
import { SurfaceScene } from './surface-scene';

/** The mesh in 3D. */
export class MeshView {
  /** Resolves when pictures can be drawn without waiting for shaders. */
  readonly ready: Promise<void>;
  readonly surface: SurfaceScene;
  readonly orbit: Orbit;
  private readonly camera = new PerspectiveCamera(FIELD_OF_VIEW);
  private readonly material = createSurfaceMaterial();
  private readonly seams: SeamOverlay;
  /** `FRAME` of each shown chart. */
  private frames: Float32Array = new Float32Array();
  private isFlat = false;
  private wireOpacity = 0.5;
  private showsWireframe = false;

  constructor(
    readonly canvas: HTMLCanvasElement,
    reducedMotion: boolean,
  ) {
    this.surface = new SurfaceScene(
      canvas,
      {
        material: this.material,
        attributes: ['position', 'normal', 'uv'],
        camera: this.camera,
        depthTest: true,
        outline: 1.75,
      },
      {
        prepare: () => this.orbit.advance(),
        resized: ({ width, height, pixelRatio }) => {
          this.seams.setSize(width, height, pixelRatio);
          this.orbit.resize(width, height);
        },
      },
    );
    this.orbit = new Orbit(
      this.camera,
      canvas,
      reducedMotion,
      () => this.surface.invalidate(),
      (at) => this.distanceAt(at),
    );
    this.seams = new SeamOverlay();
    this.surface.scene.add(this.seams.object);
    this.ready = this.surface.start();
  }

  /**
   * Shows a mesh, with a checkerboard or its charts if it is flattened. Keeps the point of view
   * unless the mesh was just opened.
   */
  show(drawing: Drawing | FlatDrawing): void {
    const { mesh } = drawing;
    const flat = 'marks' in drawing ? drawing : null;
    const { position, normal, uv } = mesh;
    this.surface.triangles.show({ position, normal, ...(uv && { uv }), ...flat?.marks }, () => {
      this.isFlat = flat !== null;
      this.surface.showMarks(mesh, flat);
      if (mesh.cells) {
        this.material.uniforms.uvOrigin.value.set(...mesh.cells.origin);
        this.material.uniforms.uvCell.value = mesh.cells.cell;
      }
      this.setUniforms();
    });
    this.frames = mesh.frames;
    this.surface.invalidate();
    if (mesh.first) this.orbit.open(mesh.first);
  }

  /** What the camera sees now. */
  get sight(): Sight {
    const { width, height } = this.surface.stage;
    return new Sight(this.camera, width, height);
  }

  /** `points` has xyz per vertex, in the unit sphere. */
  markSeams(points: Float32Array, marks: SeamMarks): void {
    if (this.seams.show(points, marks)) this.surface.invalidate();
  }

  setPalette(palette: Palette): void {
    this.surface.setPalette(palette);
    paintSurface(this.material, palette);
    this.seams.setPalette(palette);
    this.wireOpacity = palette.wireOpacity;
    this.paint();
  }

  setWireframe(shows: boolean): void {
    this.showsWireframe = shows;
    define(this.material, 'WIRE', shows);
    this.paint();
  }

  /** `picture`: what a shading needs that shows one. */
  setShading(shading: Shading, picture: Texture | null): void {
    this.surface.setShading(shading, picture);
    this.paint();
  }

  /** How the mesh looks in its file; null if that is not known. */
  setAppearance(appearance: Appearance | null): void {
    this.surface.setAppearance(appearance);
    this.paint();
  }

  /** How far along the axis of the view the mesh is at a pixel; null if it is not there. */
  private distanceAt(at: Pixel): number | null {
    const depth = this.surface.depthAt(at);
    const { near, far } = this.camera;
    return depth === null ? null : (near * far) / (far - depth * (far - near));
  }

  /** The chart at a pixel; null if there is none. */
  chartAt(at: Pixel): number | null {
    return this.isFlat ? this.surface.chartAt(at) : null;
  }

  /** Turns the view to some charts. */
  goTo(charts: number[]): void {
    const frame = unionOf(this.frames, charts);
    if (!(frame[FRAME.low] <= frame[FRAME.high])) return;
    const area = frame.subarray(FRAME.area, FRAME.area + 3);
    const direction = frontOf(facingOf(area, frame[FRAME.total]), this.orbit.direction);
    this.orbit.goTo({ points: cornersOf(frame), direction });
  }

  private paint(): void {
    this.setUniforms();
    this.surface.invalidate();
  }

  private setUniforms(): void {
    this.material.uniforms.paint.value = this.isFlat ? this.paintOfLayout : this.paintOfMesh;
    this.material.uniforms.wire.value = this.showsWireframe ? this.wireOpacity : 0;
  }

  private get paintOfLayout(): SurfacePaint {
    const { shading, isAtlas } = this.surface;
    if (isMeasure(shading)) return SurfacePaint.Heat;
    if (shading === 'grid' || shading === 'image') return SurfacePaint.Picture;
    return this.paintOfMesh || (isAtlas ? SurfacePaint.Charts : SurfacePaint.Checker);
  }

  private get paintOfMesh(): SurfacePaint {
    return this.surface.showsMaterials ? SurfacePaint.Materials : SurfacePaint.Clay;
  }
}

/** The `FRAME` of some charts together. */
function unionOf(frames: Float32Array, charts: number[]): Float32Array {
  const union = new Float32Array(FRAME.size);
  union.fill(Infinity, FRAME.low, FRAME.low + 3);
  union.fill(-Infinity, FRAME.high, FRAME.high + 3);
  for (const chart of charts) {
    const frame = frames.subarray(FRAME.size * chart, FRAME.size * (chart + 1));
    for (let d = 0; d < 3; ++d) {
      union[FRAME.low + d] = Math.min(union[FRAME.low + d], frame[FRAME.low + d]);
      union[FRAME.high + d] = Math.max(union[FRAME.high + d], frame[FRAME.high + d]);
      union[FRAME.area + d] += frame[FRAME.area + d];
    }
    union[FRAME.total] += frame[FRAME.total];
  }
  return union;
}

/** The corners of a chart's box, xyz each. */
function cornersOf(frame: Float32Array): Float32Array {
  return Float32Array.from({ length: 24 }, (_, i) => {
    const [corner, d] = [Math.floor(i / 3), i % 3];
    return frame[((corner >> d) & 1 ? FRAME.high : FRAME.low) + d];
  });
}
