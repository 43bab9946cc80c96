import { element } from '../base/dom';
import type { FileSource, Opened } from '../model/model';
import { UV_SETS } from '../words/opening';

/** Which texcoord set of a glTF seams and kept islands refer to; only shown where it has several. */
export class ReadTexcoord {
  private readonly select = element('read-texcoord', HTMLSelectElement);
  private source: FileSource | null = null;

  /** `wanted`: the same file, read with another set. */
  constructor(wanted: (source: FileSource) => void) {
    this.select.addEventListener('change', () => {
      if (!this.source) return;
      const { kind, name, file, others } = this.source;
      const texcoord = Number(this.select.value);
      // Until it is read, the set is the one on screen.
      this.select.value = String(this.source.texcoord ?? 0);
      const other: FileSource = { kind, name, file, others, together: [], texcoord };
      other.together.push(other);
      wanted(other);
    });
  }

  open({ source, gltf }: Opened): void {
    const sets = gltf?.texcoordSets ?? 0;
    this.source = source.kind === 'file' ? source : null;
    this.select.hidden = sets < 2;
    this.select.replaceChildren(
      ...Array.from({ length: sets }, (_, set) => new Option(UV_SETS.read(set), String(set))),
    );
    this.select.value = String(this.source?.texcoord ?? 0);
  }
}
