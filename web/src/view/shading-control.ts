import { element } from '../base/dom';
import { SHADINGS } from '../base/english';
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
  private readonly materials = new Option(SHADINGS.materials, 'materials');
  /** Whether a mesh with materials appears with them. */
  private wantsMaterials = true;
  /** Was shown before charts. */
  private other: Shading = 'grid';

  constructor(
    private readonly changed: (shading: Shading) => void,
    choose: (chosen: Chosen | null) => void,
  ) {
    this.legend = new HeatLegend(choose);
    this.list.addEventListener('change', () => {
      if (this.hasMaterials) this.wantsMaterials = this.shading === 'materials';
      this.update();
    });
  }

  private get hasMaterials(): boolean {
    return this.materials.parentNode !== null;
  }

  /** Lists the materials of the mesh if it has any; `shows`: whether it appears with them. */
  offerMaterials(hasAny: boolean, shows: boolean): void {
    if (!hasAny && this.shading === 'materials') this.list.value = 'plain';
    if (hasAny) this.list.options[0].after(this.materials);
    else this.materials.remove();
    this.other = hasAny ? 'materials' : 'grid';
    if (shows && this.wantsMaterials && this.shading === 'plain') this.list.value = 'materials';
    this.update();
  }

  /** From charts to the last other shading, and back. */
  toggle(): void {
    this.list.value = this.shading === 'plain' ? this.other : 'plain';
    this.list.dispatchEvent(new Event('change'));
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
    if (this.shading !== 'plain') this.other = this.shading;
    this.changed(this.shading);
    this.showLegend();
  }

  private showLegend(): void {
    const { shading, spreads } = this;
    if (isMeasure(shading) && spreads) this.legend.show(shading, spreads[shading]);
    else this.legend.hide();
  }
}
