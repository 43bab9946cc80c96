import { element } from '../base/dom';
import { download } from '../base/download';
import { READING } from '../words/opening';
import { SEAM_FILES } from '../words/seams';

export interface SeamFileEvents {
  /** The text to save; null if there is none, which has been said. */
  text(): Promise<string | null>;
  /** The name of the mesh that it belongs to. */
  meshName(): string;
  /** A file was chosen; the returned function takes its text. */
  chosen(name: string): (text: string) => void;
  failed(sentence: string): void;
  say(text: string): void;
}

/** The buttons that save seams to a file and open one. */
export class SeamFiles {
  private readonly buttons = [
    element('seams-save', HTMLButtonElement),
    element('seams-open', HTMLButtonElement),
  ];

  constructor(events: SeamFileEvents) {
    const [save, open] = this.buttons;
    const input = element('seams-file', HTMLInputElement);
    save.addEventListener('click', async () => {
      const name = `${events.meshName().replace(/\.[^.]*$/, '')}-seams.txt`;
      const text = await events.text();
      if (text === null) return;
      download(name, 'text/plain', text);
      events.say(SEAM_FILES.saved(name));
    });
    open.addEventListener('click', () => input.click());
    input.addEventListener('change', () => {
      const file = input.files?.[0];
      if (file)
        file
          .text()
          .then(events.chosen(file.name), ({ message }: Error) =>
            events.failed(READING.unreadable(file.name, message)),
          );
      // So that choosing the same file again still fires a change event.
      input.value = '';
    });
  }

  setEnabled(isEnabled: boolean): void {
    for (const button of this.buttons) button.disabled = !isEnabled;
  }
}
