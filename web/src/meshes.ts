import type { Abflat } from 'abflat';
import { element, showText } from './base/dom';
import { loadPart } from './base/load-part';
import { Notice } from './controls/notice';
import { Welcome } from './help/welcome';
import type { FileSource, Opened, Source } from './model/model';
import { MeshTabs } from './opening/mesh-tabs';
import { type OpenEvents, Opening } from './opening/open-mesh';
import { showSample } from './opening/samples';
import { titleOf } from './session/titles';
import { facesText } from './session/words';
import { ShownImage, type ShownImageEvents } from './shown/shown-image';
import { ShownLook } from './shown/shown-look';
import type { Views } from './view/views';
import { MESH_TABS } from './words/opening';
import { SHOWN } from './words/view';
import type { Workshop } from './workshop/workshop';

export interface MeshesEvents
  extends Omit<OpenEvents, 'joined' | 'images' | 'unzipped'>,
    ShownImageEvents {
  /** The mesh of another tab is wanted. */
  switchTo(source: Source): void;
  /** A mesh is not open any more. */
  closed(source: Source): void;
  /** Whether there is work by hand that is in no file. */
  isUnsaved(source: Source): boolean;
}

/** Where meshes come from, and the one on screen. */
export class Meshes {
  private readonly opening: Opening;
  private readonly tabs: MeshTabs;
  private readonly notice = new Notice({
    tabs: (sources) => this.tabs.add(sources),
    oneAtlas: (sources) => this.opening.join(sources),
  });
  private readonly look: ShownLook;
  private readonly image: ShownImage;
  private readonly welcome = new Welcome();
  private source: Source | null = null;

  constructor(
    private readonly abflat: () => Promise<Abflat>,
    private readonly workshop: Workshop,
    private readonly views: Views | null,
    events: MeshesEvents,
  ) {
    this.look = new ShownLook(workshop, this.notice);
    this.image = new ShownImage(views, this.notice, events);
    this.tabs = new MeshTabs({
      open: (source) => events.switchTo(source),
      mayClose: async (source) => !events.isUnsaved(source) || (await this.agrees(source)),
      closed: (source) => events.closed(source),
      isUnsaved: (source) => events.isUnsaved(source),
    });
    this.opening = new Opening({
      ...events,
      images: (files) => void this.image.open(files),
      joined: (sources, signal) => this.joined(sources, signal),
      unzipped: (archive) => workshop.unzipped(archive),
    });
  }

  /** The mesh on screen. */
  get shown(): Source | null {
    return this.source;
  }

  /** Whether it is open, shown or not. */
  has(source: Source): boolean {
    return source === this.source || this.tabs.has(source);
  }

  /** Other meshes may have work that is in no file. */
  updateTabs(): void {
    this.tabs.update();
  }

  /** A mesh was opened. `keepsLast`: the one before stays open in a tab. */
  show(opened: Opened, keepsLast: boolean): void {
    const { source, mesh, summary, drawing, gltf } = opened;
    this.source = source;
    this.tabs.show(source, keepsLast);
    if (source.kind === 'file') {
      this.notice.show(source, gltf?.remarks ?? [], this.tabs.has(source));
      this.welcome.done();
    } else this.notice.hide();
    if (this.views) void this.look.open(opened, this.views);
    this.views?.showMesh(drawing);
    this.showOpenSample();
    showTitle(source);
    showText(element('mesh-info', HTMLElement), facesText(mesh, summary));
  }

  /** Says what the user should know besides. */
  remark(remarks: string[]): void {
    for (const remark of remarks) this.notice.add(remark);
  }

  /** The mesh has another layout than its first one. */
  overtake(): void {
    this.notice.overtake();
  }

  /** Leaves out a sample that was chosen but could not be read, or was cancelled. */
  showOpenSample(): void {
    showSample(this.source?.kind === 'sample' ? this.source.name : null);
  }

  /** Ends what is being fetched or joined; returns whether there was anything. */
  stop(): boolean {
    return this.opening.stop();
  }

  private async agrees(source: Source): Promise<boolean> {
    const { ask } = await loadPart(import('./opening/question'));
    const { close, whatIsLost, closeIt } = MESH_TABS;
    const title = close(titleOf(source));
    return ask({ title, paragraphs: [whatIsLost], yes: closeIt, isRisky: true });
  }

  private async joined(sources: FileSource[], signal: AbortSignal): Promise<File> {
    const { oneFile } = await loadPart(import('./opening/one-atlas'));
    return oneFile(sources, { abflat: await this.abflat(), workshop: this.workshop }, signal);
  }
}

function showTitle(source: Source): void {
  const title = titleOf(source);
  const label = element('source', HTMLElement);
  // The list already shows a sample's name.
  showText(label, source.kind === 'file' ? title : '', title);
  document.title = SHOWN.pageTitle(title);
}
