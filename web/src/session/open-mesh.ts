import { SAMPLE_NAMES } from 'abflat';
import { element } from '../base/dom';
import type { Source } from '../model/model';
import { noMesh, sourcesOf } from './chosen-files';
import { filesOf } from './dropped-files';
import { bindLaunch } from './launched-files';

export const FIRST_SAMPLE = 'head';

/** "wavy-strip" as "Wavy strip". */
function sampleTitle(name: string): string {
  const words = name.replaceAll('-', ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

export function titleOf(source: Source): string {
  return source.kind === 'sample' ? sampleTitle(source.name) : source.name;
}

export interface OpenEvents {
  open(source: Source): void;
  /** None of the chosen files can be opened; `reason` is for display. */
  refused(reason: string): void;
}

/** Binds the ways to choose a mesh: drop, paste, file dialog, samples and "Open with" of the system. */
export function bindOpen(events: OpenEvents): void {
  const openFiles = (files: File[]) => {
    if (files.length === 0) return;
    const [source] = sourcesOf(files);
    if (source) events.open(source);
    else events.refused(noMesh(files));
  };
  bindDialog(openFiles);
  bindSamples((name) => events.open({ kind: 'sample', name }));
  bindDrop(openFiles, events.refused);
  bindPaste(openFiles);
  bindLaunch(openFiles, events.refused);
}

type OpenFiles = (files: File[]) => void;

/** Shows which sample is open; none for a file. */
export function showSample(name: string | null): void {
  element('sample', HTMLSelectElement).value = name ?? '';
}

function bindDialog(openFiles: OpenFiles): void {
  const input = element('file', HTMLInputElement);
  element('open', HTMLButtonElement).addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    openFiles([...(input.files ?? [])]);
    // So that choosing the same file again still fires a change event.
    input.value = '';
  });
}

function bindSamples(openSample: (name: string) => void): void {
  const select = element('sample', HTMLSelectElement);
  const none = new Option('Samples', '');
  none.disabled = true;
  select.append(
    none,
    ...[...new Set(SAMPLE_NAMES)].map((name) => new Option(sampleTitle(name), name)),
  );
  select.value = '';
  select.addEventListener('change', () => openSample(select.value));
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

function bindPaste(openFiles: OpenFiles): void {
  window.addEventListener('paste', (event) => {
    const files = [...(event.clipboardData?.files ?? [])];
    if (files.length === 0) return;
    event.preventDefault();
    openFiles(files);
  });
}
