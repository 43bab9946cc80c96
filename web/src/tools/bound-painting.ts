import type { VertexBound } from 'abflat';
import { showAlert } from '../base/alert';
import { element } from '../base/dom';
import { loadPart, reasonOf } from '../base/load-part';
import { LEAST, MOST, meaning, STEP } from '../controls/bound-control';
import { differences, type VertexBounds, withBound, withoutBound } from '../mesh/vertex-bounds';
import type { Outcome } from '../model/model';
import type { Solid } from '../surface/solid';
import type { Views } from '../view/views';
import { BOUNDS } from '../words/controls';
import { ownBoundsText } from '../words/format';
import type { Workshop } from '../workshop/workshop';
import { boundaryUnder } from './boundary-under';
import { Brush } from './brush';

export interface PaintingEvents {
  /** What is asked for now. */
  bounds(): VertexBounds;
  changed(bounds: VertexBound[], what: string): void;
  say(text: string): void;
}

/** The bar below a disk with which bounds are painted on its boundary. */
export class BoundPainting {
  private readonly bar = element('bound-tools', HTMLElement);
  private readonly options = element('bound-options', HTMLElement);
  private readonly paint = element('bound-paint', HTMLButtonElement);
  private readonly erase = element('bound-erase', HTMLButtonElement);
  private readonly clear = element('bound-clear', HTMLButtonElement);
  private readonly slider = element('bound-t', HTMLInputElement);
  private readonly value = element('bound-t-value', HTMLOutputElement);
  private readonly hint = element('bound-hint', HTMLElement);
  private brush: Brush | null = null;
  private outcome: Outcome | null = null;
  /** The mesh on screen, once the brush has asked for it. */
  private solid: { mesh: unknown; solid: Solid } | null = null;

  constructor(
    private readonly views: Views,
    private readonly workshop: Workshop,
    private readonly events: PaintingEvents,
  ) {
    this.slider.min = String(LEAST);
    this.slider.max = String(MOST);
    this.slider.step = String(STEP);
    this.slider.value = '1';
    this.slider.addEventListener('input', () => this.showValue());
    this.paint.addEventListener('click', () => this.toggle());
    this.erase.addEventListener('click', () => press(this.erase, !isPressed(this.erase)));
    this.clear.addEventListener('click', () => this.events.changed([], BOUNDS.cleared));
    for (const view of ['mesh', 'layout'] as const)
      views.canvasOf(view).addEventListener('keydown', (event) => this.onKey(event));
    this.showValue();
  }

  /** Shows the tools for a disk; null: there is none. */
  show(outcome: Outcome | null): void {
    this.outcome = outcome?.mode === 'flatten' ? outcome : null;
    this.bar.hidden = this.outcome === null;
    if (this.bar.hidden) this.turn(false);
    if (this.isOn) this.prepare();
    this.update();
  }

  /** Other bounds are asked for. */
  update(): void {
    const bounds = this.outcome ? this.events.bounds() : [];
    this.views.markBounds(bounds);
    this.clear.hidden = bounds.length === 0;
    this.hint.textContent = this.isOn ? BOUNDS.invitation : '';
    if (!this.isOn && bounds.length > 0) this.hint.textContent = ownBoundsText(bounds.length);
  }

  private get isOn(): boolean {
    return isPressed(this.paint);
  }

  private get t(): number {
    return this.slider.valueAsNumber;
  }

  private showValue(): void {
    this.value.textContent = BOUNDS.value(this.t, meaning(this.t));
    this.slider.setAttribute('aria-valuetext', this.value.textContent);
    this.slider.style.setProperty('--value', String((this.t - LEAST) / (MOST - LEAST)));
  }

  private onKey(event: KeyboardEvent): void {
    if (event.key.toUpperCase() !== 'B' || event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.bar.hidden) return;
    event.preventDefault();
    this.toggle();
  }

  private toggle(): void {
    this.turn(!this.isOn);
    if (this.isOn) this.prepare();
    this.update();
  }

  private turn(isOn: boolean): void {
    press(this.paint, isOn);
    this.options.hidden = !isOn;
  }

  private prepare(): void {
    this.load().catch((error: Error) => {
      this.turn(false);
      showAlert(BOUNDS.notPainted(reasonOf(error)));
    });
  }

  private async load(): Promise<void> {
    const mesh = this.outcome?.mesh;
    if (!mesh) return;
    const { Solid } = await loadPart(import('../surface/solid'));
    this.brush ??= new Brush(this.views, ['mesh', 'layout'], {
      isOn: () => this.isOn,
      under: (view, at) => {
        const { solid, outcome } = this;
        const own = solid?.mesh === outcome?.mesh ? (solid?.solid ?? null) : null;
        return boundaryUnder(this.views, own, view, at);
      },
      erases: (isAlt) => isAlt !== isPressed(this.erase),
      aimed: (aimed, erases) => this.preview(aimed, erases),
      painted: (painted, erases) => this.finish(painted, erases),
    });
    if (this.solid?.mesh === mesh) return;
    const { solid } = await this.workshop.surface(mesh, true);
    if (mesh === this.outcome?.mesh) this.solid = { mesh, solid: new Solid(solid) };
  }

  private after(painted: ReadonlySet<number>, erases: boolean): VertexBound[] {
    const bounds = this.events.bounds();
    return erases ? withoutBound(bounds, painted) : withBound(bounds, painted, this.t);
  }

  private preview(aimed: ReadonlySet<number>, erases: boolean): void {
    const bounds = this.after(aimed, erases);
    this.views.markBounds(bounds);
    const { size } = aimed;
    const value = this.value.textContent;
    const what = erases ? BOUNDS.erasing(size) : BOUNDS.painting(size, value);
    this.hint.textContent = size > 0 ? what : BOUNDS.invitation;
  }

  private finish(painted: ReadonlySet<number>, erases: boolean): void {
    const bounds = this.after(painted, erases);
    const count = differences(this.events.bounds(), bounds);
    if (count === 0) {
      this.update();
      this.events.say(painted.size > 0 ? BOUNDS.unchanged : BOUNDS.noBoundary);
      return;
    }
    this.events.changed(bounds, erases ? BOUNDS.erased(count) : BOUNDS.painted(count));
  }
}

const isPressed = (button: HTMLButtonElement) => button.ariaPressed === 'true';

function press(button: HTMLButtonElement, isOn: boolean): void {
  button.ariaPressed = String(isOn);
}
