import { element } from '../base/dom';
import { SHADINGS } from '../words/view';

/** Keys with which an entry is chosen; any other key that changes a list only goes through it. */
const CHOOSING = ['', 'Enter', ' '];

export interface ImageEvents {
  imagePicked(file: File): void;
  /** The entry that asks for a file was reached by keys; Enter is still needed. */
  imageReached(): void;
}

/**
 * The entries of the list of shadings for an image of the user's own: the image, once there is one,
 * and below it the entry that asks for a file.
 */
export class ImageChoice {
  private readonly input = element('image-file', HTMLInputElement);
  private readonly image = new Option('', 'image');
  /** The last key that was pressed in the list; '' after a click. */
  private key = '';

  /** `leave`: shows in the list what is shown in the views. */
  constructor(
    private readonly list: HTMLSelectElement,
    private readonly leave: () => void,
    private readonly events: ImageEvents,
  ) {
    list.addEventListener('pointerdown', () => {
      this.key = '';
    });
    list.addEventListener('keydown', (event) => {
      this.key = event.key;
      if (event.key !== 'Enter' || !this.isAsking) return;
      event.preventDefault();
      this.ask();
    });
    list.addEventListener('blur', () => {
      this.key = '';
      if (this.isAsking) leave();
    });
    this.input.addEventListener('change', () => {
      const [file] = this.input.files ?? [];
      if (file) events.imagePicked(file);
      // So that choosing the same file again still fires a change event.
      this.input.value = '';
    });
  }

  /** Whether the entry that asks for a file is chosen in the list. */
  get isAsking(): boolean {
    return this.list.value === 'ask';
  }

  /** The entry that asks for a file is chosen now. */
  reached(): void {
    if (CHOOSING.includes(this.key)) this.ask();
    else this.events.imageReached();
  }

  /** Lists the image. */
  offer(name: string): void {
    const asking = this.list.options[this.list.options.length - 1];
    this.image.textContent = SHADINGS.image(name);
    asking.textContent = SHADINGS.otherImage;
    if (!this.image.parentNode) asking.before(this.image);
  }

  private ask(): void {
    // Before the dialog: one that is cancelled has changed nothing.
    this.leave();
    this.input.click();
  }
}
