import { MOUSE, type PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Direction } from '../drawing/front';
import type { FirstView } from '../model/drawing';
import { fitInView } from './fit-in-view';
import { type Pixel, pixelOn } from './sight';

/** Fraction of the view's width or height that a fitted mesh fills. */
const FILLED = 0.88;
/** Radians per key press, and zoom factor. */
const TURN = Math.PI / 24;
const ZOOM = 1.15;
/** Seen from above or below, y is still slightly up. */
const ABOVE = 1e-3;
/** The sides that digits look from. With Ctrl, it is the opposite side. */
const SIDES: Record<string, Direction> = { 1: [0, 0, 1], 3: [1, 0, 0], 7: [0, 1, ABOVE] };
/** Degrees. In the narrow field of view, what is far away is as large as what is near. */
export const FIELD_OF_VIEW = 32;
const NARROW = 0.5;
/** How near and far the eye gets to what it looks at, in the wide field of view. */
const NEAREST = 1e-3;
const FARTHEST = 30;
/** What is nearer to the eye than this share of the distance that it looks at is not drawn. */
const CLIPPED = 0.01;
/** How far in front of and behind the middle of the unit sphere, which holds the mesh, things are drawn: marks lie in front of it by a share of that. */
const IN_FRONT = 40;
const BEHIND = 1.1;

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
    /** How far away from the eye, along its axis, the mesh is at a pixel; null: it is not there. */
    private readonly depthAt: (at: Pixel) => number | null,
  ) {
    // Before the controls zoom.
    canvas.addEventListener('wheel', (event) => this.aimAt(pixelOn(canvas, event)));
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.mouseButtons.MIDDLE = MOUSE.ROTATE;
    this.controls.zoomToCursor = true;
    this.controls.enableDamping = !reducedMotion;
    this.controls.dampingFactor = 0.12;
    this.widen(FIELD_OF_VIEW);
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
    this.lookFrom([-x, y, -z], false);
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
    this.clip();
  }

  /** Draws all of the mesh, and keeps what is small apart however near the eye comes to it. */
  private clip(): void {
    const { camera } = this;
    const eye = camera.position.length();
    const clipped = CLIPPED * Math.min(1, this.controls.getDistance());
    camera.near = Math.max(eye - IN_FRONT, clipped);
    camera.far = eye + BEHIND;
    camera.updateProjectionMatrix();
  }

  /** Zooming approaches what is under the pointer, and never passes it. */
  private aimAt(at: Pixel): void {
    const depth = this.depthAt(at);
    if (depth === null) return;
    const { position } = this.camera;
    const { target } = this.controls;
    target.sub(position).setLength(depth).add(position);
  }

  /** Changes the field of view; what is looked at keeps its size. */
  private widen(degrees: number): void {
    const { camera, controls } = this;
    const nearer = slope(camera.fov) / slope(degrees);
    camera.fov = degrees;
    camera.position.sub(controls.target).multiplyScalar(nearer).add(controls.target);
    const scale = slope(FIELD_OF_VIEW) / slope(degrees);
    controls.minDistance = NEAREST * scale;
    controls.maxDistance = FARTHEST * scale;
    controls.update();
  }

  private lookFrom([x, y, z]: Direction, isOpposite: boolean): void {
    // From below as from above, x points to the right.
    const direction: Direction = isOpposite ? [-x, -y, y ? z : -z] : [x, y, z];
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
    const up = slope(this.camera.fov) * FILLED;
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
      '5': () => this.toggleWide(),
      '9': () => this.turnRound(),
    };
    // Without Num Lock, digits of the number pad have other names.
    const isPad = event.location === KeyboardEvent.DOM_KEY_LOCATION_NUMPAD;
    const digit = event.code.slice(-1);
    const key = isPad && (digit in SIDES || digit in actions) ? digit : event.key;
    const side = SIDES[key];
    const isCtrl = event.ctrlKey || event.metaKey;
    const action = side ? () => this.lookFrom(side, isCtrl) : !isCtrl && actions[key];
    if (!action || event.altKey || (isCtrl && event.shiftKey)) return;
    event.preventDefault();
    action();
  }

  private toggleWide(): void {
    this.widen(this.camera.fov === NARROW ? FIELD_OF_VIEW : NARROW);
    // A mesh that is fitted is fitted as it looks now.
    if (this.isFitted) this.fit(this.from);
    this.moved();
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

/** Half the height that a field of view shows at distance 1. */
const slope = (degrees: number) => Math.tan((degrees * Math.PI) / 360);
