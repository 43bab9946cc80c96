import type { Abflat } from 'abflat';
import { loadPart } from '../base/load-part';
import { startOnce } from '../base/start-once';
import type { Arrangeable } from '../model/arrangeable';
import type { Unwrapped } from '../model/model';
import { densitiesOfCharts } from '../model/painted-densities';
import type { UnwrapSettings } from '../model/settings';
import type { SeamEditor } from '../seams/seam-editor';
import { PinTool } from '../selection/pin-tool';
import { type SelectionEvents, SelectionPanel } from '../selection/selection-panel';
import type { ChartStates } from '../view/chart-flags';
import type { Views } from '../view/views';
import { STACKING } from '../words/selection';
import type { Arranged, Workshop } from '../workshop/workshop';
import type { ChartTools } from './chart-tools';
import type { PackingEvents } from './pack-selected';
import { type Change, Placement, type PlacementEvents } from './placement';

const NONE: ReadonlySet<number> = new Set();

export interface ArrangingEvents
  extends PlacementEvents,
    PackingEvents,
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
  /** What takes longer to read. */
  noted(sentences: string[]): void;
}

/** All that is done to charts of the layout by hand: they are selected, moved, and bent by their pins. */
export class Arranging {
  private readonly placement: Placement;
  private readonly pins: PinTool;
  private asked: { atlas: Unwrapped; ofCharts: Float64Array } | null = null;
  readonly selection: SelectionPanel;
  /** What a first look does not need. */
  readonly loadRest: () => Promise<ChartTools>;

  constructor(
    views: Views,
    workshop: Workshop,
    private readonly events: ArrangingEvents,
  ) {
    const place = (change: Change, what: string) => void this.placement.place(change, what);
    this.placement = new Placement(workshop, views, {
      placing: () => events.placing(),
      placed: (outcome, what, mayRepack) => {
        this.pins.show();
        this.selection.showDensity();
        events.placed(outcome, what, mayRepack);
      },
      notPlaced: (error, why) => {
        this.pins.show();
        events.notPlaced(error, why);
      },
    });
    this.pins = new PinTool(views, {
      layout: () => this.atlas,
      staying: () => this.staying,
      keptUvs: () => events.keptUvs(),
      hidden: () => this.selection.states.hidden,
      charts: (outcome, charts) => workshop.charts(outcome, charts),
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
        // Who asks for a density does not say where islands are to be; who drags them does.
        const mayRepack = 'density' in arranged || ('how' in arranged && arranged.how === 'evened');
        if (below === undefined || !('how' in arranged)) return { uv, mayRepack };
        const stacked = charts.length + below;
        return {
          uv,
          what: STACKING.done(stacked, arranged.charts.length + arranged.fixed.length),
        };
      }, what);
    this.selection = new SelectionPanel(views, this.pins, {
      isFree: () => events.isFree(),
      changed: (states) => events.selected(states),
      staying: () => this.staying,
      keptUvs: () => events.keptUvs(),
      densities: () => this.densities,
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
        staying: () => this.staying,
        arranged: arrange,
        changed: place,
        pins: () => this.pins.all,
        charts: (outcome, charts) => workshop.charts(outcome, charts),
        onMesh: events.onMesh,
        aside: events.aside,
        seams: events.seams,
        say: (text) => events.say(text),
        noted: (sentences) => events.noted(sentences),
      });
    });
  }

  /** The atlas on screen; null if there is none. `wanted`: what the user asks for now. */
  show(
    outcome: Arrangeable | null,
    wanted: Pick<Partial<UnwrapSettings>, 'pins'> & { placed?: object } = {},
  ): void {
    this.placement.show(outcome, wanted.placed);
    this.selection.open(outcome?.result.report ?? null);
    this.pins.show(wanted.pins ?? new Uint32Array());
  }

  /** The layout on screen, with charts where they are now; null if there is none. */
  get current(): Arrangeable | null {
    return this.placement.current;
  }

  private get atlas(): Unwrapped | null {
    return this.current?.mode === 'unwrap' ? this.current : null;
  }

  /** What each chart of an atlas asks for. */
  private get densities(): Float64Array | null {
    const { atlas } = this;
    if (!atlas) return null;
    if (this.asked?.atlas !== atlas) this.asked = { atlas, ofCharts: densitiesOfCharts(atlas) };
    return this.asked.ofCharts;
  }

  /** Locks are those of atlases. */
  private get staying(): ReadonlySet<number> {
    return this.atlas ? this.events.staying() : NONE;
  }
}
