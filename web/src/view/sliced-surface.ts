import {
  BufferAttribute,
  BufferGeometry,
  GLBufferAttribute,
  InstancedBufferAttribute,
  type Material,
  Mesh,
  Sphere,
  type WebGLRenderer,
} from 'three';

/** How many numbers go to the graphics card at once. */
const SLICE = 1 << 17;
/** Milliseconds per frame for uploads: more would block the page. */
const UPLOADING = 8;

const SIZES = { position: 3, normal: 3, uv: 2, heat: 4, chart: 1, piece: 1, source: 1 };
/** What a layout marks on its triangles. */
export const MARKS = ['heat', 'chart', 'piece', 'source'] as const;

/** The arrays per corner of the triangles. */
export type SurfaceArrays = { position: Float32Array } & Partial<
  Record<keyof typeof SIZES, Float32Array>
>;

/** A geometry that is being uploaded to the graphics card. */
interface Arriving {
  arrays: SurfaceArrays;
  geometry: BufferGeometry;
  buffers: WebGLBuffer[];
  left: { buffer: WebGLBuffer; array: Float32Array; from: number }[];
  arrived: () => void;
}

/**
 * Triangles without an index. New ones are uploaded to the graphics card slice by slice and replace
 * the old ones once all of them are there.
 */
export class SlicedSurface {
  readonly object: Mesh;
  private readonly gl: WebGL2RenderingContext;
  private arriving: Arriving | null = null;
  private shown: SurfaceArrays | null = null;
  /**
   * In place of arrays that are not given, 0 at all corners: without, the browser would compile the
   * shader again once they are.
   */
  private readonly zeros: [string, InstancedBufferAttribute][];

  /** `attributes` lists all that will be used: the material is compiled for them. */
  constructor(renderer: WebGLRenderer, material: Material, attributes: (keyof typeof SIZES)[]) {
    this.gl = renderer.getContext() as WebGL2RenderingContext;
    const none = new BufferGeometry();
    for (const name of attributes)
      none.setAttribute(name, new BufferAttribute(new Float32Array(), SIZES[name]));
    this.zeros = attributes.map((name) => [
      name,
      new InstancedBufferAttribute(new Float32Array(SIZES[name]), SIZES[name]),
    ]);
    this.object = new Mesh(none, material);
    this.object.frustumCulled = false;
    renderer.domElement.addEventListener('webglcontextrestored', () => this.restore());
  }

  /** Whether there has never been anything to draw. */
  get isBlank(): boolean {
    return !this.shown && !this.arriving;
  }

  /** `arrived` is called in the frame that first shows the triangles. */
  show(arrays: SurfaceArrays, arrived: () => void): void {
    this.stop();
    const geometry = new BufferGeometry();
    geometry.boundingSphere = new Sphere(); // else the renderer loops over all corners to sort
    for (const [name, zero] of this.zeros) geometry.setAttribute(name, zero);
    const left: Arriving['left'] = [];
    for (const [name, size] of Object.entries(SIZES)) {
      const array = arrays[name as keyof SurfaceArrays];
      if (!array || array.length === 0) continue;
      const buffer = this.bufferOf(array);
      // The types do not allow such an attribute in a geometry, but it works.
      geometry.setAttribute(
        name,
        this.attributeOf(buffer, array, size) as unknown as BufferAttribute,
      );
      left.push({ buffer, array, from: 0 });
    }
    this.arriving = { arrays, geometry, buffers: left.map(({ buffer }) => buffer), left, arrived };
  }

  /** What has not arrived yet does not come. */
  stop(): void {
    for (const buffer of this.arriving?.buffers ?? []) this.gl.deleteBuffer(buffer);
    this.arriving = null;
  }

  /** Called before each frame. Returns whether everything has arrived. */
  advance(): boolean {
    const { arriving } = this;
    if (!arriving) return true;
    const end = performance.now() + UPLOADING;
    do {
      const [next] = arriving.left;
      if (!next) break;
      const slice = next.array.subarray(next.from, next.from + SLICE);
      this.gl.bindBuffer(this.gl.ARRAY_BUFFER, next.buffer);
      this.gl.bufferSubData(this.gl.ARRAY_BUFFER, next.array.BYTES_PER_ELEMENT * next.from, slice);
      next.from += slice.length;
      if (next.from === next.array.length) arriving.left.shift();
    } while (performance.now() < end);
    if (arriving.left.length > 0) return false;
    this.arriving = null;
    this.shown = arriving.arrays;
    this.object.geometry.dispose();
    this.object.geometry = arriving.geometry;
    arriving.arrived();
    return true;
  }

  private attributeOf(buffer: WebGLBuffer, array: Float32Array, size: number): GLBufferAttribute {
    const bytes = array.BYTES_PER_ELEMENT as 4;
    return new GLBufferAttribute(buffer, this.gl.FLOAT, size, bytes, array.length / size);
  }

  private bufferOf({ byteLength }: Float32Array): WebGLBuffer {
    const buffer = this.gl.createBuffer();
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, buffer);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, byteLength, this.gl.STATIC_DRAW);
    return buffer;
  }

  /** All buffers are lost with the context. */
  private restore(): void {
    const arrays = this.arriving?.arrays ?? this.shown;
    if (arrays) this.show(arrays, this.arriving?.arrived ?? (() => undefined));
  }
}
