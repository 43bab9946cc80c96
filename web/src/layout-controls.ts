import type { VertexBound } from 'abflat';
import { element } from './base/dom';
import { AtlasControl } from './controls/atlas-control';
import { BalanceControl } from './controls/balance-control';
import { BoundControl } from './controls/bound-control';
import { ModeSwitch } from './controls/mode-switch';
import { PackControl } from './controls/pack-control';
import { Locks } from './details/locks';
import { isAutomatic } from './details/verdict';
import type { Arrangeable } from './model/arrangeable';
import type { FaceDensities } from './model/face-densities';
import type { Unwrapped } from './model/model';
import {
  type FlattenSettings,
  type Marks,
  type PackChoices,
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
  /** Islands of the file are to be relaxed: the selected ones, or all. */
  relaxIslands(): void;
  /** Those that are selected are to be packed; returns whether any are. */
  packSelected(choices: PackChoices): boolean;
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
  private faceDensities: FaceDensities;
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
    this.packing = new PackControl({ ...events, changed });
    this.mode = new ModeSwitch(() => events.modeChanged());
    this.delaunay.addEventListener('click', () => {
      this.setDelaunay(!this.isDelaunay);
      changed();
    });
  }

  async loadRest(): Promise<void> {
    await Promise.all([this.options.loadRest(), this.packing.loadRest()]);
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

  /** Charts were moved. Those of an atlas keep their densities when they are packed anew. */
  place(outcome: Arrangeable, what: string, mayRepack: boolean): void {
    if (outcome.mode === 'pack') this.packing.give(outcome.given);
    else {
      const { result } = outcome;
      this.placed = mayRepack ? { ...result, mayRepack } : result;
      this.faceDensities = outcome.settings.faceDensities;
    }
    this.events.changed(what);
  }

  /** All charts of this atlas that are not locked are to be packed again. */
  packAgain({ result, settings }: Unwrapped): void {
    // What is asked for besides comes first.
    this.placed = sameSettings(settings, this.settings) ? { ...result, repacks: true } : undefined;
    this.events.changed(CHANGES.packedAgain);
  }

  /** What faces of an atlas ask for. */
  get densities(): FaceDensities {
    return this.faceDensities;
  }

  /** Faces ask for other densities: the charts of the atlas on screen, or asked for, are packed again. */
  setDensities({ result, settings }: Unwrapped, densities: FaceDensities, what: string): void {
    const base = sameSettings(settings, this.settings) ? result : this.placed;
    this.placed = base && { ...base, repacks: true };
    this.faceDensities = densities;
    this.events.changed(what);
  }

  /** The islands of the file are to be packed. */
  packIslands(): void {
    this.packing.setKeeping(false);
  }

  /** What the mesh has several of. */
  offerParts(hasObjects: boolean, hasMaterials: boolean): void {
    this.packing.offerParts(hasObjects, hasMaterials);
    this.options.offerParts(hasObjects, hasMaterials);
  }

  /** How many islands are selected. */
  showSelected(count: number): void {
    this.packing.showSelected(count);
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
