import { nextTask } from '../base/next-task';

/** The material and the object or group of each face of an OBJ, as numbers. */
export interface FaceParts {
  material: number[];
  group: number[];
  /** How many have a name in the file. */
  materials: number;
  groups: number;
}

/** Lines that are read at once: more would block the page. */
const LINES = 1 << 15;

/** Faces before the first name have part 0. An object with several groups is as many parts. */
export async function objParts(text: string): Promise<FaceParts> {
  const names = { material: new Map<string, number>(), group: new Map<string, number>() };
  const found: Pick<FaceParts, 'material' | 'group'> = { material: [], group: [] };
  let [material, object, group] = ['', '', ''];
  const numberIn = (map: Map<string, number>, name: string) => {
    if (name && !map.has(name)) map.set(name, map.size + 1);
    return map.get(name) ?? 0;
  };
  let line = 0;
  for (const [, keyword, name] of text.matchAll(/^[ \t]*(f|usemtl|o|g)(?:[ \t]+([^\r\n]*)|$)/gm)) {
    if (keyword === 'usemtl') material = name?.trim() ?? '';
    else if (keyword === 'o') [object, group] = [name?.trim() ?? '', ''];
    else if (keyword === 'g') group = name?.trim() ?? '';
    else {
      found.material.push(numberIn(names.material, material));
      found.group.push(numberIn(names.group, [object, group].filter(Boolean).join('\n')));
    }
    if (++line % LINES === 0) await nextTask();
  }
  return { ...found, materials: names.material.size, groups: names.group.size };
}
