// What is done to charts by hand and is not part of the first load.

import '../css/chart-tools.css';
import type { Motion } from '../arrange/motion';
import { element } from '../base/dom';
import { isTouch } from '../base/touch';
import type { Arrangeable } from '../model/arrangeable';
import type { PackChoices } from '../model/settings';
import type { SeamEditor } from '../seams/seam-editor';
import { AreaDrawing, type AreaKind } from '../selection/area-drawing';
import { addToArrange } from '../selection/arrange-items';
import { movedText } from '../selection/arrange-words';
import { ChartChoice } from '../selection/chart-choice';
import type { ChartSelection } from '../selection/chart-selection';
import { EdgeTool } from '../selection/edge-tool';
import { LineMarks } from '../selection/line-marks';
import { OutlinePicker } from '../selection/outline-picker';
import { SelectMenu } from '../selection/select-menu';
import type { Pixel } from '../view/sight';
import type { Views } from '../view/views';
import { CHOOSING, FLIPPING, LEVELLING, RESHAPING } from '../words/choosing';
import { inTouchWords } from '../words/format';
import { PACKING, SELECTION } from '../words/selection';
import type { Arranged, Workshop } from '../workshop/workshop';
import { flip } from './flip';
import { LayoutJoin, type Outlines } from './layout-join';
import { type PackingEvents, packedAround } from './pack-selected';
import type { Change } from './placement';
import { type Reshape, type ReshapingEvents, reshapeCharts } from './reshaping';
import { SymmetricSeams } from './symmetric-seams';

export interface ChartToolsEvents extends ReshapingEvents, PackingEvents {
  /** The atlas on screen, with charts where they are now; null if there is none. */
  layout(): Arrangeable | null;
  selection: ChartSelection;
  /** Whether the layout is free to select charts in. */
  isFree(): boolean;
  /** Charts that must not be changed. */
  staying(): ReadonlySet<number>;
  /** Charts are to be moved; `what` has been done to them. */
  arranged(arranged: Arranged, what: string): void;
  /** The atlas gets other coordinates; `what` has been done to it. */
  changed(change: Change, what: string): void;
  /** Pinned corners. */
  pins(): Uint32Array;
  /** What edits seams on the mesh. */
  seams: SeamEditor | null;
  say(text: string): void;
  /** What takes longer to read. */
  noted(sentences: string[]): void;
}

/** Selects charts by an area of the layout, or by what they are, and turns and joins them by their edges. */
export class ChartTools {
  private readonly areas: AreaDrawing;
  private readonly choice: ChartChoice;
  private readonly edges: EdgeTool;
  /** Of the atlas they were made for. */
  private made: { result: Arrangeable['result']; outlines: Outlines } | null = null;

  constructor(
    private readonly views: Views,
    private readonly workshop: Workshop,
    private readonly events: ChartToolsEvents,
  ) {
    const canvas = views.canvasOf('layout');
    const stage = element('layout-stage', HTMLElement);
    const marks = new LineMarks(views, 'marked-lines');
    const joined = new LineMarks(views, 'joined-lines');
    this.edges = new EdgeTool(stage, views, marks, {
      outlines: () => this.outlines?.picker ?? null,
      isMeant: (chart) => this.isAlignable(chart),
      chosen: (chart, motion) => this.turn(chart, motion),
      say: (text) => events.say(inHandWords(text)),
    });
    if (events.seams) {
      new LayoutJoin(stage, views, events.seams, joined, {
        outlines: () => (events.isFree() && !this.edges.isOn ? this.outlines : null),
        hidden: () => events.selection.hidden,
      });
      new SymmetricSeams(events.seams, {
        positions: () => events.layout()?.mesh.positions ?? null,
        say: events.say,
      });
    }
    this.areas = new AreaDrawing(stage, canvas, {
      kindOf: (event, at) => this.kindOf(event, at),
      drawn: (area, adds) =>
        this.choice.selectIn(
          area.map((at) => views.uvAt(at)),
          adds,
        ),
      announced: (kind) => kind && events.say(inHandWords(CHOOSING.toDraw[kind])),
    });
    addToArrange([
      { ...LEVELLING.item, act: () => this.edges.turn(true) },
      { ...RESHAPING.rectify, act: () => this.reshape('rectified') },
      { ...RESHAPING.relax, act: () => this.reshape('relaxed') },
      { ...FLIPPING.item, act: () => this.flip() },
    ]);
    this.choice = new ChartChoice(events.selection, workshop, {
      layout: () => events.layout(),
      draw: (kind) => this.areas.announce(kind),
      say: events.say,
    });
    new SelectMenu((how) => {
      canvas.focus();
      if (events.isFree()) this.choice.select(how);
    });
    canvas.addEventListener('keydown', (event) => this.onKey(event));
    // A drag with the right button moves the view.
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  /** A drag of a selected chart moves it. With a mouse, one beside all charts draws a box; a finger pans. */
  private kindOf(event: PointerEvent, at: Pixel): AreaKind | null {
    if (event.pointerType === 'touch' || !this.events.isFree()) return null;
    if (event.shiftKey) return hasCtrl(event) ? 'lasso' : 'box';
    const chart = this.views.chartAt('layout', at);
    if (hasCtrl(event))
      return chart !== null && this.events.selection.selected.has(chart) ? null : 'lasso';
    return chart === null ? 'box' : null;
  }

  private onKey(event: KeyboardEvent): void {
    if (hasCtrl(event) || event.altKey || !this.events.isFree()) return;
    const actions: Record<string, () => void> = {
      b: () => this.areas.announce(this.areas.announced === 'box' ? 'lasso' : 'box'),
      e: () => this.edges.turn(!this.edges.isOn),
      ...(this.events.layout()?.mode === 'pack' && { f: () => this.flip() }),
      i: () => this.choice.select('invert'),
    };
    const action = actions[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action();
  }

  private get outlines(): Outlines | null {
    const result = this.events.layout()?.result;
    if (!result) return null;
    if (this.made?.result !== result)
      this.made = {
        result,
        outlines: { picker: new OutlinePicker(result), vertexMap: result.vertexMap },
      };
    return this.made.outlines;
  }

  /** Where charts are selected, only those. */
  private isAlignable(chart: number): boolean {
    const { selected, hidden } = this.events.selection;
    return !hidden.has(chart) && (selected.size === 0 || selected.has(chart));
  }

  private turn(chart: number, motion: Motion): void {
    if (this.events.staying().has(chart)) {
      this.events.say(SELECTION.locked);
      return;
    }
    const charts = new Set([chart]);
    this.events.arranged(
      { charts: Uint32Array.from(charts), motions: [motion] },
      movedText(charts, 'straightened'),
    );
  }

  /** Gives charts another shape: those that are selected, or some others. */
  reshape(how: Reshape, selected: ReadonlySet<number> = this.events.selection.selected): void {
    const staying = this.events.staying();
    const charts = [...selected].filter((chart) => !staying.has(chart));
    if (charts.length === 0) {
      this.events.say(selected.size === 0 ? SELECTION.none : SELECTION.locked);
      return;
    }
    this.events.say(RESHAPING.doing[how]);
    this.events.changed(async (outcome) => {
      const pins = this.events.pins();
      const { coordinates, done, failed } = await reshapeCharts(
        outcome,
        charts,
        how,
        pins,
        this.events,
      );
      this.events.noted(reasonsOf(failed));
      if (done.length === 0) return RESHAPING.none(failed.length);
      return { ...coordinates, what: RESHAPING.of(RESHAPING.done[how], done, failed.length) };
    }, RESHAPING.done[how]);
  }

  /** Mirrors the selected islands of a file. */
  private flip(): void {
    const { selection, changed, say } = this.events;
    const { selected } = selection;
    if (selected.size === 0) say(SELECTION.none);
    else changed(flip([...selected], this.workshop, this.events), FLIPPING.done);
  }

  /** Relaxes the selected islands of a file; without any, all. */
  relaxIslands(): void {
    const { selected } = this.events.selection;
    const count = this.events.layout()?.result.report.charts.length ?? 0;
    this.reshape('relaxed', selected.size > 0 ? selected : new Set(Array(count).keys()));
  }

  /** Packs the selected islands of a file around the others. */
  packIslands(choices: PackChoices): void {
    const { selected } = this.events.selection;
    this.events.say(PACKING.doing);
    this.events.changed(async (outcome) => {
      if (outcome.mode !== 'pack') return '';
      const uv = await packedAround(outcome, selected, choices, this.events);
      return { uv, what: PACKING.done(selected.size, outcome.result.report.charts.length) };
    }, PACKING.doing);
  }
}

/** Why charts stay as they are, one sentence for each reason. */
function reasonsOf(failed: [number, string][]): string[] {
  const charts = new Map<string, number[]>();
  for (const [chart, why] of failed) charts.set(why, [...(charts.get(why) ?? []), chart]);
  return [...charts].map(([why, some]) => RESHAPING.failed(some, why));
}

const hasCtrl = ({ ctrlKey, metaKey }: MouseEvent | KeyboardEvent) => ctrlKey || metaKey;

const inHandWords = (text: string) => (isTouch() ? inTouchWords(text) : text);
