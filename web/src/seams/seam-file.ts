import { edgeBetween, type SurfaceGraph } from '../surface/surface-graph';
import { SEAM_FILES } from '../words/seams';

/** Its message names the file, the line and the problem. */
export class BadSeamFile extends Error {}

/**
 * One edge per line, as two vertex numbers from 0; a # starts a comment. The command line reads and
 * writes the same format.
 */
export function seamText(pairs: Uint32Array): string {
  const lines: string[] = [];
  for (let i = 0; i + 1 < pairs.length; i += 2) lines.push(`${pairs[i]} ${pairs[i + 1]}\n`);
  return lines.join('');
}

/**
 * The edges listed in such a file, two vertices each. Throws if a line is not an edge; `name` is
 * the file's name.
 */
export function readSeams(graph: SurfaceGraph, text: string, name: string): Uint32Array {
  const pairs: number[] = [];
  text.split(/\r?\n/).forEach((line, i) => {
    const content = line.replace(/#.*/, '').trim();
    if (content === '') return;
    const where = SEAM_FILES.where(name, i + 1);
    const numbers = /^(\d+)\s+(\d+)$/.exec(content);
    if (!numbers) throw new BadSeamFile(SEAM_FILES.notTwoNumbers(where));
    const [from, to] = [Number(numbers[1]), Number(numbers[2])];
    const missing = [from, to].find((v) => v >= graph.places.length);
    if (missing !== undefined)
      throw new BadSeamFile(SEAM_FILES.noVertex(where, missing, graph.places.length - 1));
    if (edgeBetween(graph, from, to) < 0) throw new BadSeamFile(SEAM_FILES.noEdge(where, from, to));
    pairs.push(from, to);
  });
  return Uint32Array.from(pairs);
}
