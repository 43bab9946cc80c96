import { download } from '../base/download';
import { CHART_COLORS } from '../colors/chart-colors';
import { pictureSize } from '../files/picture-size';
import type { AtlasDrawing } from '../files/svg-text';
import type { Packed, Unwrapped } from '../model/model';
import { SAVED } from '../words/export';
import type { Workshop } from '../workshop/workshop';

/** An atlas that can be saved. */
export interface ShownAtlas {
  outcome: Unwrapped | Packed;
  /** The number of each chart's colour. */
  chartColors: Float32Array;
}

export type LayoutKind = 'png' | 'heat' | 'svg';

const ENDINGS: Record<LayoutKind, string> = {
  png: 'layout.png',
  heat: 'heat-map.png',
  svg: 'layout.svg',
};

/** Saves the picture of an atlas, and says so. `scale`: millimetres per unit of the mesh. */
export async function saveLayout(
  shown: ShownAtlas,
  kind: LayoutKind,
  workshop: Workshop,
  scale: number | 'auto',
): Promise<string> {
  const { outcome } = shown;
  const drawing = drawingOf(shown);
  const pixels = kind === 'svg' ? '' : sizeText(drawing);
  const files = {
    png: () => workshop.png(drawing),
    heat: () => workshop.heatMap(drawing, outcome),
    svg: () => workshop.svg(drawing, scale),
  };
  const file = await files[kind]();
  const name = `${outcome.source.name.replace(/\.[^.]*$/, '')}-${ENDINGS[kind]}`;
  download(name, file.type, file);
  return SAVED.saved(name, pixels || SAVED.kilobytes(file.size));
}

function drawingOf({ outcome, chartColors }: ShownAtlas): AtlasDrawing {
  const { uv, indices } = outcome.result;
  const { faces } = outcome.mesh;
  return { uv, indices, faces, ...chartsOf(outcome), colors: colorsOf(chartColors) };
}

function chartsOf({ mode, result }: ShownAtlas['outcome']) {
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
