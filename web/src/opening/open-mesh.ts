import { element, isTyping } from '../base/dom';
import { OPENED_FILES } from '../base/mesh-files';
import type { FileSource, Source } from '../model/model';
import { JOINING, UNPACKING } from '../words/opening';
import { placeOf } from './address';
import { areImages, isZip, noMesh, sourcesOf } from './chosen-files';
import { filesOf } from './dropped-files';
import { FromWeb } from './from-web';
import { type GatherEvents, Gathering } from './gathering';
import { bindLaunch } from './launched-files';
import { pastedIn } from './pasted-text';
import { Samples } from './samples';

export const FIRST_SAMPLE = 'head';

export interface OpenEvents extends Pick<GatherEvents, 'gathering' | 'gathered'> {
  open(source: Source): void;
  /** Images without a mesh, to be shown on the one that is open. */
  images(files: File[]): void;
  /** None of the chosen files can be opened; `reason` is for display. */
  refused(reason: string): void;
  /** Makes one file of several meshes. */
  joined(sources: FileSource[], signal: AbortSignal): Promise<File>;
  /** The files in an archive. */
  unzipped(archive: File): Promise<File[]>;
}

/** Binds the ways to choose a mesh: drop, paste, file dialog, samples, a link and "Open with" of the system. */
export class Opening {
  private readonly gathering: Gathering;
  private readonly web: FromWeb;

  constructor(private readonly events: OpenEvents) {
    const openFiles = (files: File[]) => this.openFiles(files);
    const { refused } = events;
    this.gathering = new Gathering({ ...events, files: openFiles });
    this.web = new FromWeb(this.gathering, refused);
    bindDialog(openFiles);
    new Samples({
      made: (name) => this.open({ kind: 'sample', name }),
      file: (url) => this.web.fetch(placeOf(url, location.href)),
    });
    bindDrop(openFiles, refused);
    bindPaste(openFiles, (text) => this.web.open(text));
    bindLaunch(openFiles, refused);
    const linked = new URLSearchParams(location.search).get('url');
    // Not before the page is complete.
    if (linked) queueMicrotask(() => this.web.open(linked));
  }

  /** Opens several meshes as one, to share an atlas. */
  join(sources: FileSource[]): void {
    this.gathering.start({
      name: JOINING.meshes(sources.length),
      doing: JOINING.joining(sources.length),
      task: async (signal) => [await this.events.joined(sources, signal)],
    });
  }

  /** Ends what is being fetched or joined; returns whether there was anything. */
  stop(): boolean {
    return this.gathering.stop();
  }

  private open(source: Source): void {
    this.gathering.stop();
    this.events.open(source);
  }

  private openFiles(files: File[]): void {
    if (files.length === 0) return;
    const [source] = sourcesOf(files);
    if (files.some(isZip)) this.unpack(files);
    else if (areImages(files)) this.events.images(files);
    else if (source) this.open(source);
    else this.events.refused(noMesh(files));
  }

  /** Opens what archives hold, with the files beside them. */
  private unpack(files: File[]): void {
    const { name } = files.filter(isZip)[0];
    const contentOf = (file: File) => (isZip(file) ? this.events.unzipped(file) : [file]);
    this.gathering.start({
      name,
      doing: UNPACKING(name),
      task: async () => (await Promise.all(files.map(contentOf))).flat(),
    });
  }
}

type OpenFiles = (files: File[]) => void;

function bindDialog(openFiles: OpenFiles): void {
  const input = element('file', HTMLInputElement);
  // Beside what may come with a mesh.
  input.accept = [...OPENED_FILES.map(({ ending }) => ending), input.accept].join();
  element('open', HTMLButtonElement).addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    openFiles([...(input.files ?? [])]);
    // So that choosing the same file again still fires a change event.
    input.value = '';
  });
}

function bindDrop(openFiles: OpenFiles, refused: (reason: string) => void): void {
  const overlay = element('drop', HTMLElement);
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  window.addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    overlay.hidden = false;
  });
  window.addEventListener('dragleave', (event) => {
    // Without a related target, the pointer has left the window and not just an element in it.
    if (!event.relatedTarget) overlay.hidden = true;
  });
  window.addEventListener('drop', (event) => {
    if (!event.dataTransfer || !hasFiles(event)) return;
    event.preventDefault();
    overlay.hidden = true;
    filesOf(event.dataTransfer).then(openFiles, (error: Error) => refused(error.message));
  });
}

/** What is pasted into a field or above the page is not for the page. */
function bindPaste(openFiles: OpenFiles, openAddress: (text: string) => void): void {
  window.addEventListener('paste', (event) => {
    const { clipboardData: data, target } = event;
    if (!data || isTyping(target) || (target instanceof Element && target.closest('dialog')))
      return;
    const files = [...data.files];
    const text = files.length > 0 ? '' : data.getData('text/plain');
    const pasted = pastedIn(text);
    if (files.length === 0 && !pasted) return;
    event.preventDefault();
    if (pasted?.kind === 'address') openAddress(pasted.text);
    else openFiles(pasted ? [new File([text], pasted.name)] : files);
  });
}
