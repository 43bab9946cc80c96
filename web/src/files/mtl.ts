// Materials of an OBJ, as far as they are shown. Colours are sRGB.

/** Where an image lies. Texcoords, with v upwards, are scaled, then moved. */
export interface MapPlacement {
  scale: [number, number];
  offset: [number, number];
  isClamped: boolean;
}

export interface MtlMaterial extends MapPlacement {
  diffuse: [number, number, number];
  opacity: number;
  /** Name of an image as written; null: none. */
  map: string | null;
  /** Whether the image's own opacity counts. */
  hasAlpha: boolean;
}

/** Fields that are read before their meaning is known. */
interface Read extends MtlMaterial {
  hasOpacity: boolean;
  alphaMap: string | null;
}

/** Numbers that a map option takes; of those that take up to three, only the first is required. */
const argumentCount = (option: string) =>
  ['-o', '-s', '-t'].includes(option) ? 3 : option === '-mm' ? 2 : 1;

/** The first material of a name counts. */
export function readMtl(text: string): Map<string, MtlMaterial> {
  const found = new Map<string, Read>();
  let material: Read | null = null;
  for (const line of text.replace(/^\ufeff/, '').split(/\r\n?|\n/)) {
    const [, keyword, rest = ''] = /^\s*(\S+)\s*(.*?)\s*$/.exec(line) ?? [];
    if (keyword === 'newmtl') {
      material = blank();
      if (!found.has(rest)) found.set(rest, material);
    } else if (material) readLine(keyword, rest, material);
  }
  for (const each of found.values())
    each.hasAlpha = each.map !== null && each.map === each.alphaMap;
  return found;
}

const blank = (): Read => ({
  diffuse: [1, 1, 1],
  opacity: 1,
  map: null,
  scale: [1, 1],
  offset: [0, 0],
  isClamped: false,
  hasAlpha: false,
  hasOpacity: false,
  alphaMap: null,
});

function readLine(keyword: string | undefined, rest: string, material: Read): void {
  const numbers = rest.split(/\s+/).map(Number);
  const [first] = numbers;
  if (keyword === 'Kd') readColor(numbers, material);
  if (keyword === 'map_Kd') readMap(rest, material);
  if (keyword === 'map_d') material.alphaMap = pathOf(rest).path;
  if (keyword === 'd' && Number.isFinite(first)) {
    material.opacity = first;
    material.hasOpacity = true;
  }
  // Some programs mean opacity by it, so it only counts if no opacity is given.
  if (keyword === 'Tr' && Number.isFinite(first) && !material.hasOpacity)
    material.opacity = 1 - first;
}

/** A single number is a grey. */
function readColor(numbers: number[], material: Read): void {
  const [red, green = red, blue = red] = numbers;
  if ([red, green, blue].every(Number.isFinite)) material.diffuse = [red, green, blue];
}

function readMap(rest: string, material: Read): void {
  const { path, options } = pathOf(rest);
  material.map = path || null;
  Object.assign(material, placementOf(options));
}

export function placementOf(options: Map<string, string[]>): MapPlacement {
  const [u = 1, v = 1] = options.get('-s')?.map(Number) ?? [];
  const [x = 0, y = 0] = options.get('-o')?.map(Number) ?? [];
  return { scale: [u, v], offset: [x, y], isClamped: options.get('-clamp')?.[0] === 'on' };
}

/** "-s 1 1 1 -clamp on my wood.png": the name of the file may contain blanks. */
export function pathOf(words: string): { path: string; options: Map<string, string[]> } {
  const options = new Map<string, string[]>();
  let rest = words;
  for (;;) {
    const option = /^(-[a-z]\S*)\s+/i.exec(rest);
    if (!option) return { path: rest, options };
    rest = rest.slice(option[0].length);
    const given: string[] = [];
    for (let i = 0; i < argumentCount(option[1]); ++i) {
      const [word, argument] = /^(\S+)\s+/.exec(rest) ?? [];
      if (word === undefined || (i > 0 && !Number.isFinite(Number(argument)))) break;
      given.push(argument);
      rest = rest.slice(word.length);
    }
    options.set(option[1], given);
  }
}
