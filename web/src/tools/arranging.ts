import type { ChartMesh } from '../arrange/chart-mesh';
import type { Unwrapped } from '../model/model';
import type { UnwrapSettings } from '../model/settings';
import { PinTool } from '../selection/pin-tool';
import { type SelectionEvents, SelectionPanel } from '../selection/selection-panel';
import type { ChartStates } from '../view/chart-flags';
import type { Views } from '../view/views';
import { STACKING } from '../words/selection';
import type { Workshop } from '../workshop/workshop';
import { type Change, Placement, type PlacementEvents } from './placement';

export interface ArrangingEvents
  extends PlacementEvents,
    Pick<SelectionEvents, 'staying' | 'keptUvs'> {
  /** Whether a click on the mesh is free to select: no seam tool takes it. */
  isFree(): boolean;
  /** Other charts are selected or hidden. */
  selected(states: ChartStates): void;
  /** How a layout follows the first of some pinned vertices. */
  weights(layout: ChartMesh, pins: number[]): Promise<Float64Array>;
  /** Other vertices are pinned; `what` was done. */
  pinned(pins: Uint32Array, what: string): void;
  say(text: string): void;
}

/** All that is done to charts of the layout by hand: they are selected, moved, and bent by their pins. */
export class Arranging {
  private readonly placement: Placement;
  private readonly pins: PinTool;
  readonly selection: SelectionPanel;

  constructor(views: Views, workshop: Workshop, events: ArrangingEvents) {
    const place = (change: Change, what: string) => void this.placement.place(change, what);
    this.placement = new Placement(workshop, views, {
      placing: () => events.placing(),
      placed: (layout, densities, what) => {
        this.pins.show();
        this.selection.showDensity();
        events.placed(layout, densities, what);
      },
      notPlaced: (error, why) => {
        this.pins.show();
        events.notPlaced(error, why);
      },
    });
    this.pins = new PinTool(views, {
      layout: () => this.placement.current,
      staying: () => events.staying(),
      keptUvs: () => events.keptUvs(),
      hidden: () => this.selection.states.hidden,
      chart: (outcome, chart) => workshop.chart(outcome, chart),
      weights: (layout, pins) => events.weights(layout, pins),
      changed: (pins, what) => events.pinned(pins, what),
      bent: (change, what) => place(async ({ result }) => change(result), what),
      say: (text) => events.say(text),
    });
    this.selection = new SelectionPanel(views, this.pins, {
      isFree: () => events.isFree(),
      changed: (states) => events.selected(states),
      staying: () => events.staying(),
      keptUvs: () => events.keptUvs(),
      densityOf: (face) => this.placement.current?.settings.faceDensities?.[face] ?? 1,
      arranged: (arranged, what) =>
        place(async (outcome) => {
          const motions = await workshop.motions(outcome, arranged);
          const { charts, below } = motions;
          if (below === 0) return STACKING.noneFits;
          const uv = await workshop.moved(outcome.result, motions);
          if (below === undefined || !('how' in arranged)) return { uv };
          const stacked = charts.length + below;
          return {
            uv,
            what: STACKING.done(stacked, arranged.charts.length + arranged.fixed.length),
          };
        }, what),
      say: (text) => events.say(text),
    });
  }

  /** The atlas on screen; null if there is none. `wanted`: what the user asks for now. */
  show(outcome: Unwrapped | null, wanted: Partial<UnwrapSettings> = {}): void {
    this.placement.show(outcome, wanted.placed);
    this.selection.open(outcome?.result.report ?? null);
    this.pins.show(wanted.pins ?? new Uint32Array());
  }
}
