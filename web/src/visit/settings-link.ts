import type { MeshSummary } from 'abflat';
import type { Settings } from '../model/settings';
import { choiceOf, offeredBy, seamWords } from '../seams/seam-choice';
import { VISIT } from '../words/opening';
import { settingsOf, textOf, usualSettings } from './settings-text';

/** Of one word that means nothing. */
const MOST_LETTERS = 40;

/** The settings in the address of the page, so that a link shares them. */
export class SettingsLink {
  /** Those of the link that was followed, which hold for each mesh until something else is asked for. */
  linked: Settings | null = null;
  /** What the link has that means nothing here, as a sentence; '' if there is nothing. */
  remark = '';

  /** `followed`: the page is open, and its address got other settings. */
  constructor(followed: () => void) {
    this.read();
    window.addEventListener('hashchange', () => {
      this.read();
      followed();
    });
  }

  private read(): void {
    const text = location.hash.slice(1);
    const { settings, ignored } = settingsOf(text);
    this.linked = text ? settings : null;
    const words = ignored.map((word) => word.slice(0, MOST_LETTERS)).join(', ');
    this.remark = words && VISIT.notOffered(words);
  }

  /** Puts settings into the address, as the same page: the way back leads where it led before. */
  show(settings: Settings): void {
    const text = textOf(settings);
    if (text === location.hash.slice(1)) return;
    const { pathname, search } = location;
    try {
      history.replaceState(history.state, '', pathname + search + (text && `#${text}`));
    } catch (error) {
      // Some browsers allow only so many changes in a while.
      console.info('The address of the page cannot be changed:', error);
    }
  }
}

/** Without seams and UVs that the mesh does not have. */
export function fitting(
  settings: Settings,
  summary: MeshSummary,
  hasUvs = summary.texcoords > 0,
): Settings {
  if (settings.mode === 'flatten') return settings;
  if (settings.mode === 'pack') return hasUvs ? settings : usualSettings('unwrap');
  const { fixedFaces, ...others } = settings;
  const { sources } = choiceOf(settings);
  const offered = offeredBy(summary);
  const left = seamWords({
    ...sources,
    hard: sources.hard && offered.hard,
    uv: sources.uv && offered.uv,
    material: sources.material && offered.material,
  });
  return {
    ...others,
    ...(fixedFaces && summary.texcoords > 0 && { fixedFaces }),
    seams: left === 'none' && settings.seams !== left ? 'auto' : left,
  };
}
