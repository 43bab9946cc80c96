// Seams, where they come from and how they are edited.

import { counted, measure } from './format';

/** Where seams come from. */
export const SEAM_SOURCES = {
  sharpAngle: 'Sharp angle',
  sharpRange: 'above 0 and at most 180 degrees',
  degrees: (degrees: number) => `${degrees}°`,
  edited: (edges: number, isCutFurther: boolean) =>
    `seams edited: ${counted(edges, 'edge')}${isCutFurther ? ', cut further' : ''}`,
  none: 'fewest possible seams',
};

/** A loop that ends at once is an edge. */
const loopOf = (edges: number) => (edges === 1 ? '1 edge' : `a loop of ${counted(edges, 'edge')}`);

/** Seams that are edited. */
export const SEAMS = {
  toCut: 'Click a vertex to start a cut, double-click to cut a loop',
  toJoin: 'Click a seam to join its sides',
  toPaint: 'Drag over the mesh to paint a seam',
  toErase: 'Drag over seams to erase them',
  toSelect: 'Click an island to select it',
  startHere: (vertex: number) => `Vertex ${vertex}: start a cut`,
  paintHere: (vertex: number) => `Vertex ${vertex}: drag to paint a seam, or click to start a cut`,
  orCutLoop: (start: string, edges: number) => `${start}. Double-click: cut ${loopOf(edges)}`,
  cutTo: (from: number, to: number, edges: number, length: number) =>
    `Vertex ${from} to ${to}: cut ${counted(edges, 'edge')}, ${measure(length)} long`,
  toEndCut: (from: number) => `From vertex ${from}: click the end of the cut, Esc cancels`,
  /** There is a button for it. */
  toEndCutByTouch: (from: number) => `From vertex ${from}: tap the end of the cut, or Cancel cut`,
  joinHere: (edges: number) => `Seam of ${counted(edges, 'edge')}: join`,
  neededHere: (edges: number) =>
    `Seam of ${counted(edges, 'edge')}: needed to keep its island a disk`,
  started: (vertex: number) => `Cut started at vertex ${vertex}`,
  notConnected: (from: number, to: number) => `No edges connect vertex ${from} to vertex ${to}`,
  cut: (edges: number) => `Cut ${counted(edges, 'edge')}`,
  cutLoop: (edges: number) => `Cut ${loopOf(edges)}`,
  alreadyCut: 'Already cut',
  cancelled: 'Cut cancelled',
  joined: (edges: number) => `Joined ${counted(edges, 'edge')}`,
  needed: 'This seam is needed to keep its island a disk',
  painting: (edges: number) => `Painting ${counted(edges, 'edge')} as seam, Esc cancels`,
  painted: (edges: number) => `Painted ${counted(edges, 'edge')} as seam`,
  /** Along boundaries and seams only. */
  nothingPainted: 'Nothing to cut along this stroke',
  erasing: (edges: number) => `Erasing ${counted(edges, 'seam edge')}, Esc cancels`,
  erased: (edges: number) => `Erased ${counted(edges, 'seam edge')}`,
  nothingErased: 'No seam under this stroke',
  strokeCancelled: 'Stroke cancelled',
  cutFurther: 'Cut further',
  /** Edges that are not cut yet. */
  sharp: (edges: number, degrees: number) =>
    edges === 0
      ? `No other edge bends by more than ${degrees}°`
      : `${counted(edges, 'edge')} ${edges === 1 ? 'bends' : 'bend'} by more than ${degrees}°`,
  markedSharp: (edges: number) => `Marked ${counted(edges, 'sharp edge')}`,
  notEditable: (reason: string) => `Seams cannot be edited: ${reason}`,
};

/** Files with seams; `where`: their name and a line. */
export const SEAM_FILES = {
  saved: (name: string) => `Saved ${name}`,
  opened: (name: string) => `Seams of ${name}`,
  where: (name: string, line: number) => `${name}:${line}`,
  notTwoNumbers: (where: string) => `${where}: expected two vertex numbers, such as '17 42'.`,
  noVertex: (where: string, vertex: number, last: number) =>
    `${where}: there is no vertex ${vertex}; the last one is ${last}.`,
  noEdge: (where: string, from: number, to: number) =>
    `${where}: ${from}-${to} is not an edge of any face.`,
};
