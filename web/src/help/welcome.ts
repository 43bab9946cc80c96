import { element } from '../base/dom';
import { remember, remembered } from '../base/remember';

const KEY = 'abflat-opened';

/** A sentence for who has never opened a mesh of their own. */
export class Welcome {
  private readonly text = element('welcome', HTMLElement);

  constructor() {
    this.text.hidden = remembered(KEY) !== null;
  }

  /** A mesh of the user's own was opened. */
  done(): void {
    if (this.text.hidden) return;
    this.text.hidden = true;
    remember(KEY, 'yes');
  }
}
