import type { Source } from '../model/model';

/** "wavy-strip" as "Wavy strip". */
export function sampleTitle(name: string): string {
  const words = name.replaceAll('-', ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

export function titleOf(source: Source): string {
  return source.kind === 'sample' ? sampleTitle(source.name) : source.name;
}
