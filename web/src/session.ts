import type { Abflat, FlattenResult, MeshFile, MeshInput, Progress } from 'abflat';
import { Background } from './background';
import { exportFormat } from './export-mesh';
import type { Bound } from './format';
import type { DisplayMesh } from './mesh';

/** Where a mesh comes from. `name` is for people and for the names of exported files. */
export type Source = { kind: 'sample'; name: string } | { kind: 'file'; name: string; file: File };

/** What the user can ask of a layout. */
export interface Settings {
  t: Bound;
  delaunay: boolean;
}

export function sameSettings(a: Settings, b: Settings): boolean {
  return a.t === b.t && a.delaunay === b.delaunay;
}

export interface Outcome {
  source: Source;
  settings: Settings;
  result: FlattenResult;
  mesh: DisplayMesh;
}

export interface SessionEvents {
  /** A mesh is being read, or flattened when there are `settings`. */
  started(source: Source, settings: Settings | null): void;
  progress(progress: Progress): void;
  /** A mesh was read; whether it can be flattened is not known yet. */
  opened(source: Source, mesh: DisplayMesh): void;
  flattened(outcome: Outcome): void;
  cancelled(): void;
  /** `settings` is null when the mesh could not be read. */
  failed(source: Source, settings: Settings | null, error: Error): void;
}

interface Opened {
  source: Source;
  input: MeshInput;
  mesh: DisplayMesh;
}

/** A run that is nearly done is worth waiting for; after this many milliseconds without another change it is aborted. */
const PATIENCE = 150;

/** Samples are made as fine as they look good. */
const SAMPLE_DETAIL = 2;

/** One mesh at a time, one run at a time; the latest wish wins. Wishes are heard while abflat still starts. */
export class Session {
  private opened: Opened | null = null;
  private running: AbortController | null = null;
  /** What to flatten with as soon as the run in flight ends. */
  private next: Settings | null = null;
  private readonly background = new Background();
  private patience: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly abflat: Promise<Abflat>,
    private readonly events: SessionEvents,
  ) {}

  /** Reads a mesh and flattens it. On failure the previous one stays. */
  async open(source: Source, settings: Settings): Promise<void> {
    this.stop();
    const controller = this.begin();
    this.events.started(source, null);
    try {
      const opened = await this.read(source, controller.signal);
      if (controller !== this.running) return;
      this.opened = opened;
      this.events.opened(source, opened.mesh);
    } catch (error) {
      this.end(controller, () => this.events.failed(source, null, toError(error)));
      return;
    }
    this.running = null;
    await this.run(this.next ?? settings);
  }

  /** Flattens the mesh with other settings: at once, or as soon as the run in flight ends or has used up our patience. */
  flatten(settings: Settings): void {
    if (!this.running) {
      if (this.opened) void this.run(settings);
      return;
    }
    this.next = settings;
    clearTimeout(this.patience);
    this.patience = setTimeout(() => this.replaceRun(), PATIENCE);
  }

  /** Returns whether there was anything to cancel. */
  cancel(): boolean {
    if (!this.running) return false;
    this.stop();
    this.background.resume();
    this.events.cancelled();
    return true;
  }

  /** Does something with the open mesh while no run is in flight; a run interrupts it, and it starts over. */
  aside<T>(
    work: (abflat: Abflat, input: MeshInput, signal: AbortSignal) => Promise<T>,
    signal: AbortSignal,
  ): Promise<T> {
    return this.background.run(async (signal) => {
      if (!this.opened) throw new Error('Open a mesh first.');
      return work(await this.abflat, this.opened.input, signal);
    }, signal);
  }

  private replaceRun(): void {
    if (!this.opened || this.next === null) return;
    const settings = this.next;
    this.stop();
    void this.run(settings);
  }

  private async run(settings: Settings): Promise<void> {
    if (!this.opened) return;
    const { source, input, mesh } = this.opened;
    const controller = this.begin();
    this.events.started(source, settings);
    try {
      const abflat = await this.abflat;
      const result = await abflat.flatten(input, {
        ...settings,
        obj: exportFormat(source) === 'obj',
        ply: exportFormat(source) === 'ply',
        signal: controller.signal,
        onProgress: (progress) => {
          if (controller === this.running) this.events.progress(progress);
        },
      });
      this.end(controller, () => this.events.flattened({ source, settings, result, mesh }));
    } catch (error) {
      this.end(controller, () => this.events.failed(source, settings, toError(error)));
    }
  }

  private begin(): AbortController {
    this.next = null;
    this.background.pause();
    this.running = new AbortController();
    return this.running;
  }

  /** Reports how a run ended, unless another one has taken its place, and starts what was wished for meanwhile. */
  private end(controller: AbortController, report: () => void): void {
    if (controller !== this.running) return;
    this.running = null;
    clearTimeout(this.patience);
    report();
    const wish = this.next;
    this.next = null;
    if (wish !== null) void this.run(wish);
    else if (!this.running) this.background.resume();
  }

  private stop(): void {
    clearTimeout(this.patience);
    const controller = this.running;
    this.running = null;
    this.next = null;
    controller?.abort();
  }

  private async read(source: Source, signal: AbortSignal): Promise<Opened> {
    const abflat = await this.abflat;
    if (source.kind === 'sample') {
      const mesh = await abflat.sample(source.name, { signal, detail: SAMPLE_DETAIL });
      return { source, input: mesh, mesh };
    }
    const input: MeshFile = {
      bytes: new Uint8Array(await bytesOf(source.file)),
      name: source.name,
    };
    return { source, input, mesh: await abflat.load(input, { signal }) };
  }
}

async function bytesOf(file: File): Promise<ArrayBuffer> {
  try {
    return await file.arrayBuffer();
  } catch (error) {
    // A folder, or a file that was moved or changed since it was chosen.
    const reason = toError(error).message;
    throw new Error(`${file.name} cannot be read (${reason}) Choose the file again.`);
  }
}

function toError(error: unknown): Error {
  return error instanceof Error ? error : new Error(String(error));
}
