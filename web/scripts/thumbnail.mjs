// A small picture of a mesh on nothing, for any theme.

/** Twice what the page shows, for sharp screens. */
const SIZE = { width: 224, height: 168 };
const FILLED = 0.92;

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => a.map((x, d) => x - b[d]);
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const unit = (a) => a.map((x) => x / (Math.hypot(...a) || 1));

/** The triangles from back to front, in the picture's pixels, each with how bright it is. */
export function trianglesFrom({ positions, indices }, eye) {
  const front = unit(eye);
  const right = unit([front[2], 0, -front[0]]);
  const top = cross(front, right);
  const light = unit([0, 1, 2].map((d) => front[d] + 0.7 * top[d] - 0.5 * right[d]));
  const point = (v) => [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
  const place = fit(
    Array.from({ length: positions.length / 3 }, (_, v) => point(v)),
    right,
    top,
  );
  const triangles = [];
  for (let c = 0; c < indices.length; c += 3) {
    const corners = [0, 1, 2].map((k) => point(indices[c + k]));
    const normal = unit(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0])));
    const facing = dot(normal, front) < 0 ? -1 : 1;
    const brightness = 0.42 + 0.58 * Math.max(0, facing * dot(normal, light));
    const depth = corners.reduce((sum, corner) => sum + dot(corner, front), 0);
    triangles.push({ triangle: c / 3, points: corners.map(place), brightness, depth });
  }
  return triangles.sort((a, b) => a.depth - b.depth);
}

/** From a point to its pixel. */
function fit(points, right, top) {
  const flat = points.map((point) => [dot(point, right), -dot(point, top)]);
  const range = (d) => [Math.min(...flat.map((p) => p[d])), Math.max(...flat.map((p) => p[d]))];
  const [[left, end], [high, low]] = [range(0), range(1)];
  const { width, height } = SIZE;
  const scale = FILLED * Math.min(width / (end - left), height / (low - high));
  return (point) => [
    width / 2 + scale * (dot(point, right) - (left + end) / 2),
    height / 2 + scale * (-dot(point, top) - (high + low) / 2),
  ];
}

function drawInPage({ size, triangles }) {
  const canvas = new OffscreenCanvas(size.width, size.height);
  const pen = canvas.getContext('2d');
  pen.lineJoin = 'round';
  for (const { points, color } of triangles) {
    pen.fillStyle = color;
    pen.strokeStyle = color;
    pen.beginPath();
    for (const [x, y] of points) pen.lineTo(x, y);
    pen.closePath();
    pen.fill();
    // No background between neighbours.
    pen.stroke();
  }
  return canvas
    .convertToBlob({ type: 'image/webp', quality: 0.65 })
    .then((blob) => blob.arrayBuffer())
    .then((buffer) => Array.from(new Uint8Array(buffer)));
}

/** As WebP. `colorOf`: red, green and blue of a triangle. */
export async function thumbnail(page, mesh, eye, colorOf) {
  const triangles = trianglesFrom(mesh, eye).map(({ triangle, points, brightness }) => ({
    points,
    color: `rgb(${colorOf(triangle).map((part) => Math.round(part * brightness))})`,
  }));
  return Uint8Array.from(await page.evaluate(drawInPage, { size: SIZE, triangles }));
}
