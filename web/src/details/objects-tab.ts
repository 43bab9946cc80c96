import { element } from '../base/dom';
import type { Flattened, Outcome, Source } from '../model/model';
import { type NamedPart, type NamedParts, NO_PARTS } from '../model/named-parts';
import { densitiesOfCharts } from '../model/painted-densities';
import type { ChartStates } from '../view/chart-flags';
import { PARTS } from '../words/objects';
import type { Workshop } from '../workshop/workshop';
import { chartsOf } from './part-charts';
import { type PartActions, PartTable } from './part-table';

export interface ObjectsEvents {
  /** How many objects and materials the mesh has. */
  offered(objects: number, materials: number): void;
  say(text: string): void;
}

/** What the scene consists of and what it is made of: an object and a material per row. */
export class ObjectsTab {
  private readonly objects: PartTable;
  private readonly materials: PartTable;
  private outcome: Exclude<Outcome, Flattened> | null = null;
  /** Of the mesh that was shown last. */
  private read: { source: Source; parts: NamedParts } | null = null;
  private listed = NO_PARTS;
  private isSeen = false;

  constructor(
    private readonly actions: PartActions,
    private readonly workshop: Workshop,
    private readonly events: ObjectsEvents,
  ) {
    this.objects = new PartTable(PARTS.objects, actions, events.say);
    this.materials = new PartTable(PARTS.materials, actions, events.say);
    const panel = element('panel-objects', HTMLElement);
    panel.append(this.objects.place, this.materials.place);
    // To find the charts of parts takes a walk over all triangles.
    new IntersectionObserver((entries) => {
      this.isSeen = entries.at(-1)?.isIntersecting ?? false;
      if (this.isSeen) this.update();
    }).observe(panel);
  }

  /** Null: the mesh on screen has no layout yet. */
  async show(outcome: Outcome | null): Promise<void> {
    const shown = outcome?.mode === 'flatten' ? null : outcome;
    this.outcome = shown;
    if (!shown) return this.list(NO_PARTS);
    const { source } = shown;
    if (this.read?.source !== source) {
      const parts = await this.workshop.namedParts(shown);
      if (this.outcome !== shown) return;
      this.read = { source, parts };
      const [objects, materials] = [parts.objects, parts.materials].map(
        (all) => all.filter(({ isThere }) => isThere).length,
      );
      this.events.offered(objects, materials);
    }
    if (this.isSeen) this.update();
  }

  showStates(states: ChartStates): void {
    if (!this.isSeen) return;
    for (const table of [this.objects, this.materials]) table.showStates(states);
  }

  private update(): void {
    const { outcome, read } = this;
    if (!outcome || read?.source !== outcome.source) return;
    this.list(read.parts);
    const { charts, count, densities } = chartsIn(outcome);
    for (const table of [this.objects, this.materials])
      table.show((part) => chartsOf(part, charts, count), count, densities);
    this.showStates(this.actions.states);
  }

  private list(parts: NamedParts): void {
    if (parts === this.listed) return;
    this.listed = parts;
    const named = (all: NamedPart[]) => (all.some(({ isThere }) => isThere) ? all : []);
    this.objects.list(named(parts.objects));
    this.materials.list(named(parts.materials));
  }
}

/** The chart of each triangle, how many there are, and the density of each, if that can be asked for. */
function chartsIn(outcome: Exclude<Outcome, Flattened>) {
  if (outcome.mode === 'pack') {
    const { islandOfTriangle, report } = outcome.result;
    return { charts: islandOfTriangle, count: report.islands, densities: null };
  }
  const { chartOfTriangle } = outcome.result;
  const densities = [...densitiesOfCharts(outcome)];
  return { charts: chartOfTriangle, count: densities.length, densities };
}
