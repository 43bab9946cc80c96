import { element } from '../base/dom';
import type { FlatDrawing } from '../model/drawing';
import type { Measure } from '../model/measures';
import { SHADINGS } from '../words/view';
import { HeatLegend } from './heat-legend';
import type { Chosen } from './heat-uniforms';
import { ImageChoice, type ImageEvents } from './image-choice';
import { isMeasure, type Shading } from './shading';

export interface ShadingEvents extends ImageEvents {
  changed(shading: Shading): void;
  /** Some triangles of the heat map are lit; null: all. */
  choose(chosen: Chosen | null): void;
}

/** The list of shadings, and the legend of the heat map that is shown. */
export class ShadingControl {
  private readonly list = element('shading', HTMLSelectElement);
  private readonly legend: HeatLegend;
  private spreads: FlatDrawing['spreads'] | null = null;
  private readonly materials = new Option(SHADINGS.materials, 'materials');
  /** Whether a mesh with materials appears with them. */
  private wantsMaterials = true;
  private readonly image: ImageChoice;
  /** In the views. */
  private shown: Shading = 'plain';
  /** Was shown before charts. */
  private other: Shading = 'grid';

  constructor(private readonly events: ShadingEvents) {
    this.legend = new HeatLegend((chosen) => events.choose(chosen));
    const leave = () => {
      this.list.value = this.shown;
    };
    this.image = new ImageChoice(this.list, leave, events);
    this.list.addEventListener('change', () => {
      if (this.image.isAsking) this.image.reached();
      else this.chosen();
    });
  }

  /** By the user. */
  private chosen(): void {
    const shading = this.list.value as Shading;
    if (this.hasMaterials) this.wantsMaterials = shading === 'materials';
    this.use(shading);
  }

  private get hasMaterials(): boolean {
    return this.materials.parentNode !== null;
  }

  /** Lists the materials of the mesh if it has any; `shows`: whether it appears with them. */
  offerMaterials(hasAny: boolean, shows: boolean): void {
    if (hasAny) this.list.options[0].after(this.materials);
    if (this.other !== 'image') this.other = hasAny ? 'materials' : 'grid';
    const isGone = !hasAny && this.shown === 'materials';
    const isFirst = shows && this.wantsMaterials && this.shown === 'plain';
    this.use(isGone ? 'plain' : isFirst ? 'materials' : this.shown);
    if (!hasAny) this.materials.remove();
  }

  /** Lists the image and shows it. */
  offerImage(name: string): void {
    this.image.offer(name);
    this.use('image');
  }

  /** From charts to the last other shading, and back. */
  toggle(): void {
    this.list.value = this.shown === 'plain' ? this.other : 'plain';
    this.chosen();
  }

  /** Of another layout. */
  show({ spreads }: FlatDrawing): void {
    this.spreads = spreads;
    this.showLegend();
  }

  /** There is no layout. */
  clear(): void {
    if (!this.spreads) return;
    this.spreads = null;
    this.showLegend();
  }

  showMeasure(measure: Measure): void {
    this.use(measure);
  }

  showWorst(measure: Measure): void {
    this.use(measure);
    this.legend.showWorst();
  }

  private use(shading: Shading): void {
    this.list.value = shading;
    this.shown = shading;
    if (shading !== 'plain') this.other = shading;
    this.events.changed(shading);
    this.showLegend();
  }

  private showLegend(): void {
    const { shown, spreads } = this;
    if (isMeasure(shown) && spreads) this.legend.show(shown, spreads[shown]);
    else this.legend.hide();
  }
}
