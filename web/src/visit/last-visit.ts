import type { MeshSummary } from 'abflat';
import { forget, remember, remembered } from '../base/remember';
import { Stored } from '../base/stored';
import { hasUvs, type Opened, type Outcome, type Source } from '../model/model';
import type { Marks, Settings } from '../model/settings';
import { FIRST_SAMPLE } from '../opening/open-mesh';
import { titleOf } from '../session/titles';
import { VISIT } from '../words/opening';
import { fitting, SettingsLink } from './settings-link';
import { textOf } from './settings-text';
import {
  type Asked,
  askedOf,
  bytesOf,
  type KeptMesh,
  meshOf,
  settingsAskedFor,
  type Visit,
  visitOf,
} from './visit-record';

/** Of localStorage, which tells at once whether anything is kept. */
const KEY = 'abflat-visit';
/** In milliseconds: changes that follow faster are kept together. */
const PAUSE = 400;
/** Bytes of all files of a mesh. */
const MOST_BYTES = 3e8;

/** Why nothing is restored, for each mark but `kept`. */
const REMARKS: Record<string, string> = {
  restoring: VISIT.stoppedOpening,
  large: VISIT.tooLarge,
};

/** What was asked for since the mesh was written; it counts if that mesh is still there. */
interface Change {
  id: string;
  asked: Asked;
}

/** Keeps the mesh and what was asked for in this browser, and starts with them the next time. */
export class LastVisit {
  private readonly link: SettingsLink;
  private readonly stored = new Stored();
  /** What is being restored. */
  private found: Visit | null = null;
  private readonly remarks: string[] = [];
  private said = '';
  private mesh: { summary: MeshSummary; hasUvs: boolean } | null = null;
  /** The mesh that was written last, and its name among those of other pages. */
  private source: Source | null = null;
  private id = '';
  /** The id under which the browser has the mesh. */
  private writtenAs = '';
  /** What is not written yet. */
  private pending: { source: Source; asked: Asked } | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** Whether what is kept is of this visit, or gives way to it: the sample that a visit begins with replaces nothing. */
  private isKept = false;

  /** `followed`: the user has followed a link to other settings. */
  constructor(followed: (settings: Settings) => void) {
    this.link = new SettingsLink(() => {
      const { linked } = this.link;
      if (linked && this.mesh) followed(fitting(linked, this.mesh.summary, this.mesh.hasUvs));
    });
    window.addEventListener('pagehide', () => {
      this.giveUp();
      void this.write({ isLeaving: true });
    });
  }

  /** The mesh of the last visit; null if there is none to open, which is known at once for a first visit. */
  find(): Promise<Source | null> | null {
    const mark = remembered(KEY);
    if (mark === null || new URLSearchParams(location.search).has('url')) return null;
    return mark === 'kept' ? this.read() : this.drop(REMARKS[mark] ?? VISIT.unreadable);
  }

  private async read(): Promise<Source | null> {
    remember(KEY, 'restoring');
    try {
      const [id, mesh, asked, since] = await this.stored.read(['id', 'mesh', 'asked', 'since']);
      const change = since as Change | null | undefined;
      this.found = visitOf(mesh, change?.id === id ? change?.asked : asked);
      // It need not be written again.
      this.id = this.writtenAs = String(id);
      this.source = this.found.source;
      this.isKept = true;
      return this.found.source;
    } catch (error) {
      console.info('The last visit cannot be read:', error);
      return this.drop(VISIT.unreadable);
    }
  }

  /** What to ask for, now that a mesh was opened or is shown again; null: what the page does by itself. */
  opened(opened: Opened, isShownAgain: boolean): Settings | null {
    const { source, summary } = opened;
    const { link, found } = this;
    this.isKept ||= this.mesh !== null;
    this.mesh = { summary, hasUvs: hasUvs(opened) };
    const { linked } = link;
    this.said = '';
    if (found?.source !== source) this.giveUp();
    else {
      this.said = VISIT.restored(titleOf(source));
      if (!linked || textOf(linked) === found.asked.text) {
        link.linked = null;
        return settingsAskedFor(found.asked);
      }
    }
    if (isShownAgain) link.linked = null;
    return isShownAgain ? null : linked && fitting(linked, summary, this.mesh.hasUvs);
  }

  /** The user asks for something else. */
  changed(): void {
    this.link.linked = null;
  }

  /** Keeps what is on screen, with what is marked there. */
  keep(outcome: Outcome, marks: Marks): void {
    const { source } = outcome;
    this.link.show(outcome.settings);
    this.giveUp();
    this.pending = { source, asked: askedOf(outcome, marks) };
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.write(), source === this.source ? PAUSE : 0);
  }

  /** What to say of a mesh that was restored, once; '' of others. */
  takeSaid(): string {
    const { said } = this;
    this.said = '';
    return said;
  }

  /** What the user should know of the start, once. */
  takeRemarks(): string[] {
    const { link } = this;
    const remarks = [...this.remarks.splice(0), link.remark].filter(Boolean);
    link.remark = '';
    return remarks;
  }

  /** Nothing is being restored any more; the next visit may try. */
  giveUp(): void {
    if (this.found) remember(KEY, 'kept');
    this.found = null;
  }

  /** Whether this was the mesh of the last visit, which is then dropped. */
  failed(source: Source, message: string): boolean {
    if (this.found?.source !== source) return false;
    this.found = null;
    this.said = '';
    this.drop(VISIT.notRestored(titleOf(source), message));
    return true;
  }

  private drop(remark: string): null {
    this.remarks.push(remark);
    void this.clear();
    return null;
  }

  private async clear(): Promise<void> {
    forget(KEY);
    this.writtenAs = '';
    await this.stored
      .forget()
      .catch((error) => console.info('The last visit stays stored:', error));
  }

  private async write({ isLeaving = false } = {}): Promise<void> {
    clearTimeout(this.timer);
    const { pending } = this;
    if (!pending) return;
    const { source, asked } = pending;
    if (source !== this.source) this.id = `${Date.now()} ${Math.random()}`;
    this.source = source;
    const mesh = meshOf(source);
    const isLarge = bytesOf(mesh) > MOST_BYTES;
    // A first visit begins with this, too.
    const isUsual = mesh.kind === 'sample' && mesh.name === FIRST_SAMPLE && isNothing(asked);
    try {
      if (isUsual && !this.isKept) return;
      this.isKept = !isUsual;
      const isCleared = isUsual || isLarge;
      const done = isCleared ? this.clear() : this.put(mesh, asked, isLeaving);
      if (isLarge) remember(KEY, 'large');
      await done;
      if (!isCleared) remember(KEY, 'kept');
    } catch (error) {
      // Storage is off or full, or a file is gone: everything else works, and no earlier mesh comes back in its place.
      console.info('This visit is not kept:', error);
      await this.clear();
    } finally {
      if (this.pending === pending) this.pending = null;
    }
  }

  /** Another page may have put its own in the meantime. A page that is being left cannot look first. */
  private async put(mesh: KeptMesh, asked: Asked, isLeaving: boolean): Promise<void> {
    const { id } = this;
    const isThere =
      this.writtenAs === id && (isLeaving || (await this.stored.read(['id']))[0] === id);
    const since: Change = { id, asked };
    await this.stored.write(isThere ? { since } : { id, mesh, asked, since: null });
    this.writtenAs = id;
  }
}

const isNothing = ({ text, edited, atlas, pins }: Asked) =>
  text === '' && !edited && !atlas && !pins;
