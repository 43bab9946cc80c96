import { element, showText } from '../base/dom';
import { refusal } from '../controls/number-field';
import { SEAM_SOURCES } from '../words/seams';
import type { Offered, SeamChoice, SeamSources } from './seam-choice';

const NO_SOURCES: SeamSources = {
  auto: false,
  hard: false,
  uv: false,
  material: false,
  sharp: null,
};
const USUAL_SHARP = 60;
const SWITCHES = ['auto', 'hard', 'uv', 'material'] as const;

/** Where seams come from: switches that can be combined. */
export class SourceControl {
  private readonly switches = SWITCHES.map((name) => element(`seams-${name}`, HTMLButtonElement));
  private readonly sharp = element('seams-sharp', HTMLButtonElement);
  private readonly degrees = element('sharp-degrees', HTMLInputElement);
  private readonly degreesBox = element('sharp-box', HTMLElement);
  private readonly state = element('seams-state', HTMLElement);
  private sources: SeamSources = NO_SOURCES;
  private angle = USUAL_SHARP;

  constructor(
    private readonly changed: (sources: SeamSources) => void,
    say: (text: string) => void,
  ) {
    this.switches.forEach((button, i) => {
      const name = SWITCHES[i];
      button.addEventListener('click', () =>
        changed({ ...this.sources, [name]: !this.sources[name] }),
      );
    });
    this.sharp.addEventListener('click', () =>
      changed({ ...this.sources, sharp: this.sources.sharp === null ? this.angle : null }),
    );
    this.degrees.valueAsNumber = this.angle;
    this.degrees.addEventListener('input', () => this.readDegrees());
    this.degrees.addEventListener('change', () => {
      if (this.degrees.ariaInvalid === 'true')
        say(
          refusal(
            SEAM_SOURCES.sharpAngle,
            this.degrees.value,
            SEAM_SOURCES.sharpRange,
            SEAM_SOURCES.degrees(this.angle),
          ),
        );
      this.degrees.valueAsNumber = this.angle;
      this.degrees.setAttribute('aria-invalid', 'false');
    });
  }

  offer(offered: Offered): void {
    for (const name of ['hard', 'uv', 'material'] as const)
      this.switches[SWITCHES.indexOf(name)].hidden = !offered[name];
  }

  /** While edges are listed, no source counts; pressing one starts over with it. */
  show({ sources, edges, isCutFurther }: SeamChoice): void {
    this.sources = edges ? NO_SOURCES : sources;
    this.switches.forEach((button, i) => {
      button.setAttribute('aria-pressed', String(this.sources[SWITCHES[i]]));
    });
    const { sharp } = this.sources;
    this.sharp.setAttribute('aria-pressed', String(sharp !== null));
    this.degreesBox.hidden = sharp === null;
    if (sharp !== null && document.activeElement !== this.degrees) {
      this.angle = sharp;
      this.degrees.valueAsNumber = sharp;
    }
    showText(this.state, stateText(this.sources, edges, isCutFurther));
  }

  private readDegrees(): void {
    const angle = this.degrees.valueAsNumber;
    const isUsable = angle > 0 && angle <= 180;
    this.degrees.setAttribute('aria-invalid', String(!isUsable));
    if (!isUsable || angle === this.angle) return;
    this.angle = angle;
    this.changed({ ...this.sources, sharp: angle });
  }
}

function stateText(sources: SeamSources, edges: Uint32Array | null, isCutFurther = false): string {
  if (edges) return SEAM_SOURCES.edited(edges.length / 2, isCutFurther);
  const isAny = SWITCHES.some((name) => sources[name]) || sources.sharp !== null;
  return isAny ? '' : SEAM_SOURCES.none;
}
