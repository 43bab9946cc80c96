import { element } from '../base/dom';
import type { FileSource, Opened } from '../model/model';
import { UV_SETS } from '../words/opening';

/**
 * Which texcoord set of a glTF is shown, and seams and kept islands refer to; only offered where it
 * has several.
 */
export class ReadTexcoord {
  private readonly selects = ['read-texcoord', 'pack-texcoord'].map((id) =>
    element(id, HTMLSelectElement),
  );
  private source: FileSource | null = null;

  /** `wanted`: the same file, read with another set. */
  constructor(wanted: (source: FileSource) => void) {
    for (const select of this.selects)
      select.addEventListener('change', () => {
        if (!this.source) return;
        const { kind, name, file, others } = this.source;
        const texcoord = Number(select.value);
        // Until it is read, the set is the one on screen.
        select.value = String(this.source.texcoord ?? 0);
        const other: FileSource = { kind, name, file, others, together: [], texcoord };
        other.together.push(other);
        wanted(other);
      });
  }

  open({ source, gltf }: Opened): void {
    // A file that has others may lack the first.
    const sets = [...new Set([0, ...(gltf?.texcoordSets ?? [])])];
    this.source = source.kind === 'file' ? source : null;
    for (const select of this.selects) {
      select.hidden = sets.length < 2;
      select.replaceChildren(...sets.map((set) => new Option(UV_SETS.read(set), String(set))));
      select.value = String(this.source?.texcoord ?? 0);
    }
  }
}
