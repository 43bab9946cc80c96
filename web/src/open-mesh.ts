import { SAMPLE_NAMES } from 'abflat';
import { element } from './dom';
import type { Source } from './session';

export const FIRST_SAMPLE = 'head';

/** "wavy-strip" as "Wavy strip". */
function sampleTitle(name: string): string {
  const words = name.replaceAll('-', ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

export function titleOf(source: Source): string {
  return source.kind === 'sample' ? sampleTitle(source.name) : source.name;
}

/** Drop, file dialog and samples: three ways to choose a mesh. */
export function bindOpen(open: (source: Source) => void): void {
  const openFiles = (list: FileList | null | undefined) => {
    const files = [...(list ?? [])];
    const file = files.find(({ name }) => /\.gltf$/i.test(name)) ?? files[0];
    const others = files.filter((other) => other !== file);
    if (file) open({ kind: 'file', name: file.name, file, others });
  };
  bindDialog(openFiles);
  bindSamples((name) => open({ kind: 'sample', name }));
  bindDrop(openFiles);
}

type OpenFiles = (files: FileList | null | undefined) => void;

/** Shows which sample is open; none for a file. */
export function showSample(name: string | null): void {
  element('sample', HTMLSelectElement).value = name ?? '';
}

function bindDialog(openFiles: OpenFiles): void {
  const input = element('file', HTMLInputElement);
  element('open', HTMLButtonElement).addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    openFiles(input.files);
    // So that choosing the same file again is a change.
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

function bindDrop(openFiles: OpenFiles): void {
  const overlay = element('drop', HTMLElement);
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  window.addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    overlay.hidden = false;
  });
  window.addEventListener('dragleave', (event) => {
    // Without a related target the pointer has left the window, not just an element in it.
    if (!event.relatedTarget) overlay.hidden = true;
  });
  window.addEventListener('drop', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    overlay.hidden = true;
    openFiles(event.dataTransfer?.files);
  });
}
