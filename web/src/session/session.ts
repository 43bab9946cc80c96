import type { Abflat, MeshFile, MeshInput } from 'abflat';
import { Background } from '../base/background';
import { copied } from '../base/buffers';
import { loadPart } from '../base/load-part';
import { lostOf } from '../base/lost';
import { asDisk } from '../mesh/as-disk';
import type { FlatDrawing } from '../model/drawing';
import {
  type AnyProgress,
  type Helpers,
  isGltf,
  type Opened,
  type Outcome,
  type Packed,
  type Source,
} from '../model/model';
import type { PackSettings, Settings } from '../model/settings';
import { READING } from '../words/opening';
import { layOut } from './lay-out';
import { currentStep, type Left } from './left-meshes';
import { notSupported } from './words';

export interface SessionEvents {
  /** A mesh is being read, or laid out if there are `settings`. */
  started(source: Source, settings: Settings | null): void;
  progress(progress: AnyProgress): void;
  /** A mesh was read, or is shown again. `before`: the one that was shown until now. */
  opened(opened: Opened, before: Shown | null): void;
  laidOut(outcome: Outcome, drawing: FlatDrawing): void;
  /** An earlier outcome is there again. */
  restored(outcome: Outcome, drawing: FlatDrawing): void;
  cancelled(): void;
  /** `settings` is null when the mesh could not be read. */
  failed(source: Source, settings: Settings | null, error: Error): void;
}

/** A mesh and its last outcome. */
export interface Shown {
  opened: Opened;
  outcome: Outcome | null;
}

/**
 * In milliseconds. A run that is nearly done is worth waiting for; after this long without another
 * change it is aborted.
 */
const PATIENCE = 150;

/** Detail at which samples look good. */
const SAMPLE_DETAIL = 2;

/**
 * One mesh and one run at a time; the latest request wins. Requests are accepted while abflat is
 * still starting.
 */
export class Session {
  private opened: Opened | null = null;
  /** The last outcome. */
  private outcome: Outcome | null = null;
  private running: AbortController | null = null;
  /** Whether the run in flight reads a mesh. */
  private isReading = false;
  /** Whether to lay out again as soon as the run in flight ends. */
  private isWanted = false;
  private readonly background = new Background();
  private patience: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly abflat: () => Promise<Abflat>,
    private readonly events: SessionEvents,
    /** What the user asks for now. */
    private readonly settings: () => Settings,
    private readonly helpers: Helpers,
  ) {}

  /**
   * Reads a mesh and lays it out. On failure the previous one stays. `left`: how it was left, where
   * it was shown before; then it is as it was.
   */
  async open(source: Source, left: Left | null = null): Promise<void> {
    this.stop();
    const controller = this.begin();
    this.isReading = true;
    this.events.started(source, null);
    try {
      const opened = left
        ? { ...left.opened, drawing: await this.helpers.mesh(left.opened.mesh) }
        : await this.read(source, controller.signal);
      if (controller !== this.running) return;
      const before = this.shown;
      this.opened = opened;
      this.outcome = left?.outcome ?? this.outcome;
      this.events.opened(opened, before);
    } catch (error) {
      this.end(controller, () => this.events.failed(source, null, explained(error)));
      return;
    }
    this.running = null;
    const outcome = left && currentStep(left).outcome;
    await (outcome ? this.restore(outcome) : this.run());
  }

  /** The open mesh; null if there is none. */
  private get shown(): Shown | null {
    const { opened, outcome } = this;
    return opened && { opened, outcome: outcome?.source === opened.source ? outcome : null };
  }

  /**
   * Lays the mesh out with other settings: at once, or as soon as the run in flight ends or has
   * used up our patience. A mesh that is still being read is laid out with them afterwards.
   */
  refresh(): void {
    if (!this.running) {
      if (this.opened) void this.run();
      return;
    }
    if (this.isReading) return;
    this.isWanted = true;
    clearTimeout(this.patience);
    this.patience = setTimeout(() => this.replaceRun(), PATIENCE);
  }

  /** Takes an earlier outcome of the open mesh as the last one, in place of a run. */
  async restore(outcome: Outcome): Promise<void> {
    this.stop();
    const controller = this.begin();
    try {
      const drawing = await this.helpers.outcome(outcome);
      if (controller === this.running) this.outcome = outcome;
      this.end(controller, () => this.events.restored(outcome, drawing));
    } catch (error) {
      const { source, settings } = outcome;
      this.end(controller, () => this.events.failed(source, settings, explained(error)));
    }
  }

  get isBusy(): boolean {
    return this.running !== null;
  }

  /** Returns whether there was anything to cancel. */
  cancel(): boolean {
    if (!this.running) return false;
    this.stop();
    this.background.resume();
    this.events.cancelled();
    return true;
  }

  /**
   * Works on the open mesh while no run is in flight. A run interrupts the work, which then starts
   * over.
   */
  aside<T>(
    work: (abflat: Abflat, input: MeshInput, signal: AbortSignal) => Promise<T>,
    signal: AbortSignal,
  ): Promise<T> {
    return this.background.run(async (signal) => {
      if (!this.opened) throw new Error(READING.noMesh);
      return work(await this.abflat(), this.opened.input, signal);
    }, signal);
  }

  private replaceRun(): void {
    if (!this.opened || !this.isWanted) return;
    this.stop();
    void this.run();
  }

  private async run(): Promise<void> {
    if (!this.opened) return;
    const { opened } = this;
    const settings = this.settings();
    const controller = this.begin();
    this.events.started(opened.source, settings);
    try {
      const watch = {
        signal: controller.signal,
        onProgress: (progress: AnyProgress) => {
          if (controller === this.running) this.events.progress(progress);
        },
      };
      const { outcome: last, helpers } = this;
      const abflat = await this.abflat();
      const outcome =
        settings.mode === 'pack'
          ? await this.uvsOfFile(abflat, opened, settings, watch)
          : await layOut(abflat, opened, settings, last, watch, helpers);
      if (controller !== this.running) return;
      const drawing = await this.helpers.outcome(outcome);
      if (controller === this.running) this.outcome = outcome;
      this.end(controller, () => this.events.laidOut(outcome, drawing));
    } catch (error) {
      this.end(controller, () => this.events.failed(opened.source, settings, explained(error)));
    }
  }

  private async uvsOfFile(
    ...run: [Abflat, Opened, PackSettings, { signal: AbortSignal }]
  ): Promise<Packed> {
    const part = await loadPart(import('./pack-uvs'));
    return part.tellStacks(await part.packUvs(...run, this.helpers), this.helpers);
  }

  private begin(): AbortController {
    clearTimeout(this.patience);
    this.isWanted = false;
    this.isReading = false;
    this.background.pause();
    this.running = new AbortController();
    return this.running;
  }

  /**
   * Reports how a run ended, unless another one has replaced it, and starts what was requested in
   * the meantime.
   */
  private end(controller: AbortController, report: () => void): void {
    if (controller !== this.running) return;
    this.running = null;
    clearTimeout(this.patience);
    report();
    const { isWanted } = this;
    this.isWanted = false;
    if (isWanted) void this.run();
    else if (!this.running) this.background.resume();
  }

  private stop(): void {
    clearTimeout(this.patience);
    const controller = this.running;
    this.running = null;
    this.isWanted = false;
    controller?.abort();
  }

  private async read(source: Source, signal: AbortSignal): Promise<Opened> {
    const abflat = await this.abflat();
    if (source.kind === 'sample') {
      const mesh = await abflat.sample(source.name, { signal, detail: SAMPLE_DETAIL });
      const [summary, drawing] = await Promise.all([
        abflat.inspect(await copied(mesh), { signal, transfer: true }),
        this.helpers.mesh(mesh),
      ]);
      return { source, input: mesh, mesh, summary, drawing };
    }
    if (isGltf(source)) {
      const gltf = await this.helpers.gltf(source, signal);
      const { mesh, summary } = await asDisk(abflat, gltf.mesh, signal, (mesh) =>
        this.helpers.joined(mesh),
      );
      return { source, input: mesh, mesh, summary, drawing: await this.helpers.mesh(mesh), gltf };
    }
    if (source.file.size === 0) throw new Error(READING.empty(source.name));
    const input: MeshFile = {
      bytes: new Uint8Array(await bytesOf(source.file)),
      name: source.name,
    };
    const mesh = await abflat
      .load(await copied(input), { signal, transfer: true })
      .catch((error: unknown) => {
        throw isUnknownFormat(error) ? new Error(notSupported(source.name)) : error;
      });
    const [summary, drawing] = await Promise.all([
      abflat.inspect(await copied(input), { signal, transfer: true }),
      this.helpers.mesh(mesh),
    ]);
    if (mesh.indices.length === 0)
      throw new Error(READING.withoutFaces(source.name, summary.vertices));
    return { source, input, mesh, summary, drawing };
  }
}

const isUnknownFormat = (error: unknown) =>
  error instanceof Error &&
  'code' in error &&
  error.code === 'UnreadableFile' &&
  lostOf(error) === null;

async function bytesOf(file: File): Promise<ArrayBuffer> {
  try {
    return await file.arrayBuffer();
  } catch (error) {
    // A folder, or a file that was moved or changed since it was chosen.
    throw new Error(READING.unreadable(file.name, toError(error).message));
  }
}

const explained = (error: unknown): Error => lostOf(error) ?? toError(error);

function toError(error: unknown): Error {
  return error instanceof Error ? error : new Error(String(error));
}
