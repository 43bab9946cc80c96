import { chartsInArea } from '../arrange/charts-in-area';
import type { Point } from '../arrange/motion';
import { reasonOf } from '../base/load-part';
import type { Arrangeable } from '../model/arrangeable';
import { CHOOSING } from '../words/choosing';
import { SELECTION } from '../words/selection';
import type { Workshop } from '../workshop/workshop';
import type { AreaKind } from './area-drawing';
import type { ChartSelection } from './chart-selection';
import { chartsWithParts, flippedCharts, overlappingCharts, stretchedCharts } from './choosing';
import { type PartKind, partsOfFile } from './parts-of-file';
import type { SelectName } from './select-menu';

export interface ChartChoiceEvents {
  /** The atlas on screen, with charts where they are now; null if there is none. */
  layout(): Arrangeable | null;
  /** The next drag is to draw this. */
  draw(kind: AreaKind): void;
  say(text: string): void;
}

/** Finds what is like some charts, and these. */
type Find = (charts: ReadonlySet<number>) => Promise<ReadonlySet<number>>;

/** Selects charts by an area in uv, or by what they are. */
export class ChartChoice {
  constructor(
    private readonly selection: ChartSelection,
    private readonly workshop: Pick<Workshop, 'sameShapes' | 'namedParts' | 'connectedParts'>,
    private readonly events: ChartChoiceEvents,
  ) {}

  /** Those that an area touches; `adds`: to what is selected. */
  selectIn(area: Point[], adds: boolean): void {
    const outcome = this.events.layout();
    if (!outcome) return;
    const charts = chartsInArea(outcome.result, area, this.selection.hidden);
    this.pick(charts, CHOOSING.noneInArea, adds);
  }

  /** By name, or all above a limit of the stretch. */
  select(how: SelectName | number): void {
    const outcome = this.events.layout();
    if (!outcome) return;
    if (typeof how === 'number') {
      const charts = outcome.result.report.charts.map((chart) => chart.symmetricDirichlet);
      const most = charts.reduce((a, b) => Math.max(a, b), 0);
      this.pick(stretchedCharts(outcome, how), CHOOSING.noneStretched(how, most));
      return;
    }
    const { selection } = this;
    const { length } = outcome.result.report.charts;
    const actions: Record<SelectName, () => void> = {
      box: () => this.events.draw('box'),
      lasso: () => this.events.draw('lasso'),
      all: () => selection.pickAll(length),
      none: () => selection.pickNone(),
      invert: () => {
        const { selected } = selection;
        selection.pickSome([...Array(length).keys()].filter((chart) => !selected.has(chart)));
      },
      material: () => this.addLike(outcome, 'material', this.withParts(outcome, 'material')),
      group: () => this.addLike(outcome, 'group', this.withParts(outcome, 'group')),
      shape: () =>
        this.addLike(outcome, 'shape', (charts) =>
          this.workshop.sameShapes(outcome.result, Uint32Array.from(charts)),
        ),
      overlapping: () => this.pick(overlappingCharts(outcome), CHOOSING.noneFound.overlapping),
      flipped: () => this.pick(flippedCharts(outcome.result), CHOOSING.noneFound.flipped),
    };
    actions[how]();
  }

  private withParts(outcome: Arrangeable, kind: PartKind): Find {
    return async (charts) => {
      const parts = await partsOfFile(outcome, kind, this.workshop);
      return parts ? chartsWithParts(outcome.result, parts, charts) : charts;
    };
  }

  /** Selects what is like the selected charts, too. */
  private addLike(outcome: Arrangeable, how: keyof typeof CHOOSING.noneFound, find: Find): void {
    const { selected } = this.selection;
    if (selected.size === 0) {
      this.events.say(SELECTION.none);
      return;
    }
    find(selected).then(
      (found) => {
        // Something else is on screen, or was selected, in the meantime.
        if (this.events.layout() !== outcome || this.selection.selected !== selected) return;
        if (found.size > selected.size) this.pick(found, '');
        else this.events.say(CHOOSING.noneFound[how]);
      },
      (error: Error) => this.events.say(reasonOf(error)),
    );
  }

  /** `none`: what is said if there are no charts. */
  private pick(charts: ReadonlySet<number>, none: string, adds = false): void {
    this.selection.pickSome(charts, adds);
    const { size } = this.selection.selected;
    this.events.say(charts.size > 0 ? CHOOSING.selected(size) : none);
  }
}
