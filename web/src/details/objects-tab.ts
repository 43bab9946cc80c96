import { element } from '../base/dom';
import type { Outcome, Source, Unwrapped } from '../model/model';
import { type NamedPart, type NamedParts, NO_PARTS } from '../model/named-parts';
import type { ChartStates } from '../view/chart-flags';
import { PARTS } from '../words/objects';
import type { Workshop } from '../workshop/workshop';
import { chartsOf } from './part-charts';
import { type PartActions, PartTable } from './part-table';

export interface ObjectsEvents {
  /** Whether the mesh has objects or materials to list. */
  offered(has: boolean): void;
  say(text: string): void;
}

/** What the scene consists of and what it is made of: an object and a material per row. */
export class ObjectsTab {
  private readonly objects: PartTable;
  private readonly materials: PartTable;
  private outcome: Unwrapped | null = null;
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
    const shown = outcome?.mode === 'unwrap' ? outcome : null;
    this.outcome = shown;
    if (!shown) return this.list(NO_PARTS);
    const { source } = shown;
    if (this.read?.source !== source) {
      const parts = await this.workshop.namedParts(shown);
      if (this.outcome !== shown) return;
      this.read = { source, parts };
      const all = [...parts.objects, ...parts.materials].filter(({ isThere }) => isThere);
      this.events.offered(all.length > 1);
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
    const { chartOfTriangle, report } = outcome.result;
    const { charts } = report;
    const densities = outcome.settings.faceDensities;
    for (const table of [this.objects, this.materials])
      table.show(
        (part) => chartsOf(part, chartOfTriangle, charts.length),
        charts.map(({ firstFace }) => densities?.[firstFace] ?? 1),
      );
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
