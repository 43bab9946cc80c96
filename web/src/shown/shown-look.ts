import { isTouch } from '../base/touch';
import type { Notice } from '../controls/notice';
import type { Opened } from '../model/model';
import type { Views } from '../view/views';
import { SHOWN } from '../words/view';
import type { Workshop } from '../workshop/workshop';

/** Bytes that the images of a mesh may take, and again on the graphics card of each view. */
const memoryFor = (isPhone: boolean) => (isPhone ? 2 ** 25 : 2 ** 27);

/** Shows how the mesh looks in its file, once that has been read. */
export class ShownLook {
  private opened: Opened | null = null;

  constructor(
    private readonly workshop: Workshop,
    private readonly notice: Notice,
  ) {}

  async open(opened: Opened, views: Views): Promise<void> {
    const { source } = opened;
    this.opened = opened;
    views.showAppearance(source, null);
    if (source.kind !== 'file') return;
    const isPhone = isTouch();
    const read = await this.workshop
      .appearance(source, opened, memoryFor(isPhone))
      .catch(() => ({ appearance: null, remarks: [SHOWN.noMaterials(source.name)] }));
    const { appearance, remarks } = read;
    if (this.opened !== opened) {
      for (const image of appearance?.images ?? []) image.close();
      return;
    }
    for (const remark of remarks) this.notice.add(remark);
    if (appearance) views.showAppearance(source, appearance);
  }
}
