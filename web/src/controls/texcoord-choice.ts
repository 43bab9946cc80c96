import { element } from '../base/dom';
import type { Outcome } from '../model/model';
import { UV_SETS } from '../words/opening';

/** Which texcoord set of a glTF gets the new coordinates; only shown where it has some, or textures. */
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
    const { freeTexcoord: free = 0, texcoordSets = 0 } = outcome?.gltf ?? {};
    this.select.hidden = free === 0 && texcoordSets === 0;
    if (!outcome || this.select.hidden) return;
    const added = Math.max(free, texcoordSets);
    const replaced = Array.from({ length: Math.max(1, texcoordSets) }, (_, set) => set);
    this.select.replaceChildren(
      new Option(UV_SETS.added(added), String(added)),
      ...replaced.map((set) => new Option(UV_SETS.replaced(set), String(set))),
    );
    this.select.value = String(this.chosen ?? usual(outcome, free));
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
