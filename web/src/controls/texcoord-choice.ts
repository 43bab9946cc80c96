import { element } from '../base/dom';
import type { Outcome } from '../model/model';
import { UV_SETS } from '../words/opening';

/** Nobody uses more of them. */
const OFFERED = 8;

/** Which texcoord set of a glTF gets the new coordinates. */
export class TexcoordChoice {
  private readonly select = element('texcoord', HTMLSelectElement);
  /** What the user chose for the open file; null if nothing yet. */
  private chosen: number | null = null;

  constructor() {
    this.select.addEventListener('change', () => {
      this.chosen = Number(this.select.value);
    });
  }

  /**
   * Takes the result that would be exported, or null. `isNew`: it is of a file that was not open
   * before.
   */
  show(outcome: Outcome | null, isNew: boolean): void {
    if (isNew) this.chosen = null;
    const gltf = outcome?.gltf;
    this.select.hidden = !gltf;
    if (!outcome || !gltf) return;
    const { freeTexcoord, texcoordSets } = gltf;
    const count = Math.max(OFFERED, freeTexcoord + 1);
    const names = Array.from({ length: count }, (_, set) =>
      texcoordSets.includes(set) ? UV_SETS.replaced(set) : UV_SETS.added(set),
    );
    this.select.replaceChildren(...names.map((name, set) => new Option(name, String(set))));
    this.select.value = String(this.chosen ?? usual(outcome, freeTexcoord));
  }

  /** The set to write. */
  get texcoord(): number {
    return this.select.hidden ? 0 : Number(this.select.value);
  }
}

/** What keeps its uv keeps it in the set that was read. */
function usual({ settings, source }: Outcome, free: number): number {
  const isKept =
    ('fixedFaces' in settings && settings.fixedFaces) ||
    ('keepPlaces' in settings && settings.keepPlaces);
  return isKept ? (source.kind === 'file' && source.texcoord) || 0 : free;
}
