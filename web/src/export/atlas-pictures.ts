// Files with a picture of an atlas.

import { download } from '../base/download';
import { CHART_COLORS } from '../colors/chart-colors';
import { pictureSize } from '../files/picture-size';
import type { AtlasDrawing } from '../files/svg-text';
import type { Packed, Unwrapped } from '../model/model';
import { SAVED } from '../words/exported';
import type { Workshop } from '../workshop/workshop';

/** An atlas that can be saved. */
export interface Shown {
  outcome: Unwrapped | Packed;
  /** The number of each chart's colour. */
  chartColors: Float32Array;
}

/** A template to paint on, a map of areas, or lines. */
export type PictureKind = 'png' | 'heat' | 'svg';

/** `millimetres`: per unit of the mesh, in an SVG. Returns what was done, for people. */
export async function savePictureOf(
  shown: Shown,
  kind: PictureKind,
  millimetres: number | 'auto',
  workshop: Workshop,
): Promise<string> {
  const drawing = drawingOf(shown);
  if (kind === 'svg') {
    const file = await workshop.svg(drawing, millimetres);
    return save(shown, 'layout.svg', file, SAVED.kilobytes(file.size));
  }
  // Before the work: it says why there can be no picture.
  const size = sizeText(drawing);
  return kind === 'png'
    ? save(shown, 'layout.png', await workshop.png(drawing), size)
    : save(shown, 'heat-map.png', await workshop.heatMap(drawing, shown.outcome), size);
}

function save({ outcome }: Shown, kind: string, file: Blob, size: string): string {
  const name = `${outcome.source.name.replace(/\.[^.]*$/, '')}-${kind}`;
  download(name, file.type, file);
  return SAVED.saved(name, size);
}

function drawingOf({ outcome, chartColors }: Shown): AtlasDrawing {
  const { uv, indices } = outcome.result;
  const { faces } = outcome.mesh;
  return { uv, indices, faces, ...chartsOf(outcome), colors: colorsOf(chartColors) };
}

function chartsOf({ mode, result }: Shown['outcome']) {
  if (mode === 'pack') {
    const { islands: chartCount, resolution, tiles, texelDensity } = result.report;
    return { charts: result.islandOfTriangle, chartCount, resolution, tiles, texelDensity };
  }
  const { charts, atlas } = result.report;
  const { resolution, tiles, texelDensity } = atlas;
  return {
    charts: result.chartOfTriangle,
    chartCount: charts.length,
    resolution,
    tiles,
    texelDensity,
  };
}

/** As css colours, in the current theme. */
function colorsOf(chartColors: Float32Array): string[] {
  const style = getComputedStyle(document.documentElement);
  const palette = Array.from({ length: CHART_COLORS }, (_, i) =>
    style.getPropertyValue(`--chart-${i}`).trim(),
  );
  return Array.from(chartColors, (color) => palette[color]);
}

function sizeText(drawing: AtlasDrawing): string {
  const { width, height } = pictureSize(drawing);
  return SAVED.pixels(width, height);
}
