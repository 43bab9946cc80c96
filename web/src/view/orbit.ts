import { type PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Direction } from '../drawing/front';
import type { FirstView } from '../model/drawing';
import { fitInView } from './fit-in-view';

/** Fraction of the view's width or height that a fitted mesh fills. */
const FILLED = 0.88;
/** Radians per key press, and zoom factor. */
const TURN = Math.PI / 24;
const ZOOM = 1.15;
/** Seen from above, y is still slightly up. */
const ABOVE = 1e-3;

/** A view of points (xyz each); `direction`: from them to the eye. */
interface Look {
  points: Float32Array;
  direction: Direction;
}

/** The point of view of the mesh, turned round it by drag, wheel, pinch and keys. */
export class Orbit {
  private readonly controls: OrbitControls;
  private first: FirstView = {
    front: [0, 0, 1],
    outline: new Float32Array(),
    hull: new Float32Array(),
  };
  /** The direction the mesh was last viewed from, and the points that had to fit in the view. */
  private from: Look = { direction: [0, 0, 1], points: new Float32Array() };
  /** Until the user turns or zooms, the mesh stays fitted however the pane changes. */
  private isFitted = true;

  constructor(
    private readonly camera: PerspectiveCamera,
    canvas: HTMLCanvasElement,
    reducedMotion: boolean,
    private readonly moved: () => void,
  ) {
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = !reducedMotion;
    this.controls.dampingFactor = 0.12;
    this.controls.minDistance = 0.4;
    this.controls.maxDistance = 30;
    this.onTurn(moved);
    this.controls.addEventListener('start', () => {
      this.isFitted = false;
    });
    canvas.addEventListener('keydown', (event) => this.onKey(event));
  }

  /** `turned` is called when the point of view has changed. */
  onTurn(turned: () => void): void {
    this.controls.addEventListener('change', turned);
  }

  /** Shows a mesh that was just opened. */
  open(first: FirstView): void {
    this.first = first;
    this.reset();
  }

  reset(): void {
    this.fit({ points: this.first.outline, direction: this.first.front });
  }

  /** Looks from the opposite side. */
  turnRound(): void {
    const [x, y, z] = this.direction;
    this.lookFrom([-x, y, -z]);
  }

  /** From the mesh to the eye. */
  get direction(): Direction {
    return this.camera.position.clone().sub(this.controls.target).normalize().toArray();
  }

  /** Shows a part of the mesh. */
  goTo(look: Look): void {
    this.look(look);
    this.isFitted = false;
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.isFitted) this.fit(this.from);
  }

  /** Called before each picture: continues a motion, and asks for the next picture while it lasts. */
  advance(): void {
    this.controls.update();
  }

  private lookFrom(direction: Direction): void {
    this.fit({ points: this.first.hull, direction });
  }

  private fit(from: Look): void {
    this.from = from;
    this.look(from);
    this.isFitted = true;
  }

  private look({ points, direction }: Look): void {
    this.stopDamping();
    const front = new Vector3(...direction);
    const up = Math.tan((this.camera.fov * Math.PI) / 360) * FILLED;
    const { target, distance } = fitInView(points, front, up * this.camera.aspect, up);
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(front, distance);
    this.controls.update();
    this.moved();
  }

  /** Ends a motion that is still dying down: without damping, one update uses up all of it. */
  private stopDamping(): void {
    const { enableDamping } = this.controls;
    this.controls.enableDamping = false;
    this.controls.update();
    this.controls.enableDamping = enableDamping;
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
      '1': () => this.lookFrom([0, 0, 1]),
      '3': () => this.lookFrom([1, 0, 0]),
      '7': () => this.lookFrom([0, 1, ABOVE]),
      '9': () => this.turnRound(),
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
    this.moved();
  }
}
