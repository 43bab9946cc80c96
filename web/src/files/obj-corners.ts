// What an OBJ says about how its faces look. Its faces are known to be well formed.

export const NO_TEXCOORD = -1;

export interface ObjCorners {
  /** The corners of face f are those from `offsets[f]` up to `offsets[f + 1]`. */
  offsets: number[];
  vertices: number[];
  /** The texcoord of each corner. */
  texcoordOf: number[];
  /** The normal of each corner; undefined where there is none. */
  normalOf: (number | undefined)[];
  /** x, y and z of each normal. */
  normals: number[];
  /** u and v of each texcoord. */
  texcoords: number[];
  /** The material of each face, as a number of `names`. */
  materials: number[];
  names: string[];
  /** Arguments of `mtllib`, each once. */
  libraries: string[];
  /** Red, green and blue per vertex, NaN where there are none; null if no vertex has any. */
  colors: number[] | null;
}

/** Nothing yet but the material without a name, which faces before the first `usemtl` have. */
export const noCorners = (): ObjCorners => ({
  offsets: [0],
  vertices: [],
  texcoordOf: [],
  normalOf: [],
  normals: [],
  texcoords: [],
  materials: [],
  names: [''],
  libraries: [],
  colors: null,
});

export function readObjCorners(text: string): ObjCorners {
  const state = { vertexCount: 0, material: 0, ...noCorners() };
  for (const line of linesOf(text)) readLine(line, state);
  const { vertexCount, material: _, ...read } = state;
  if (read.colors) fillColors(read.colors, vertexCount);
  return read;
}

interface State extends ObjCorners {
  vertexCount: number;
  /** Of the faces to come. */
  material: number;
}

/** Without blanks around them; a backslash joins lines of faces and vertices. */
export function* linesOf(text: string): Generator<string> {
  const end = text.includes('\n') ? '\n' : '\r';
  let joined = '';
  for (let at = 0; at < text.length; ) {
    const next = text.indexOf(end, at);
    const line = text.slice(at, next < 0 ? text.length : next).trim();
    at = next < 0 ? text.length : next + 1;
    // Names of materials may end like that, too.
    const isContinued = line.endsWith('\\') && /^(f|v|vt)\s/.test(joined || line);
    if (isContinued) joined += `${line.slice(0, -1)} `;
    else {
      yield joined + line;
      joined = '';
    }
  }
  if (joined) yield joined;
}

function readLine(line: string, state: State): void {
  if (line.startsWith('f ') || line.startsWith('f\t')) readFace(wordsOf(line), state);
  else if (line.startsWith('v ') || line.startsWith('v\t')) readVertex(line, state);
  else if (line.startsWith('vt')) readTexcoord(wordsOf(line), state);
  else if (line.startsWith('vn')) state.normals.push(...wordsOf(line).slice(0, 3).map(Number));
  else if (line.startsWith('usemtl')) useMaterial(line.slice(6).trim(), state);
  else if (line.startsWith('mtllib')) {
    const name = line.slice(6).trim();
    if (!state.libraries.includes(name)) state.libraries.push(name);
  }
}

/** Without the keyword and a comment. */
function wordsOf(line: string): string[] {
  const hash = line.indexOf('#');
  const words = (hash < 0 ? line : line.slice(0, hash)).split(/\s+/);
  words.shift();
  if (words.at(-1) === '') words.pop();
  return words;
}

/** "v/vt/vn"; 0 for what is not there. */
function cornerOf(word: string): [number, number, number] {
  const first = word.indexOf('/');
  if (first < 0) return [Number(word), 0, 0];
  const second = word.indexOf('/', first + 1);
  const texcoord = word.slice(first + 1, second < 0 ? word.length : second);
  const normal = second < 0 ? 0 : Number(word.slice(second + 1));
  return [Number(word.slice(0, first)), Number(texcoord), normal];
}

function readFace(words: string[], state: State): void {
  const texcoordCount = state.texcoords.length / 2;
  for (const word of words) {
    const [vertex, texcoord, normal] = cornerOf(word);
    state.vertices.push(vertex > 0 ? vertex - 1 : state.vertexCount + vertex);
    const t = texcoord > 0 ? texcoord - 1 : texcoordCount + texcoord;
    state.texcoordOf.push(texcoord && t >= 0 ? t : NO_TEXCOORD);
    const n = normal > 0 ? normal - 1 : state.normals.length / 3 + normal;
    state.normalOf.push(normal && n >= 0 ? n : undefined);
  }
  state.offsets.push(state.vertices.length);
  state.materials.push(state.material);
}

/** "x y z r g b"; with four numbers the last is a weight. */
function readVertex(line: string, state: State): void {
  const { vertexCount } = state;
  state.vertexCount += 1;
  const words = wordsOf(line);
  if (words.length !== 6) return;
  state.colors ??= [];
  fillColors(state.colors, vertexCount);
  state.colors.push(...words.slice(3).map(Number));
}

function fillColors(colors: number[], vertexCount: number): void {
  while (colors.length < 3 * vertexCount) colors.push(Number.NaN);
}

/** The second coordinate may be omitted. */
function readTexcoord([u, v = '0']: string[], state: State): void {
  state.texcoords.push(Number(u), Number(v));
}

function useMaterial(name: string, state: State): void {
  const known = state.names.indexOf(name);
  state.material = known < 0 ? state.names.push(name) - 1 : known;
}
