import type { Outcome, Source } from '../model/model';
import { isMadeByHand, type Settings, sameSettings } from '../model/settings';

/** The open meshes with work by hand that is in no exported file. The browser asks before the page is closed with any. */
export class Unsaved {
  private readonly meshes = new Set<Source>();
  private readonly wanted = new WeakMap<Source, Settings[]>();
  private readonly exported = new WeakMap<Source, Settings[]>();

  /** `changed` is called when there is another answer for a mesh. */
  constructor(private readonly changed: () => void) {}

  has(source: Source): boolean {
    return this.meshes.has(source);
  }

  /** What is asked for now, of each kind of layout. */
  want(source: Source, wanted: Settings[]): void {
    this.wanted.set(source, wanted);
    this.update(source);
  }

  /** A file has this layout. */
  saved({ source, settings }: Outcome): void {
    this.exported.set(source, [...(this.exported.get(source) ?? []), settings]);
    this.update(source);
  }

  /** The mesh was closed. */
  drop(source: Source): void {
    this.wanted.delete(source);
    this.update(source);
  }

  private update(source: Source): void {
    const exported = this.exported.get(source) ?? [];
    const isUnsaved = (this.wanted.get(source) ?? []).some(
      (settings) =>
        isMadeByHand(settings) && !exported.some((saved) => sameSettings(saved, settings)),
    );
    if (isUnsaved === this.has(source)) return;
    if (isUnsaved) this.meshes.add(source);
    else this.meshes.delete(source);
    // Without a listener, browsers can show the page again at once when the user comes back.
    if (this.meshes.size > 0) window.addEventListener('beforeunload', askBefore);
    else window.removeEventListener('beforeunload', askBefore);
    this.changed();
  }
}

const askBefore = (event: Event) => event.preventDefault();
