import type { Source } from '../model/model';
import { UV_SETS } from '../words/opening';

/** "wavy-strip" as "Wavy strip". */
export function sampleTitle(name: string): string {
  const words = name.replaceAll('-', ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

export function titleOf(source: Source): string {
  if (source.kind === 'sample') return sampleTitle(source.name);
  return source.texcoord ? UV_SETS.title(source.name, source.texcoord) : source.name;
}
