// Texel densities that are painted on the mesh. Not part of the first load.

import { isChart } from '../arrange/charts';
import { element } from '../base/dom';
import type { FaceDensities } from '../model/face-densities';
import type { Outcome, Unwrapped } from '../model/model';
import { facesOfCharts, sameDensities, withDensity } from '../model/painted-densities';
import type { Surface } from '../seams/seam-model';
import { FaceOutline } from '../surface/face-outline';
import { FaceSurface } from '../surface/face-surface';
import type { ChartStates } from '../view/chart-flags';
import { NO_MARKS } from '../view/seam-overlay';
import type { Pixel } from '../view/sight';
import type { Views } from '../view/views';
import { DENSITIES, type Touched } from '../words/densities';
import { Brush, RADIUS } from './brush';
import { facesUnder } from './faces-under';

export interface DensityEvents {
  /** What is asked for now. */
  densities(): FaceDensities;
  changed(shown: Unwrapped, densities: FaceDensities, what: string): void;
  /** The surface of the mesh on screen; null if there is none to paint on. */
  surface(): Promise<Surface | null>;
  /** What is selected and hidden. */
  states(): ChartStates;
  /** Whether clicks on the mesh edit no seams. */
  isFree(): boolean;
  /** They are to edit none. */
  free(): void;
  say(text: string): void;
}

const NOTHING: ReadonlySet<number> = new Set();

/** The bar over the mesh of an atlas with which densities are painted on its faces. */
export class DensityPainting {
  private readonly bar = element('density-tools', HTMLElement);
  private readonly options = element('density-options', HTMLElement);
  private readonly paint = element('density-paint', HTMLButtonElement);
  private readonly factor = element('density-factor', HTMLSelectElement);
  private readonly whole = element('density-whole', HTMLButtonElement);
  private readonly erase = element('density-erase', HTMLButtonElement);
  private readonly clear = element('density-clear', HTMLButtonElement);
  private readonly hint = element('density-hint', HTMLElement);
  private outcome: Unwrapped | null = null;
  private painted: { mesh: unknown; surface: FaceSurface; outline: FaceOutline } | null = null;

  constructor(
    private readonly views: Views,
    private readonly events: DensityEvents,
  ) {
    this.factor.append(
      ...DENSITIES.factors.map(([text, value]) => new Option(text, String(value))),
    );
    this.factor.value = '2';
    this.paint.addEventListener('click', () => void this.turn(!this.isOn));
    for (const button of [this.whole, this.erase])
      button.addEventListener('click', () => {
        press(button, !isPressed(button));
        this.update();
      });
    this.clear.addEventListener('click', () => this.ask(undefined, DENSITIES.cleared));
    for (const view of ['mesh', 'layout'] as const)
      views.canvasOf(view).addEventListener('keydown', (event) => this.onKey(event));
    // A tool for seams ends painting.
    element('seam-tools', HTMLElement).addEventListener('click', () => this.give());
    new Brush(views, ['mesh'], {
      isOn: () => this.isOn && this.painted?.mesh === this.outcome?.mesh,
      under: (_, at) => this.under(at),
      erases: (isAlt) => isAlt !== isPressed(this.erase),
      aimed: (touched, erases) => this.preview(touched, erases),
      painted: (touched, erases) => this.finish(touched, erases),
    });
  }

  /** Shows the tools for an atlas; null: there is none. */
  show(outcome: Outcome | null): void {
    this.outcome = outcome?.mode === 'unwrap' ? outcome : null;
    this.bar.hidden = this.outcome === null;
    if (this.isOn) void this.turn(this.outcome !== null);
    this.update();
  }

  /** Other densities are asked for. */
  update(): void {
    this.clear.hidden = !this.isOn || this.events.densities() === undefined;
    this.hint.textContent = this.isOn ? this.invitation : '';
  }

  /** With a single island nothing is denser than the rest. */
  private get invitation(): string {
    const isAlone = this.outcome?.result.report.charts.length === 1;
    return isAlone ? DENSITIES.oneIsland : DENSITIES.invitation[this.kind];
  }

  /** What the brush touches. */
  private get kind(): Touched['kind'] {
    return isPressed(this.whole) ? 'island' : 'face';
  }

  private get isOn(): boolean {
    return isPressed(this.paint);
  }

  private get density(): number {
    return Number(this.factor.value);
  }

  private onKey(event: KeyboardEvent): void {
    if (this.isOn) this.give();
    if (event.key.toUpperCase() !== 'D' || event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.bar.hidden) return;
    event.preventDefault();
    void this.turn(!this.isOn);
  }

  private give(): void {
    if (this.isOn && !this.events.isFree()) void this.turn(false);
  }

  private async turn(isOn: boolean): Promise<void> {
    const isNew = isOn && !this.isOn;
    press(this.paint, isOn);
    this.options.hidden = !isOn;
    if (isNew) {
      this.events.free();
      this.views.showMeasure('texels');
    }
    this.preview(NOTHING, false);
    const mesh = this.outcome?.mesh;
    if (!isOn || !mesh || this.painted?.mesh === mesh) return;
    const made = await this.events.surface();
    if (mesh !== this.outcome?.mesh) return;
    if (!made) {
      void this.turn(false);
      this.events.say(DENSITIES.notPainted);
      return;
    }
    const surface = new FaceSurface(made.graph, made.solid, mesh.faces);
    this.painted = { mesh, surface, outline: new FaceOutline(surface) };
  }

  /** The numbers of islands, or of faces. */
  private under(at: Pixel): Set<number> {
    const { painted, outcome } = this;
    if (!painted || !outcome) return new Set();
    const { surface } = painted;
    const faces = facesUnder(surface, this.views.mesh.sight, at, RADIUS);
    if (this.kind === 'face') return faces;
    const { chartOfTriangle } = outcome.result;
    const charts = Array.from(faces, (face) => chartOfTriangle[surface.trianglesOf(face)[0]]);
    return new Set(charts.filter(isChart));
  }

  private preview(touched: ReadonlySet<number>, erases: boolean): void {
    this.update();
    const { kind, painted } = this;
    const states = this.events.states();
    // The islands that it would paint stand out in both views.
    const { hidden, invalid, stacked } = states;
    const touchedOnes = { selected: touched, hidden, hovered: null, invalid, stacked };
    this.views.showStates(kind === 'island' && touched.size > 0 ? touchedOnes : states);
    if (painted && kind === 'face' && touched.size > 0)
      this.views.mesh.markSeams(painted.surface.solid.points, {
        ...NO_MARKS,
        joined: painted.outline.around(touched),
      });
    else this.views.mesh.markSeams(new Float32Array(), NO_MARKS);
    if (touched.size === 0) return;
    const what = { count: touched.size, kind };
    this.hint.textContent = erases
      ? DENSITIES.erasing(what)
      : DENSITIES.painting(what, this.density);
  }

  private finish(touched: ReadonlySet<number>, erases: boolean): void {
    this.preview(NOTHING, false);
    const { outcome, kind } = this;
    if (!outcome) return;
    const faces = kind === 'island' ? facesOfCharts(outcome, touched) : touched;
    const before = this.events.densities();
    const density = erases ? 1 : this.density;
    const after = withDensity(before, outcome.mesh, faces, density);
    const what = { count: touched.size, kind };
    if (!sameDensities(before, after))
      this.ask(after, erases ? DENSITIES.erased(what) : DENSITIES.painted(what, density));
    else this.events.say(touched.size > 0 ? DENSITIES.unchanged : DENSITIES.noFace);
  }

  private ask(densities: FaceDensities, what: string): void {
    if (this.outcome) this.events.changed(this.outcome, densities, what);
  }
}

const isPressed = (button: HTMLButtonElement) => button.ariaPressed === 'true';

function press(button: HTMLButtonElement, isOn: boolean): void {
  button.ariaPressed = String(isOn);
}
