import { Matrix4, type PerspectiveCamera, Ray, Vector3 } from 'three';

export interface Pixel {
  x: number;
  y: number;
}

/** Where an event is on a canvas. */
export function pixelOn(canvas: HTMLElement, { clientX, clientY }: MouseEvent): Pixel {
  const { left, top } = canvas.getBoundingClientRect();
  return { x: clientX - left, y: clientY - top };
}

/**
 * What a camera sees on a canvas: maps points to css pixels from the upper left corner, and back.
 */
export class Sight {
  private readonly matrix: Matrix4;

  constructor(
    private readonly camera: PerspectiveCamera,
    private readonly width: number,
    private readonly height: number,
  ) {
    camera.updateMatrixWorld();
    this.matrix = new Matrix4().multiplyMatrices(
      camera.projectionMatrix,
      camera.matrixWorldInverse,
    );
  }

  /** The ray through a pixel. */
  ray({ x, y }: Pixel): Ray {
    const origin = new Vector3().setFromMatrixPosition(this.camera.matrixWorld);
    const [right, up] = [(2 * x) / this.width - 1, 1 - (2 * y) / this.height];
    const direction = new Vector3(right, up, -1).unproject(this.camera).sub(origin);
    return new Ray(origin, direction.normalize());
  }

  /** Where vertex `v` of `points` (xyz each) appears; null if it is behind the eye. */
  pixel(points: ArrayLike<number>, v: number): Pixel | null {
    const m = this.matrix.elements;
    const [x, y, z] = [points[3 * v], points[3 * v + 1], points[3 * v + 2]];
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    if (w <= 0) return null;
    return {
      x: (this.width / 2) * (1 + (m[0] * x + m[4] * y + m[8] * z + m[12]) / w),
      y: (this.height / 2) * (1 - (m[1] * x + m[5] * y + m[9] * z + m[13]) / w),
    };
  }
}
