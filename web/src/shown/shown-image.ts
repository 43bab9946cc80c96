import { hideAlert } from '../base/alert';
import { loadPart, reasonOf } from '../base/load-part';
import type { Notice } from '../controls/notice';
import type { Views } from '../view/views';
import { OWN_IMAGE } from '../words/looks';
import { SHOWN } from '../words/view';

export const ownImages = () => loadPart(import('../files/own-image'));

export interface ShownImageEvents {
  say(text: string): void;
  refused(reason: string): void;
}

/** Shows images of the user's own in both views. They belong to the page: every mesh gets the last one. */
export class ShownImage {
  private wanted: File | null = null;

  constructor(
    private readonly views: Views | null,
    private readonly notice: Notice,
    private readonly events: ShownImageEvents,
  ) {
    views?.onImage({
      imagePicked: (file) => void this.open([file]),
      imageReached: () => events.say(OWN_IMAGE.pressEnter),
    });
  }

  /** The first of these images; the latest call wins. */
  async open(files: File[]): Promise<void> {
    const { views, events } = this;
    const [file] = files;
    this.wanted = file;
    if (!views) {
      events.refused(SHOWN.noWebGl);
      return;
    }
    try {
      const { ownImage } = await ownImages();
      const { image, remark } = await ownImage(file, views.mostTexels);
      if (this.wanted !== file) {
        image.close();
        return;
      }
      hideAlert();
      views.showImage(file.name, image);
      events.say(OWN_IMAGE.shown(file.name));
      if (files.length > 1) this.notice.add(OWN_IMAGE.oneOfMany(file.name, files.length));
      if (remark) this.notice.add(remark);
    } catch (error) {
      if (this.wanted === file) events.refused(reasonOf(error as Error));
    }
  }
}
