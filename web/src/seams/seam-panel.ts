import type { MeshSummary } from 'abflat';
import { showAlert } from '../base/alert';
import { counted } from '../base/format';
import type { DisplayMesh } from '../mesh/mesh';
import type { Unwrapped } from '../model/model';
import { Solid } from '../surface/solid';
import type { MeshView } from '../view/mesh-view';
import type { Workshop } from '../workshop/workshop';
import { AUTOMATIC, choiceOf, type SeamChoice, type SeamOptions, seamOptions } from './seam-choice';
import { pairsOf } from './seam-edges';
import { SeamEditor } from './seam-editor';
import { BadSeamFile, readSeams, seamText } from './seam-file';
import { SeamFiles } from './seam-files';
import { SeamModel, type Surface } from './seam-model';
import { SharpControl } from './sharp-control';
import { SourceControl } from './source-control';

/** A mesh whose seams can be edited. */
export interface Editable {
  mesh: DisplayMesh;
  summary: MeshSummary;
  name: string;
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
  private readonly editor: SeamEditor | null;
  private model: SeamModel | null = null;
  private isUnwrapped = false;
  private readonly files: SeamFiles;
  private mesh: Editable | null = null;
  /** The surface of the mesh, made when it is first needed. */
  private surface: Surface | null = null;

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
      aimed: (degrees) => this.aimAtSharp(degrees),
      marked: (degrees) => this.markSharp(degrees),
      say: events.say,
    });
    this.files = new SeamFiles({
      text: () => (this.model ? seamText(pairsOf(this.model.graph, this.model.all)) : ''),
      meshName: () => this.mesh?.name ?? '',
      chosen: (name) => this.openFile(name),
      failed: showAlert,
      say: events.say,
    });
    const editorEvents = { changed: (what: string) => this.changed(what), say: events.say };
    this.editor = view ? new SeamEditor(view, editorEvents) : null;
  }

  /** Shows which edges would be marked. */
  private aimAtSharp(degrees: number | null): void {
    const edges = degrees === null ? [] : (this.model?.sharpEdges(degrees) ?? []);
    const offer = degrees === null ? null : { edges, text: sharpText(edges.length, degrees) };
    this.editor?.show(offer);
  }

  /** Adds the edges that bend by more than this to the user's seams. */
  private markSharp(degrees: number): void {
    const { model } = this;
    if (!model) return;
    const count = model.cut(model.sharpEdges(degrees));
    const what = `Marked ${counted(count, 'sharp edge')}`;
    this.events.say(count > 0 ? what : sharpText(0, degrees));
    if (count > 0) this.changed(what);
    this.editor?.show(null);
  }

  /**
   * Takes the seams listed in a file, or reports where the file is wrong. Does nothing if another
   * mesh was opened while it was read.
   */
  private openFile(name: string): (text: string) => void {
    const { model } = this;
    return (text) => {
      if (!model || model !== this.model) return;
      try {
        model.setEdges(readSeams(model.graph, text, name));
      } catch (error) {
        if (!(error instanceof BadSeamFile)) throw error;
        showAlert(error.message);
        return;
      }
      this.changed(`Seams of ${name}`);
    };
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
    this.changed('Cut further');
  }

  /** Shows other seams without asking for them. */
  restore(options: SeamOptions): void {
    this.model?.restore(choiceOf(options));
    this.sources.show(this.choice);
    this.editor?.clear();
    this.editor?.update();
  }

  /** Opens another mesh, with automatic seams. */
  open(mesh: Editable): void {
    const { summary } = mesh;
    this.mesh = mesh;
    this.surface = null;
    this.model = new SeamModel(() => {
      if (!this.surface) throw new Error('Seams are edited before prepare().');
      return this.surface;
    });
    this.sources.offer({ uv: summary.texcoords > 0, material: summary.materials > 1 });
    this.sources.show(this.choice);
    this.hide();
  }

  /**
   * Called before the mesh is unwrapped, so that its seams can be edited as soon as there is an
   * atlas.
   */
  async prepare(): Promise<void> {
    const { mesh } = this;
    if (!mesh || this.surface) return;
    const { graph, solid } = await this.workshop.surface(mesh.mesh, mesh.summary.disk.ok);
    if (mesh === this.mesh) this.surface ??= { graph, solid: new Solid(solid) };
  }

  /** Hides the editor: there is nothing to edit until the open mesh has an atlas. */
  hide(): void {
    this.isUnwrapped = false;
    this.files.setEnabled(false);
    this.editor?.edit(null);
  }

  show({ result, settings }: Unwrapped): void {
    if (!this.model || !this.surface) return;
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

function sharpText(count: number, degrees: number): string {
  if (count === 0) return `No other edge bends by more than ${degrees}°`;
  return `${counted(count, 'edge')} ${count === 1 ? 'bends' : 'bend'} by more than ${degrees}°`;
}
