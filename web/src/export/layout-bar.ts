import { element } from '../base/dom';
import { download } from '../base/download';
import { CHART_COLORS } from '../colors/chart-colors';
import { NumberField } from '../controls/number-field';
import { pictureSize } from '../files/picture-size';
import type { AtlasDrawing } from '../files/svg-text';
import type { Packed, Unwrapped } from '../model/model';
import type { Mode } from '../model/settings';
import { SAVED } from '../words/export';
import type { Workshop } from '../workshop/workshop';

export interface LayoutBarEvents {
  say(text: string): void;
  /** A file was saved; `what` says so. */
  saved(what: string): void;
  failed(outcome: Unwrapped | Packed, error: Error): void;
}

/** An atlas that can be saved. */
interface Shown {
  outcome: Unwrapped | Packed;
  /** The number of each chart's colour. */
  chartColors: Float32Array;
}

/** Millimetres per unit of the mesh. */
const SCALE = { type: 'number', above: 0, words: { auto: 0 } };

/** The bar below the layout, which saves the atlas as a picture. */
export class LayoutBar {
  private readonly bar = element('layout-tools', HTMLElement);
  private readonly scale: NumberField<number | 'auto'>;
  private readonly buttons: HTMLButtonElement[];
  private shown: Shown | null = null;

  constructor(
    private readonly workshop: Workshop,
    private readonly events: LayoutBarEvents,
  ) {
    this.scale = new NumberField<number | 'auto'>(
      element('layout-scale', HTMLInputElement),
      SCALE,
      'auto',
      () => undefined,
      events.say,
    );
    this.buttons = [
      this.bind('layout-png', (shown) => this.savePng(shown)),
      this.bind('layout-heat', (shown) => this.saveHeatMap(shown)),
      this.bind('layout-svg', (shown) => this.saveSvg(shown)),
    ];
  }

  setMode(mode: Mode): void {
    this.bar.hidden = mode === 'flatten';
  }

  /** Null: the mesh on screen has no atlas. */
  show(shown: Shown | null): void {
    this.shown = shown;
    for (const button of this.buttons) button.disabled = shown === null;
  }

  private bind(id: string, save: (shown: Shown) => Promise<void>): HTMLButtonElement {
    const button = element(id, HTMLButtonElement);
    button.addEventListener('click', () => {
      const { shown } = this;
      if (shown) save(shown).catch((error: Error) => this.events.failed(shown.outcome, error));
    });
    return button;
  }

  private async savePng(shown: Shown): Promise<void> {
    const drawing = drawingOf(shown);
    const size = sizeText(drawing);
    this.save(shown, 'layout.png', await this.workshop.png(drawing), size);
  }

  private async saveHeatMap(shown: Shown): Promise<void> {
    const drawing = drawingOf(shown);
    const size = sizeText(drawing);
    this.save(shown, 'heat-map.png', await this.workshop.heatMap(drawing, shown.outcome), size);
  }

  private async saveSvg(shown: Shown): Promise<void> {
    const file = await this.workshop.svg(drawingOf(shown), this.scale.value);
    this.save(shown, 'layout.svg', file, SAVED.kilobytes(file.size));
  }

  private save({ outcome }: Shown, kind: string, file: Blob, size: string): void {
    const name = `${outcome.source.name.replace(/\.[^.]*$/, '')}-${kind}`;
    download(name, file.type, file);
    this.events.saved(SAVED.saved(name, size));
  }
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
