import { loadPart } from '../base/load-part';
import { closesSomething, isMessageNext } from '../base/messages';
import { isTouch } from '../base/touch';
import type { ShortestPaths } from '../surface/shortest-paths';
import { Aim, type Modifiers, modifiersOf } from '../view/aim';
import type { MeshView } from '../view/mesh-view';
import { NO_MARKS, type SeamMarks } from '../view/seam-overlay';
import type { Pixel } from '../view/sight';
import { SEAMS } from '../words/seams';
import type { SeamModel, Symmetry } from './seam-model';
import type { Brush, SeamPainter } from './seam-painter';
import type { Targets } from './seam-targets';
import { SeamTools, type Tool } from './seam-tools';

export interface SeamEditorEvents {
  /** The user wants other seams; `what` has changed. */
  changed(what: string): void;
  /** Shows a message to the user. */
  say(text: string): void;
  /** Resolves once the model is ready, or cannot be. */
  ready(): Promise<unknown>;
}

const NO_POINTS = new Float32Array();

/** So many take only a few milliseconds. */
const PLACES_PER_FRAME = 1 << 14;

/** Css pixels between the clicks of a double-click; fingers are not precise. */
const DOUBLE_CLICK = 20;

const TO_CLICK: Record<Tool, string> = { cut: SEAMS.toCut, join: SEAMS.toJoin };
const TO_DRAG: Record<Tool, string> = { cut: SEAMS.toPaint, join: SEAMS.toErase };

/** Lets the user cut and join seams by clicking on the surface. */
export class SeamEditor {
  private readonly tools: SeamTools;
  private readonly aim: Aim;
  private model: SeamModel | null = null;
  private paths: ShortestPaths | null = null;
  private isGrowing = false;
  /** Null until it is loaded. */
  private painter: SeamPainter | null = null;
  /** Edges that a button would cut, and what they are; null: none. */
  private offer: { edges: number[]; text: string } | null = null;
  /** Where a cut was begun by a click on the middle of an edge, which may become a double-click. */
  private begunOnEdge: Pixel | null = null;
  /** Null until needed. */
  private targets: Targets | null = null;
  private alike: Symmetry = (_, edges) => edges;
  readonly symmetry = () => this.alike;

  constructor(
    private readonly view: MeshView,
    private readonly events: SeamEditorEvents,
  ) {
    this.tools = new SeamTools(
      () => this.clear(),
      () => this.cancel(),
    );
    this.aim = new Aim(view.canvas, {
      moved: (at, modifiers) => this.onMove(at, modifiers),
      clicked: (at, modifiers) => this.onClick(at, modifiers),
      doubleClicked: (at, modifiers) => this.onDoubleClick(at, modifiers),
    });
    view.orbit.onTurn(() => {
      this.begunOnEdge = null;
      this.aim.refresh();
    });
    view.canvas.addEventListener('keydown', (event) => this.onKey(event));
    // In the capture phase, before the page uses Escape to cancel the run in flight.
    window.addEventListener('keydown', (event) => this.onEscape(event), { capture: true });
  }

  /** Whether clicks on the mesh do nothing here. */
  get isIdle(): boolean {
    return this.tools.tool === null;
  }

  /** Clicks on the mesh are to do nothing here. */
  rest(): void {
    this.tools.leave();
  }

  /** What is to be cut or joined with some edges. */
  setSymmetry(alike: Symmetry): void {
    this.alike = alike;
  }

  /** The seams of which a click removes some; null if it does not. */
  get joining(): SeamModel | null {
    if (this.tools.tool !== 'join' || !this.model) return null;
    if (this.model.isReady) return this.model;
    void this.events.ready();
    return null;
  }

  /** What paints is not part of the first load. */
  async loadRest(): Promise<void> {
    const { SeamPainter } = await loadPart(import('./seam-painter'));
    this.painter ??= new SeamPainter(this.view, {
      begins: (event) => this.brushOf(event),
      begun: () => {
        this.paths = null;
        this.aim.forget();
      },
      shown: (marks, hint) => this.mark(marks, hint),
      finished: (text, hasChanged) => {
        this.events.say(text);
        if (hasChanged) this.events.changed(text);
        this.aim.refresh();
      },
    });
  }

  /** Sets the seams to edit; null for none. */
  edit(model: SeamModel | null): void {
    if (model !== this.model) {
      this.painter?.cancel();
      this.paths = null;
      this.offer = null;
    }
    this.model = model;
    this.tools.setEnabled(model !== null);
    this.update();
  }

  /** Called when the model or the atlas has changed. */
  update(): void {
    this.targets = null;
    this.aim.refresh();
  }

  /** Forgets a cut or a stroke that was begun. */
  clear(): void {
    this.painter?.cancel();
    this.paths = null;
    this.mark(NO_MARKS, '');
    this.aim.refresh();
  }

  /** Shows edges that a button would cut, and says what they are; null: none. */
  show(offer: { edges: number[]; text: string } | null): void {
    this.offer = offer;
    this.aim.refresh();
  }

  private mark(marks: SeamMarks, hint: string): void {
    if (this.model && marks !== NO_MARKS)
      this.view.markSeams(this.model.surface.solid.points, marks);
    else this.view.markSeams(NO_POINTS, NO_MARKS);
    this.tools.setCutting(this.paths !== null);
    this.tools.setHint(hint);
  }

  private toolOf({ alt }: Modifiers): Tool | null {
    const { tool } = this.tools;
    if (!alt || tool === null) return tool;
    return tool === 'cut' ? 'join' : 'cut';
  }

  private invitation(tool: Tool): string {
    return (this.tools.isPainting ? TO_DRAG : TO_CLICK)[tool];
  }

  /** What a drag that begins like this paints with; null: it turns the view. */
  private brushOf(event: PointerEvent): Brush | null {
    const { model } = this;
    const tool = this.toolOf(modifiersOf(event));
    const isMeant = this.tools.isPainting || event.ctrlKey || event.metaKey;
    if (!isMeant || tool === null || !model?.isReady) return null;
    this.targets ??= model.surface.aiming.targetsOf(model);
    return { model, tool, targets: this.targets };
  }

  private onMove(at: Pixel | null, modifiers: Modifiers): void {
    if (this.painter?.isDrawing) return;
    const tool = this.toolOf(modifiers);
    if (!this.model) this.mark(NO_MARKS, '');
    else if (this.offer)
      this.mark({ ...NO_MARKS, offered: endsIn(this.model, this.offer.edges) }, this.offer.text);
    else if (tool === null) this.mark(NO_MARKS, SEAMS.toSelect);
    else if (!at && !this.paths) this.mark(NO_MARKS, this.invitation(tool));
    else if (!this.model.isReady) {
      this.mark(NO_MARKS, this.invitation(tool));
      void this.events.ready();
    } else if (tool === 'cut') this.previewCut(this.model, at);
    else this.previewJoin(this.model, at, modifiers);
  }

  private onClick(at: Pixel, modifiers: Modifiers): void {
    const tool = this.toolOf(modifiers);
    if (tool === null) return;
    this.whenReady((model) => {
      if (tool === 'cut') this.cut(model, at, modifiers.shift);
      else this.join(model, at, modifiers);
      this.aim.refresh();
    });
  }

  /** What is done before the seams can be edited waits for that. */
  private whenReady(act: (model: SeamModel) => void): void {
    const { model } = this;
    if (!model) return;
    if (model.isReady) act(model);
    else
      void this.events.ready().then(() => {
        if (model.isReady && model === this.model) act(model);
      });
  }

  /** The first click has begun a cut, and the second one has taken it back. */
  private onDoubleClick(at: Pixel, modifiers: Modifiers): void {
    if (this.toolOf(modifiers) !== 'cut' || modifiers.shift) return;
    this.whenReady((model) => {
      if (this.paths) this.clear();
      else this.cutLoop(model, this.loopAt(model, at));
      this.aim.refresh();
    });
  }

  private cutLoop(model: SeamModel, loop: number[]): void {
    const count = model.cut(loop);
    if (count === 0) return;
    const what = SEAMS.cutLoop(count);
    this.events.say(what);
    this.events.changed(what);
  }

  private previewCut(model: SeamModel, at: Pixel | null): void {
    const place = this.placeAt(model, at);
    const { paths } = this;
    if (!paths) {
      this.previewStart(model, place, at ? this.loopAt(model, at) : []);
      return;
    }
    const isKnown = place >= 0 && paths.hasReached(place);
    const path = isKnown ? paths.to(place) : [];
    const vertices = Uint32Array.from([paths.start, ...listed(place)]);
    const toEnd = isTouch() ? SEAMS.toEndCutByTouch : SEAMS.toEndCut;
    const text =
      path.length > 0
        ? SEAMS.cutTo(paths.start, place, path.length, paths.distanceTo(place))
        : toEnd(paths.start);
    this.mark({ ...NO_MARKS, cut: endsIn(model, model.alike(path)), vertices }, text);
  }

  private previewStart(model: SeamModel, place: number, loop: number[]): void {
    const begin = this.tools.isPainting ? SEAMS.paintHere : SEAMS.startHere;
    const start = place < 0 ? this.invitation('cut') : begin(place);
    const text = loop.length > 0 ? SEAMS.orCutLoop(start, loop.length) : start;
    this.mark(
      { ...NO_MARKS, offered: endsIn(model, model.alike(loop)), vertices: listed(place) },
      text,
    );
  }

  private previewJoin(model: SeamModel, at: Pixel | null, { shift }: Modifiers): void {
    this.previewEdges(model, this.seamAt(model, at, shift));
  }

  /** Marks edges that a click would remove from the seams. */
  previewEdges(model: SeamModel, edges: number[]): void {
    const vertices = this.paths ? Uint32Array.of(this.paths.start) : NO_MARKS.vertices;
    const isOwn = edges.some((e) => model.own[e]);
    if (edges.length === 0) this.mark({ ...NO_MARKS, vertices }, this.invitation('join'));
    else if (!isOwn) this.mark(NO_MARKS, SEAMS.neededHere(edges.length));
    else {
      const joined = endsIn(model, model.alike(edges));
      this.mark({ ...NO_MARKS, joined, vertices }, SEAMS.joinHere(edges.length));
    }
  }

  /**
   * The first click chooses where to begin, the second one cuts. `goesOn`: the next cut begins
   * where this one ends.
   */
  private cut(model: SeamModel, at: Pixel, goesOn: boolean): void {
    const place = this.placeAt(model, at);
    if (place < 0) return;
    if (!this.paths) {
      this.begin(model, place);
      this.begunOnEdge = this.loopAt(model, at).length > 0 ? at : null;
      this.events.say(SEAMS.started(place));
      return;
    }
    if (this.isSecondClick(at)) {
      this.clear();
      return;
    }
    const path = this.paths.to(place);
    const isSame = place === this.paths.start;
    if (path.length === 0 && !isSame) {
      this.events.say(SEAMS.notConnected(this.paths.start, place));
      return;
    }
    this.paths = null;
    if (goesOn && !isSame) this.begin(model, place);
    if (isSame) return;
    const count = model.cut(path);
    const what = SEAMS.cut(count);
    this.events.say(count > 0 ? what : SEAMS.alreadyCut);
    if (count > 0) this.events.changed(what);
  }

  /** The nearest vertex may not be that of the first click. */
  private isSecondClick({ x, y }: Pixel): boolean {
    const first = this.begunOnEdge;
    return first !== null && Math.hypot(x - first.x, y - first.y) <= DOUBLE_CLICK;
  }

  private begin(model: SeamModel, place: number): void {
    this.begunOnEdge = null;
    this.paths = new model.surface.aiming.ShortestPaths(model.graph, place);
    this.grow();
  }

  /** Finds the paths in parts, one per frame: all of them at once would block the page. */
  private grow(): void {
    if (this.isGrowing) return;
    this.isGrowing = true;
    requestAnimationFrame(() => {
      this.isGrowing = false;
      if (!this.paths) return;
      if (this.paths.grow(PLACES_PER_FRAME)) this.aim.refresh();
      else this.grow();
    });
  }

  private join(model: SeamModel, at: Pixel, { shift }: Modifiers): void {
    this.joinEdges(model, this.seamAt(model, at, shift));
  }

  /** Removes edges from the seams. */
  joinEdges(model: SeamModel, edges: number[]): void {
    if (edges.length === 0) return;
    const count = model.join(edges);
    const what = SEAMS.joined(count);
    this.events.say(count > 0 ? what : SEAMS.needed);
    if (count > 0) this.events.changed(what);
  }

  private placeAt(model: SeamModel, at: Pixel | null): number {
    if (!at) return -1;
    this.targets ??= model.surface.aiming.targetsOf(model);
    return model.surface.aiming.placeAt(model.surface, this.view.sight, at, this.targets.places);
  }

  /** The edges that a double-click would cut. */
  private loopAt(model: SeamModel, at: Pixel): number[] {
    const { aiming, solid } = model.surface;
    const edge = aiming.edgeAwayFromEnds(solid, model.graph, this.view.sight, at);
    return edge < 0 ? [] : model.loop(edge);
  }

  /** The edges of the seam that is aimed at, or with `isOne` only the edge itself. */
  private seamAt(model: SeamModel, at: Pixel | null, isOne: boolean): number[] {
    if (!at) return [];
    this.targets ??= model.surface.aiming.targetsOf(model);
    const { aiming, solid } = model.surface;
    const edge = aiming.edgeAt(solid, this.view.sight, at, model.graph.ends, this.targets.seams);
    if (edge < 0) return [];
    return isOne ? [edge] : model.run(edge);
  }

  private onKey(event: KeyboardEvent): void {
    if (event.key.toUpperCase() !== 'C' || event.ctrlKey || event.metaKey || event.altKey) return;
    if (!this.model) return;
    event.preventDefault();
    this.tools.togglePainting();
  }

  private onEscape(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || closesSomething(event)) return;
    if (this.painter?.cancel()) this.events.say(SEAMS.strokeCancelled);
    else if (this.paths) this.cancel();
    else if (!this.leavesTool(event)) return;
    event.stopPropagation();
  }

  /** Where the tool is used. A run in flight is cancelled first, and what is said is closed. */
  private leavesTool({ target }: KeyboardEvent): boolean {
    const isHere = target === this.view.canvas || this.tools.has(target);
    if (!isHere || document.body.ariaBusy || isMessageNext() || !this.tools.leave()) return false;
    this.events.say(SEAMS.toSelect);
    return true;
  }

  private cancel(): void {
    this.clear();
    this.events.say(SEAMS.cancelled);
  }
}

function listed(place: number): Uint32Array {
  return place < 0 ? new Uint32Array() : Uint32Array.of(place);
}

const endsIn = ({ graph, surface }: SeamModel, edges: number[]): Uint32Array =>
  surface.aiming.endsOf(graph, edges);
