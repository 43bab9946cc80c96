import { element } from '../base/dom';
import type { FlatDrawing } from '../model/drawing';
import type { Measure } from '../model/measures';
import { HeatLegend } from './heat-legend';
import type { Chosen } from './heat-uniforms';
import { isMeasure, type Shading } from './shading';

/** The list of shadings, and the legend of the heat map that is shown. */
export class ShadingControl {
  private readonly list = element('shading', HTMLSelectElement);
  private readonly legend: HeatLegend;
  private spreads: FlatDrawing['spreads'] | null = null;

  constructor(
    private readonly changed: (shading: Shading) => void,
    choose: (chosen: Chosen | null) => void,
  ) {
    this.legend = new HeatLegend(choose);
    this.list.addEventListener('change', () => this.update());
  }

  get shading(): Shading {
    return this.list.value as Shading;
  }

  /** Of another layout. */
  show({ spreads }: FlatDrawing): void {
    this.spreads = spreads;
    this.showLegend();
  }

  showWorst(measure: Measure): void {
    this.list.value = measure;
    this.update();
    this.legend.showWorst();
  }

  private update(): void {
    this.changed(this.shading);
    this.showLegend();
  }

  private showLegend(): void {
    const { shading, spreads } = this;
    if (isMeasure(shading) && spreads) this.legend.show(shading, spreads[shading]);
    else this.legend.hide();
  }
}
