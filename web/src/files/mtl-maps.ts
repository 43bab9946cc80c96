// The images that the materials of an OBJ use, line by line, and the same text with others.

import { type MapPlacement, pathOf, placementOf } from './mtl';

export type MtlMapName =
  | 'ambient'
  | 'diffuse'
  | 'specular'
  | 'emissive'
  | 'shininess'
  | 'opacity'
  | 'roughness'
  | 'metallic'
  | 'bump'
  | 'displacement'
  | 'normal';

export interface MtlMap extends MapPlacement {
  keyword: string;
  /** Null if the images of this keyword are not baked. */
  name: MtlMapName | null;
  path: string;
  /** Options that do not place the image. */
  kept: string;
  /** Of bumps. */
  strength: number;
}

const NAMES: Record<string, MtlMapName> = {
  map_ka: 'ambient',
  map_kd: 'diffuse',
  map_ks: 'specular',
  map_ke: 'emissive',
  map_ns: 'shininess',
  map_d: 'opacity',
  map_pr: 'roughness',
  map_pm: 'metallic',
  bump: 'bump',
  map_bump: 'bump',
  disp: 'displacement',
  map_disp: 'displacement',
  norm: 'normal',
  map_kn: 'normal',
};

/** Colours are mixed as light, and all else as numbers. */
export const COLOURS: readonly MtlMapName[] = ['ambient', 'diffuse', 'specular', 'emissive'];

const PLACING = ['-s', '-o', '-t', '-clamp'];

/** Null for a line that uses no image. */
function mapOf(line: string): MtlMap | null {
  const [, keyword = '', rest = ''] = /^\s*(\S+)\s*(.*?)\s*$/.exec(line) ?? [];
  const lower = keyword.toLowerCase();
  const isMap = lower in NAMES || /^(map_(?!aat$)|decal$|refl$)/.test(lower);
  if (!isMap) return null;
  const { path, options } = pathOf(rest);
  const kept = [...options].filter(([option]) => !PLACING.includes(option));
  return {
    keyword,
    name: NAMES[lower] ?? null,
    path,
    kept: kept.map(([option, given]) => `${[option, ...given].join(' ')} `).join(''),
    ...placementOf(options),
    strength: Number(options.get('-bm')?.[0] ?? 1),
  };
}

export interface MtlLine {
  text: string;
  map: MtlMap | null;
}

/** Lines of the materials with these names, each where it counts: the first of a name does. */
export function mtlLines(texts: string[], names: string[]): Map<string, MtlLine[]> {
  const found = new Map<string, MtlLine[]>();
  for (const text of texts) {
    let lines: MtlLine[] | null = null;
    for (const line of text.replace(/^\ufeff/, '').split(/\r\n?|\n/)) {
      const [, name] = /^\s*newmtl\s+(.*?)\s*$/.exec(line) ?? [];
      if (name !== undefined) {
        lines = names.includes(name) && !found.has(name) ? [] : null;
        if (lines) found.set(name, lines);
      }
      lines?.push({ text: line, map: mapOf(line) });
    }
  }
  return found;
}

/** The lines with new images; those without one are left out. */
export function mtlText(
  materials: Map<string, MtlLine[]>,
  fileOf: (map: MtlMap) => string | undefined,
): string {
  const out: string[] = [];
  for (const { text, map } of [...materials.values()].flat()) {
    const file = map && fileOf(map);
    if (!map) out.push(text);
    else if (file) out.push(`${map.keyword} ${map.kept}${file}`);
  }
  return `${out.join('\n').trimEnd()}\n`;
}

/** An OBJ that names this material file in place of its own. */
export function withMtl(obj: string, name: string): string {
  let isNamed = false;
  return obj.replace(/^[ \t]*mtllib[ \t].*(\r\n?|\n|$)/gm, (_, end: string) => {
    if (isNamed) return '';
    isNamed = true;
    return ['mtllib', name].join(' ') + end;
  });
}
