import { tileGrid } from '../mesh/tiles';
import { type AtlasShape, chartLines } from './chart-lines';

/** Units of the drawing along the side of a tile: coordinates are whole numbers. */
const SIDE = 100_000;
const INK = '#1b2430';

/** What is needed to draw a picture of an atlas. */
export interface AtlasDrawing extends AtlasShape {
  /** Texels along the side of a tile. */
  resolution: number;
  tiles: number;
  /** Texels per unit of length of the mesh. */
  texelDensity: number;
  /** The css colour of each chart. */
  colors: string[];
}

/** Lengths in the file and in the drawing. */
interface Size {
  side: number;
  unit: string;
  thin: number;
  thick: number;
}

/**
 * With `millimetres` per unit of the mesh, charts are as large as their surface; with `auto`, a
 * pixel is a texel.
 */
function sizeOf({ resolution, texelDensity }: AtlasDrawing, millimetres: number | 'auto'): Size {
  if (millimetres === 'auto' || !(texelDensity > 0)) {
    const pixel = SIDE / resolution;
    return { side: resolution, unit: '', thin: 0.5 * pixel, thick: 2 * pixel };
  }
  const side = (resolution / texelDensity) * millimetres;
  const mm = SIDE / side;
  // Lines must not be wider than tiny charts are.
  const most = SIDE / 100;
  return { side, unit: 'mm', thin: Math.min(0.1 * mm, most / 4), thick: Math.min(0.4 * mm, most) };
}

/** The atlas as an SVG file with one group per chart; v goes up. */
export function atlasSvg(drawing: AtlasDrawing, millimetres: number | 'auto'): string {
  const { uv, colors, tiles } = drawing;
  const [columns, rows] = tileGrid(tiles);
  const { side, unit, thin, thick } = sizeOf(drawing, millimetres);
  const path = (runs: number[][]) => runs.map((run) => pathOf(run, uv, rows)).join('');
  const groups = chartLines(drawing).map(({ outline, inner }, chart) => {
    const border = path(outline);
    const parts = [
      `<path class="area" d="${border}" fill="${colors[chart]}" stroke="none"/>`,
      ...(inner.length > 0
        ? [`<path class="edges" d="${path(inner)}" fill="none" stroke-width="${thin}"/>`]
        : []),
      `<path class="outline" d="${border}" fill="none" stroke-width="${thick}"/>`,
    ];
    return `<g id="chart-${chart}">\n${parts.join('\n')}\n</g>\n`;
  });
  const size = `width="${side * columns}${unit}" height="${side * rows}${unit}"`;
  const box = `viewBox="0 0 ${SIDE * columns} ${SIDE * rows}"`;
  const style = `stroke="${INK}" stroke-linejoin="round" stroke-linecap="round"`;
  return `<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" ${size} ${box} ${style}>
${groups.join('')}</svg>
`;
}

function pathOf(run: number[], uv: Float64Array, rows: number): string {
  const isClosed = run.length > 2 && run[0] === run[run.length - 1];
  const points = isClosed ? run.slice(0, -1) : run;
  const places = points.map(
    (v) => `${Math.round(uv[2 * v] * SIDE)} ${Math.round((rows - uv[2 * v + 1]) * SIDE)}`,
  );
  return `M${places.join('L')}${isClosed ? 'Z' : ''}`;
}
