import type { VertexBound } from 'abflat';
import { element } from './base/dom';
import { AtlasControl } from './controls/atlas-control';
import { BalanceControl } from './controls/balance-control';
import { BoundControl } from './controls/bound-control';
import { ModeSwitch } from './controls/mode-switch';
import { PackControl } from './controls/pack-control';
import { Locks } from './details/locks';
import { isAutomatic } from './details/verdict';
import type { Unwrapped } from './model/model';
import {
  type FlattenSettings,
  type Marks,
  type Settings,
  sameSettings,
  type UnwrapSettings,
} from './model/settings';
import type { Editable, SeamPanel } from './seams/seam-panel';
import { CHANGES } from './words/run';

export interface ControlEvents {
  /** The user wants something else; `what`, if the settings do not say so. */
  changed(what?: string): void;
  modeChanged(): void;
  say(text: string): void;
}

/** Everything that the user can ask of a layout, wherever on the page. */
export class LayoutControls {
  readonly bound: BoundControl;
  readonly mode: ModeSwitch;
  readonly locks = new Locks();
  private readonly balance: BalanceControl;
  private readonly options: AtlasControl;
  private readonly packing: PackControl;
  private readonly delaunay = element('delaunay', HTMLButtonElement);
  private placed: UnwrapSettings['placed'];
  private faceDensities: UnwrapSettings['faceDensities'];
  private ownBounds: FlattenSettings['bounds'];
  private pins: UnwrapSettings['pins'];

  constructor(
    private readonly seams: SeamPanel,
    private readonly events: ControlEvents,
  ) {
    const changed = () => events.changed();
    this.bound = new BoundControl(changed, events.say);
    this.balance = new BalanceControl('flatten', changed);
    this.options = new AtlasControl(() => {
      this.placed = undefined;
      changed();
    }, events.say);
    this.packing = new PackControl(changed, events.say);
    this.mode = new ModeSwitch(() => events.modeChanged());
    this.delaunay.addEventListener('click', () => {
      this.setDelaunay(!this.isDelaunay);
      changed();
    });
  }

  get settings(): Settings {
    const { mode } = this.mode;
    if (mode === 'pack') return this.packing.settings;
    return mode === 'flatten' ? this.disk : this.atlas;
  }

  /** Of the other kinds of layout, then of the one that is chosen. */
  get all(): Settings[] {
    const { atlas, disk, packing } = this;
    const all = [disk, atlas, ...(this.mode.offersUvs ? [packing.settings] : [])];
    const isChosen = ({ mode }: Settings) => mode === this.mode.mode;
    return [...all.filter((each) => !isChosen(each)), ...all.filter(isChosen)];
  }

  /** What is marked in an atlas. */
  get marks(): Marks {
    const { pins } = this;
    return { kept: this.locks.kept, ...(pins && { pins }) };
  }

  /** Vertices of the layout are pinned. */
  pin(pins: Uint32Array): void {
    this.pins = pins.length > 0 ? pins : undefined;
  }

  private get atlas(): UnwrapSettings {
    const { placed, faceDensities } = this;
    const byHand = { ...(faceDensities && { faceDensities }), ...(placed && { placed }) };
    return { ...this.options.settings, ...this.seams.options, ...this.marks, ...byHand };
  }

  get disk(): FlattenSettings {
    const { t } = this.bound;
    const { balance } = this.balance;
    const own = this.ownBounds && { bounds: this.ownBounds };
    return { mode: 'flatten', t, balance, delaunay: this.isDelaunay, ...own };
  }

  /** Vertices of the boundary are to have these bounds. */
  paint(bounds: VertexBound[], what: string): void {
    this.ownBounds = bounds.length > 0 ? bounds : undefined;
    this.events.changed(what);
  }

  /** Another mesh was opened. */
  open(mesh: Editable & { hasUvs: boolean }): void {
    this.placed = undefined;
    this.faceDensities = undefined;
    this.ownBounds = undefined;
    this.pins = undefined;
    this.options.open(mesh);
    this.packing.reset();
    this.mode.open(mesh.summary.disk, mesh.hasUvs, mesh.isReread);
    this.seams.open(mesh);
    this.showCutting();
    this.locks.clear();
  }

  /** Other seams are wanted. Charts that were moved stay where they are. */
  seamsChanged(what?: string): void {
    this.showCutting();
    this.events.changed(what);
  }

  /** Charts were moved. They keep these densities when they are packed anew. */
  place(
    layout: UnwrapSettings['placed'],
    densities: UnwrapSettings['faceDensities'],
    what: string,
  ): void {
    this.placed = layout;
    this.faceDensities = densities;
    this.events.changed(what);
  }

  /** All charts of this atlas that are not locked are to be packed again. */
  packAgain({ result, settings }: Unwrapped): void {
    // What is asked for besides comes first.
    this.placed = sameSettings(settings, this.settings) ? { ...result, repacks: true } : undefined;
    this.events.changed(CHANGES.packedAgain);
  }

  /** The islands of the file are to be packed. */
  packIslands(): void {
    this.packing.setKeeping(false);
  }

  /** Shows other settings without asking for them. */
  restore(settings: Settings): void {
    this.mode.restore(settings.mode);
    if (settings.mode === 'pack') {
      this.packing.restore(settings);
      return;
    }
    if (settings.mode === 'flatten') {
      this.bound.restore(settings.t);
      this.balance.restore(settings.balance);
      this.setDelaunay(settings.delaunay);
      this.ownBounds = settings.bounds;
      return;
    }
    this.placed = settings.placed;
    this.faceDensities = settings.faceDensities;
    this.pins = settings.pins;
    this.options.restore(settings);
    this.seams.restore(settings);
    this.locks.restore(settings.kept);
    this.showCutting();
  }

  private showCutting(): void {
    this.options.setCutting(isAutomatic(this.seams.options.seams));
  }

  private get isDelaunay(): boolean {
    return this.delaunay.ariaPressed === 'true';
  }

  private setDelaunay(isOn: boolean): void {
    this.delaunay.ariaPressed = String(isOn);
  }
}
