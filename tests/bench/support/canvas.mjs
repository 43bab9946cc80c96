// Draws triangles and lines with a depth buffer, in memory.

import { encodedPng } from '../../support/made-png.mjs';

/** Colours are [red, green, blue] from 0 to 255; x to the right, y downwards, larger z is nearer. */
export class Canvas {
  constructor(width, height, background = [255, 255, 255]) {
    this.width = width;
    this.height = height;
    this.pixels = Buffer.alloc(4 * width * height, Buffer.from([...background, 255]));
    this.depth = new Float64Array(width * height).fill(-Infinity);
  }

  #set(x, y, z, [red, green, blue]) {
    if (x < 0 || y < 0 || x >= this.width || y >= this.height) return;
    const i = y * this.width + x;
    if (z < this.depth[i]) return;
    this.depth[i] = z;
    this.pixels[4 * i] = red;
    this.pixels[4 * i + 1] = green;
    this.pixels[4 * i + 2] = blue;
  }

  /** Points are [x, y, z]; what is as near as what is there goes over it. */
  triangle([a, b, c], color) {
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area === 0) return;
    const [low, high] = [Math.min, Math.max].map((pick) =>
      [0, 1].map((d) => pick(a[d], b[d], c[d])),
    );
    const [left, top] = low.map((x) => Math.max(0, Math.floor(x)));
    const right = Math.min(this.width - 1, Math.ceil(high[0]));
    const bottom = Math.min(this.height - 1, Math.ceil(high[1]));
    for (let y = top; y <= bottom; y++)
      for (let x = left; x <= right; x++) {
        const [px, py] = [x + 0.5, y + 0.5];
        const u = ((b[0] - px) * (c[1] - py) - (b[1] - py) * (c[0] - px)) / area;
        const v = ((c[0] - px) * (a[1] - py) - (c[1] - py) * (a[0] - px)) / area;
        const w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0) continue;
        this.#set(x, y, u * a[2] + v * b[2] + w * c[2], color);
      }
  }

  line([a, b], color, width = 1) {
    const steps = Math.max(1, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1])));
    const half = (width - 1) / 2;
    for (let k = 0; k <= steps; k++) {
      const [x, y, z] = a.map((p, d) => p + ((b[d] - p) * k) / steps);
      for (let i = 0; i < width; i++)
        for (let j = 0; j < width; j++)
          this.#set(Math.floor(x - half + i), Math.floor(y - half + j), z, color);
    }
  }

  /** Half the size: each pixel the mean of four. */
  halved() {
    const out = new Canvas(this.width >> 1, this.height >> 1);
    const row = 4 * this.width;
    for (let y = 0; y < out.height; y++)
      for (let x = 0; x < out.width; x++)
        for (let k = 0; k < 3; k++) {
          const i = 2 * y * row + 8 * x + k;
          const sum =
            this.pixels[i] + this.pixels[i + 4] + this.pixels[i + row] + this.pixels[i + row + 4];
          out.pixels[4 * (y * out.width + x) + k] = (sum + 2) >> 2;
        }
    return out;
  }

  paste(other, left, top) {
    for (let y = 0; y < other.height; y++) {
      const from = 4 * y * other.width;
      const line = other.pixels.subarray(from, from + 4 * other.width);
      line.copy(this.pixels, 4 * ((top + y) * this.width + left));
    }
  }

  png() {
    return encodedPng(this.width, this.height, this.pixels);
  }
}

/** Five rows of three points for each character, as digits from 0 to 7. */
const GLYPHS = {
  ...{ a: '25755', b: '65656', c: '34443', d: '65556', e: '74647', f: '74644', g: '34553' },
  ...{ h: '55755', i: '72227', j: '11152', k: '55655', l: '44447', m: '57755', n: '65555' },
  ...{ o: '25552', p: '65644', q: '25573', r: '65655', s: '34216', t: '72222', u: '55557' },
  ...{ v: '55552', w: '55775', x: '55255', y: '55222', z: '71247' },
  ...{ 0: '75557', 1: '26227', 2: '61247', 3: '61216', 4: '55711', 5: '74616', 6: '34757' },
  ...{ 7: '71122', 8: '75757', 9: '75716' },
  ...{ ':': '02020', '.': '00002', ',': '00024', '-': '00700', _: '00007', '+': '02720' },
};

/** Small capitals; `size` pixels for a point of the font. */
export function write(canvas, text, left, top, color = [0, 0, 0], size = 2) {
  for (const [n, letter] of [...text.toLowerCase()].entries())
    for (const [row, bits] of [...(GLYPHS[letter] ?? '')].entries())
      for (let column = 0; column < 3; column++) {
        if (((Number(bits) >> (2 - column)) & 1) === 0) continue;
        const [x, y] = [left + (4 * n + column) * size, top + row * size];
        for (let k = 0; k < size; k++)
          canvas.line(
            [
              [x, y + k, Infinity],
              [x + size - 1, y + k, Infinity],
            ],
            color,
          );
      }
}
