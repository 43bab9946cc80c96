import type { MeshSummary, StatusName } from 'abflat';
import { element } from '../base/dom';
import type { Mode } from '../model/settings';
import { DISK_NEEDS, NO_DISK } from '../words/controls';
import { sentence } from '../words/format';

const MODES: Mode[] = ['flatten', 'unwrap', 'pack'];

const NEEDS: Partial<Record<StatusName, string>> = DISK_NEEDS;

/**
 * Unwrap, or for disks flatten if the user prefers that; the choice stays for later disks. The UVs of
 * a file are shown until another one is opened.
 */
export class ModeSwitch {
  private readonly buttons = MODES.map((mode) => element(`mode-${mode}`, HTMLButtonElement));
  private chosen: Mode = 'unwrap';
  /** Whether the open mesh is a disk. */
  private disk: MeshSummary['disk'] = { ok: true, code: 'Ok', message: '' };
  private hasUvs = false;
  /** How the last mesh was laid out, before or without a look at its UVs. */
  private before: Mode = 'unwrap';

  constructor(private readonly changed: () => void) {
    this.buttons.forEach((button, i) => {
      button.addEventListener('click', () => this.choose(MODES[i]));
    });
    this.show();
  }

  get mode(): Mode {
    if (this.chosen === 'pack') return this.hasUvs ? 'pack' : 'unwrap';
    return this.disk.ok ? this.chosen : 'unwrap';
  }

  /** Whether the open file has UVs to look at. */
  get offersUvs(): boolean {
    return this.hasUvs;
  }

  /** Another mesh was opened, or the same one with another UV set. */
  open(disk: MeshSummary['disk'], hasUvs: boolean, isReread: boolean): void {
    const before = this.mode;
    this.disk = disk;
    this.hasUvs = hasUvs;
    if (this.chosen === 'pack' && !isReread) this.chosen = this.before;
    this.show();
    if (this.mode !== before) this.changed();
  }

  /** Switches to another kind of layout, as if the user had pressed its button. */
  choose(mode: Mode): void {
    if (mode === this.mode) return;
    this.restore(mode);
    this.changed();
  }

  /** Shows another kind of layout without asking for it. */
  restore(mode: Mode): void {
    this.chosen = mode;
    if (mode !== 'pack') this.before = mode;
    this.show();
  }

  private show(): void {
    this.buttons.forEach((button, i) => {
      button.setAttribute('aria-pressed', String(MODES[i] === this.mode));
      element(`${MODES[i]}-options`, HTMLElement).hidden = MODES[i] !== this.mode;
    });
    const { ok, code, message } = this.disk;
    const [flatten, , pack] = this.buttons;
    pack.hidden = !this.hasUvs;
    flatten.disabled = !ok;
    const need = NEEDS[code as StatusName];
    flatten.title = ok ? NO_DISK.not : NO_DISK.flatten(`${sentence(message)}.`, need);
    document.body.dataset.mode = this.mode;
  }
}
