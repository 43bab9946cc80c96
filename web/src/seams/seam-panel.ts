import type { MeshSummary } from 'abflat';
import { showAlert } from '../base/alert';
import { loadPart } from '../base/load-part';
import { startOnce } from '../base/start-once';
import type { DisplayMesh } from '../mesh/mesh';
import type { Unwrapped } from '../model/model';
import type { MeshView } from '../view/mesh-view';
import { SEAM_FILES, SEAMS } from '../words/seams';
import type { Workshop } from '../workshop/workshop';
import {
  AUTOMATIC,
  choiceOf,
  offeredBy,
  type SeamChoice,
  type SeamOptions,
  seamOptions,
} from './seam-choice';
import { pairsOf } from './seam-edges';
import { SeamEditor } from './seam-editor';
import { BadSeamFile, readSeams, seamText } from './seam-file';
import { SeamFiles } from './seam-files';
import { SeamModel, type Surface } from './seam-model';
import { SharpControl } from './sharp-control';
import { SourceControl } from './source-control';

const solids = () => loadPart(import('../surface/solid'));
const aimings = () => loadPart(import('./aiming'));

/** The choice for another mesh, whose hard edges, islands and materials are its own. */
function takenOver({ sources, edges }: SeamChoice, isReread: boolean): SeamChoice {
  if (edges) return AUTOMATIC;
  if (isReread) return { sources, edges };
  const auto = sources.auto || sources.hard || sources.uv || sources.material;
  return { sources: { ...sources, hard: false, uv: false, material: false, auto }, edges: null };
}

/** A mesh whose seams can be edited. */
export interface Editable {
  mesh: DisplayMesh;
  summary: MeshSummary;
  name: string;
  /** Whether this is the file before, read with another texcoord set. */
  isReread: boolean;
}

export interface SeamPanelEvents {
  /** The user wants other seams; `what` has changed, if the options do not say so. */
  changed(what?: string): void;
  /** Shows a message to the user. */
  say(text: string): void;
}

/** Everything on the page about seams: the sources, the editor, and what results from both. */
export class SeamPanel {
  private readonly sources: SourceControl;
  private readonly sharp: SharpControl;
  readonly editor: SeamEditor | null;
  private model: SeamModel | null = null;
  private isUnwrapped = false;
  private readonly files: SeamFiles;
  private mesh: Editable | null = null;
  /** The angle whose edges are to be shown. */
  private sharpAimed: number | null = null;
  /** Makes the surface of the mesh when it is first needed. */
  private prepared: () => Promise<void> = () => Promise.resolve();

  /** Without a `view` there are only the sources. */
  constructor(
    view: MeshView | null,
    private readonly workshop: Workshop,
    private readonly events: SeamPanelEvents,
  ) {
    this.sources = new SourceControl((sources) => {
      this.model?.setSources(sources);
      this.changed();
    }, events.say);
    this.sharp = new SharpControl({
      aimed: (degrees) => void this.aimAtSharp(degrees),
      marked: (degrees) => void this.markSharp(degrees),
      say: events.say,
    });
    this.files = new SeamFiles({
      text: () => this.seamText(),
      meshName: () => this.mesh?.name ?? '',
      chosen: (name) => this.openFile(name),
      failed: showAlert,
      say: events.say,
    });
    const editorEvents = {
      changed: (what: string) => this.changed(what),
      say: events.say,
      ready: () => this.prepare(),
    };
    this.editor = view ? new SeamEditor(view, editorEvents) : null;
  }

  private async seamText(): Promise<string | null> {
    const model = await this.ready();
    return model && seamText(pairsOf(model.graph, model.all));
  }

  /** What is edited, as soon as it can be; null if it cannot, or another mesh was opened before. */
  private async ready(): Promise<SeamModel | null> {
    const { model } = this;
    await this.prepare();
    return model?.isReady && model === this.model ? model : null;
  }

  /** Shows which edges would be marked. */
  private async aimAtSharp(degrees: number | null): Promise<void> {
    this.sharpAimed = degrees;
    const model = degrees === null ? null : await this.ready();
    if (degrees !== this.sharpAimed) return;
    if (!model || degrees === null) {
      this.editor?.show(null);
      return;
    }
    const edges = model.sharpEdges(degrees);
    this.editor?.show({ edges, text: SEAMS.sharp(edges.length, degrees) });
  }

  /** Adds the edges that bend by more than this to the user's seams. */
  private async markSharp(degrees: number): Promise<void> {
    const model = await this.ready();
    if (!model) return;
    const count = model.cut(model.sharpEdges(degrees));
    const what = SEAMS.markedSharp(count);
    this.events.say(count > 0 ? what : SEAMS.sharp(0, degrees));
    if (count > 0) this.changed(what);
    this.editor?.show(null);
  }

  /**
   * Takes the seams listed in a file, or reports where the file is wrong. Does nothing if another
   * mesh was opened while it was read.
   */
  private openFile(name: string): (text: string) => Promise<void> {
    const { model } = this;
    return async (text) => {
      if (!model || model !== this.model || !(await this.ready())) return;
      try {
        model.setEdges(readSeams(model.graph, text, name));
      } catch (error) {
        if (!(error instanceof BadSeamFile)) throw error;
        showAlert(error.message);
        return;
      }
      this.changed(SEAM_FILES.opened(name));
    };
  }

  /** Where seams are edited, as soon as it is there; null if it cannot be. */
  async surface(): Promise<Surface | null> {
    return (await this.ready())?.surface ?? null;
  }

  get choice(): SeamChoice {
    return this.model?.choice ?? AUTOMATIC;
  }

  get options(): SeamOptions {
    return seamOptions(this.choice);
  }

  /** Whether clicks on the mesh edit no seams. */
  get isIdle(): boolean {
    return this.editor?.isIdle ?? true;
  }

  /** Adds automatic seams to those asked for. */
  cutFurther(): void {
    this.model?.cutFurther();
    this.changed(SEAMS.cutFurther);
  }

  /** Shows other seams without asking for them. */
  restore(options: SeamOptions): void {
    this.model?.restore(choiceOf(options));
    this.sources.show(this.choice);
    this.editor?.clear();
    this.editor?.update();
  }

  /** Opens another mesh. The sources stay that are not of the mesh before; edited seams do not. */
  open(mesh: Editable): void {
    const { summary } = mesh;
    let surface: Surface | null = null;
    this.mesh = mesh;
    this.prepared = startOnce(async () => {
      surface = await this.surfaceOf(mesh);
    });
    this.model = new SeamModel(
      () => surface,
      takenOver(this.choice, mesh.isReread),
      this.editor?.symmetry,
    );
    this.sources.offer(offeredBy(summary));
    this.sources.show(this.choice);
    this.hide();
  }

  /**
   * Called before the mesh is unwrapped, so that its seams can be edited as soon as there is an
   * atlas, or after that; what is done to them in the meantime waits.
   */
  async prepare(): Promise<void> {
    const { mesh, prepared } = this;
    try {
      await prepared();
      if (mesh === this.mesh) this.editor?.update();
    } catch (error) {
      if (mesh !== this.mesh) return;
      this.hide();
      this.events.say(SEAMS.notEditable((error as Error).message));
    }
  }

  /** What editing takes is not part of the first load. */
  async loadRest(): Promise<void> {
    await Promise.all([solids(), aimings(), this.editor?.loadRest()]);
    if (!this.isUnwrapped) return;
    await this.prepared();
    this.editor?.update();
  }

  private async surfaceOf({ mesh, summary }: Editable): Promise<Surface> {
    const made = this.workshop.surface(mesh, summary.disk.ok);
    const rest = [made, solids(), aimings(), this.editor?.loadRest()] as const;
    const [{ graph, solid }, { Solid }, aiming] = await Promise.all(rest);
    return { graph, solid: new Solid(solid), aiming };
  }

  /** Hides the editor: there is nothing to edit until the open mesh has an atlas. */
  hide(): void {
    this.isUnwrapped = false;
    this.files.setEnabled(false);
    this.editor?.edit(null);
  }

  show({ result, settings }: Unwrapped): void {
    if (!this.model) return;
    const { seams, seamEdges } = this.options;
    this.model.show(result.seams, settings.seams === seams && settings.seamEdges === seamEdges);
    if (this.isUnwrapped) this.editor?.update();
    else this.editor?.edit(this.model);
    this.isUnwrapped = true;
    this.files.setEnabled(true);
  }

  private changed(what?: string): void {
    this.sources.show(this.choice);
    const { sharp } = this.choice.sources;
    if (sharp !== null) this.sharp.use(sharp);
    this.editor?.update();
    this.events.changed(what);
  }
}
