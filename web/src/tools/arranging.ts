import type { Abflat } from 'abflat';
import { loadPart } from '../base/load-part';
import { startOnce } from '../base/start-once';
import type { Unwrapped } from '../model/model';
import type { UnwrapSettings } from '../model/settings';
import type { SeamEditor } from '../seams/seam-editor';
import { PinTool } from '../selection/pin-tool';
import { type SelectionEvents, SelectionPanel } from '../selection/selection-panel';
import type { ChartStates } from '../view/chart-flags';
import type { Views } from '../view/views';
import { STACKING } from '../words/selection';
import type { Arranged, Workshop } from '../workshop/workshop';
import { type Change, Placement, type PlacementEvents } from './placement';

export interface ArrangingEvents
  extends PlacementEvents,
    Pick<SelectionEvents, 'staying' | 'keptUvs'> {
  /** Whether a click on the mesh is free to select: no seam tool takes it. */
  isFree(): boolean;
  /** What edits seams on the mesh. */
  seams: SeamEditor | null;
  /** Other charts are selected or hidden. */
  selected(states: ChartStates): void;
  /** Work of abflat beside its runs. */
  aside<T>(work: (abflat: Abflat, signal: AbortSignal) => Promise<T>): Promise<T>;
  /** Other vertices are pinned; `what` was done. */
  pinned(pins: Uint32Array, what: string): void;
  say(text: string): void;
}

/** All that is done to charts of the layout by hand: they are selected, moved, and bent by their pins. */
export class Arranging {
  private readonly placement: Placement;
  private readonly pins: PinTool;
  readonly selection: SelectionPanel;
  /** What a first look does not need. */
  readonly loadRest: () => Promise<unknown>;

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
      weights: ({ positions, indices, texcoords }, pins) =>
        events.aside(async (abflat, signal) => {
          const layout = { positions, indices, texcoords };
          return (await abflat.pinWeights(layout, pins, { signal })).weights;
        }),
      changed: (pins, what) => events.pinned(pins, what),
      bent: (change, what) => place(async ({ result }) => change(result), what),
      say: (text) => events.say(text),
    });
    const arrange = (arranged: Arranged, what: string) =>
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
      }, what);
    this.selection = new SelectionPanel(views, this.pins, {
      isFree: () => events.isFree(),
      changed: (states) => events.selected(states),
      staying: () => events.staying(),
      keptUvs: () => events.keptUvs(),
      densityOf: (face) => this.placement.current?.settings.faceDensities?.[face] ?? 1,
      arranged: arrange,
      say: (text) => events.say(text),
    });
    this.loadRest = startOnce(async () => {
      const { ChartTools } = await loadPart(import('./chart-tools'));
      const { selection } = this.selection;
      return new ChartTools(views, workshop, {
        layout: () => this.placement.current,
        selection,
        isFree: () => this.selection.isFree,
        staying: () => events.staying(),
        arranged: arrange,
        changed: place,
        pins: () => this.pins.all,
        chart: (outcome, chart) => workshop.chart(outcome, chart),
        aside: events.aside,
        seams: events.seams,
        say: (text) => events.say(text),
      });
    });
  }

  /** The atlas on screen; null if there is none. `wanted`: what the user asks for now. */
  show(outcome: Unwrapped | null, wanted: Partial<UnwrapSettings> = {}): void {
    this.placement.show(outcome, wanted.placed);
    this.selection.open(outcome?.result.report ?? null);
    this.pins.show(wanted.pins ?? new Uint32Array());
  }
}
