import { element } from '../base/dom';

/** Css pixels: between a layout in one piece and what is around it, and between an atlas and that. */
const MARGIN = 28;
const ATLAS_MARGIN = 8;

export interface Margins {
  side: number;
  top: number;
  bottom: number;
}

/** What a fitted layout leaves free of its view, for the bar of what is selected and the legend. */
export class FitRoom {
  private readonly legend = element('legend', HTMLElement);

  /** `changed` is called when the legend comes, goes, or has another height. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    changed: () => void,
  ) {
    new ResizeObserver(changed).observe(this.legend);
  }

  margins({ width, height }: { width: number; height: number }, isAtlas: boolean): Margins {
    const margin = isAtlas ? ATLAS_MARGIN : Math.min(MARGIN, width / 14, height / 14);
    const top = isAtlas ? this.above : margin;
    const { offsetHeight } = this.legend;
    const legend = offsetHeight > 0 ? offsetHeight + ATLAS_MARGIN : 0;
    return { side: margin, top, bottom: Math.max(margin, legend + ATLAS_MARGIN) };
  }

  /** The bar's height is known before it is shown, as its style sheet says: the layout stays where it is. */
  private get above(): number {
    return Number.parseFloat(getComputedStyle(this.canvas).getPropertyValue('--above'));
  }
}
