// Everything that the page's scripts say to people, by room and with the numbers and names that go into it. What is always on the page
// is in index.html. Errors that only a developer can meet stay where they are thrown.

import { type Bound, bound, count, counted, measure } from './format';

// Rooms: base, view, drawing, mesh, files, workshop, opening, export

/** Said where a part of the page or a worker is missing. */
export const LOST = {};

// Rooms: model, controls, plot, details

// Rooms: session, seams, selection, arrange, help, and the top room

/** What laying out a mesh in one piece and in charts is called; `verb` is on a button. */
export const LAYING_OUT = {
  flatten: { doing: 'Flattening', done: 'Flattened', verb: 'Flatten' },
  unwrap: { doing: 'Unwrapping', done: 'Unwrapped', verb: 'Unwrap' },
};

/** The settings of a layout, which are listed in one line. */
export const SETTINGS = {
  seamEdges: (edges: number) => counted(edges, 'seam edge'),
  seams: (sources: string) => `seams ${sources}`,
  stretch: (most: number) => `stretch up to ${most}`,
  size: (pixels: number, padding: number) => `${pixels}\u202fpx, padding ${padding}`,
  balance: (balance: number) => `balance ${balance}`,
  delaunay: 'Delaunay',
  ownBounds: (vertices: number) => `own bounds of ${counted(vertices, 'vertex', 'vertices')}`,
  t: (t: Bound) => `t = ${bound(t)}`,
};

/** Steps in the history. */
export const CHANGES = {
  opened: (title: string) => `Open ${title}`,
  followedLink: 'Settings of a link',
  t: (t: Bound) => `Boundary t ${bound(t)}`,
  balance: (balance: number) => `Balance ${balance}`,
  delaunay: (isOn: boolean) => (isOn ? 'Delaunay' : 'Delaunay off'),
  bounds: (vertices: number) => `Bounds of ${counted(vertices, 'vertex', 'vertices')}`,
  noBounds: 'No own bounds',
  maxStretch: (most: number) => `Max stretch ${most}`,
  resolution: (pixels: number) => `Resolution ${pixels}\u202fpx`,
  padding: (texels: number) => `Padding ${texels}`,
  seams: (sources: string) => `Seams: ${sources.replaceAll(',', ', ')}`,
  seamEdges: (edges: number) => `Seams of ${counted(edges, 'edge')}`,
  noSeamEdges: 'Seams as chosen',
  keptUvs: 'UVs of the file kept',
  noKeptUvs: 'UVs of the file not kept',
  packedAgain: 'Packed again',
  switched: (label: string, isOn: boolean) => (isOn ? label : `${label} off`),
  set: (label: string, value: unknown) => `${label} ${value}`,
  undone: (step: string) => `Undone: ${step}`,
  redone: (step: string) => `Redone: ${step}`,
};

/** What happens to a mesh, and how that ends. */
export const RUN = {
  reading: (title: string) => `Reading ${title}`,
  layingOut: (doing: string, settings: string) => `${doing} with ${settings}`,
  checked: (change: string, time: string) => `${change}, checked in ${time}`,
  laidOut: (done: string, time: string) => `${done} in ${time}`,
  but: (badge: string) => `, ${badge.toLowerCase()}`,
  ownBounds: (bounds: number) => `; ${counted(bounds, 'own bound')}`,
  repacked: '; packed again, as there was too little room',
  kept: 'kept',
  locked: 'locked',
  keptAsInFile: 'as in the file',
  keptAndFixed: (kept: number, fixed: number, fixedAs: string) =>
    `; ${count(kept)} kept, ${count(fixed)} ${fixedAs}`,
  someCharts: (some: number, charts: number, what: string) =>
    `; ${count(some)} of ${counted(charts, 'chart')} ${what}`,
  cancelled: 'Cancelled',
  notOpened: (title: string) => `${title} was not opened`,
  nothingOpened: 'Nothing was opened',
  notLaidOut: (done: string) => `Not ${done.toLowerCase()}`,
  tryAgain: 'Try again',
  /** `done`: what was not; null: the mesh was not opened. */
  failed: (title: string, done: string | null, why: string) =>
    `${title} was not ${done === null ? 'opened' : done.toLowerCase()}: ${why}.`,
};

/** What is on screen. */
export const SHOWN = {
  pageTitle: (title: string) => `${title} \u2013 abflat`,
  triangles: (triangles: number) => counted(triangles, 'triangle'),
  polygons: (faces: number, triangles: number) =>
    `${counted(faces, 'polygon')}, ${counted(triangles, 'triangle')}`,
  charts: (charts: number, tiles: number) =>
    counted(charts, 'chart') + (tiles > 1 ? `, ${counted(tiles, 'tile')}` : ''),
  t: (t: Bound) => `t = ${bound(t)}`,
  /** `t` is null where the boundary is free, except at tightened vertices. */
  automaticT: (t: number | null, tightened: number) => {
    const but = tightened > 0 ? ` except at ${counted(tightened, 'vertex', 'vertices')}` : '';
    return `t = auto: ${t === null ? 'free' : bound(t)}${but}`;
  },
  owner: (title: string, settings: string) => `${title}, ${settings}`,
  still: (what: string) => `Still showing ${what}`,
  stillSentence: (what: string) => `Still showing ${what}.`,
  comparison: (method: string) => `Comparison, not exported: ${method}`,
  noMaterials: (name: string) =>
    `The materials of ${name} could not be read. Open it again to see them.`,
  noWebGl:
    'WebGL 2 is off or missing in this browser, so nothing can be drawn. Unwrapping and export still work.',
};

/** Why a mesh cannot be read. */
export const READING = {
  noMesh: 'Open a mesh first.',
  empty: (name: string) => `${name} is empty.`,
  notSupported: (name: string) => `${name} is not supported. Use OBJ, PLY, STL, OFF, glTF or GLB.`,
  withoutFaces: (name: string, vertices: number) => {
    const content =
      vertices > 0 ? `${counted(vertices, 'vertex', 'vertices')} but no faces` : 'no faces';
    return `${name} has ${content}, so there is nothing to unwrap. Save it with its faces.`;
  },
  /** `reason` is a sentence of the browser. */
  unreadable: (name: string, reason: string) =>
    `${name} cannot be read (${reason}) Choose the file again.`,
};

/** Why nothing is saved. */
export const SAVING = {
  notDrawn: 'Nothing is drawn, so there is no picture',
  failed: (title: string, message: string) =>
    `${title} was not saved: ${message.replace(/\.$/, '')}.`,
  cameOutDifferently: 'The layout came out differently. Lay it out again, then export it.',
};

/** The mesh and settings that the page starts with. */
export const VISIT = {
  restored: (title: string) => `Restored ${title} from your last visit`,
  stoppedOpening:
    'The mesh of your last visit was not opened again, because the page stopped while opening it.',
  tooLarge: 'The mesh of your last visit was too large to keep. Open it again.',
  unreadable: 'Your last visit could not be restored.',
  notRestored: (title: string, message: string) =>
    `${title} could not be restored from your last visit: ${message.replace(/\.$/, '')}.`,
  notOffered: (words: string) => `The link asks for ${words}, which this page does not offer.`,
};

/** Bounds that are painted on a boundary. */
export const BOUNDS = {
  invitation: 'Drag along the boundary',
  value: (t: number, meaning: string) => `${bound(t)}, ${meaning}`,
  erasing: (vertices: number) => `${counted(vertices, 'vertex', 'vertices')}: erase`,
  painting: (vertices: number, value: string) =>
    `${counted(vertices, 'vertex', 'vertices')}: paint ${value}`,
  erased: (vertices: number) => `Erased bounds of ${counted(vertices, 'vertex', 'vertices')}`,
  painted: (vertices: number) => `Painted bounds of ${counted(vertices, 'vertex', 'vertices')}`,
  cleared: 'Cleared all own bounds',
  unchanged: 'No bound has changed',
  noBoundary: 'There is no boundary here',
  notPainted: (reason: string) => `Bounds cannot be painted: ${reason}`,
};

/** Where seams come from. */
export const SEAM_SOURCES = {
  sharpAngle: 'Sharp angle',
  sharpRange: 'above 0 and at most 180 degrees',
  degrees: (degrees: number) => `${degrees}°`,
  edited: (edges: number, isCutFurther: boolean) =>
    `edited: ${counted(edges, 'edge')}${isCutFurther ? ', cut further' : ''}`,
  none: 'fewest possible cuts',
};

/** Seams that are edited. */
export const SEAMS = {
  toCut: 'Click a vertex to start a cut, double-click an edge to cut its loop',
  toJoin: 'Click a seam to join its sides',
  toSelect: 'Click a chart to select it',
  startHere: (vertex: number) => `Vertex ${vertex}: start a cut`,
  orCutLoop: (start: string, edges: number) =>
    `${start}. Double-click: cut a loop of ${counted(edges, 'edge')}`,
  cutTo: (from: number, to: number, edges: number, length: number) =>
    `Vertex ${from} to ${to}: cut ${counted(edges, 'edge')}, ${measure(length)} long`,
  toEndCut: (from: number) => `From vertex ${from}: click the end of the cut, Esc cancels`,
  joinHere: (edges: number) => `Seam of ${counted(edges, 'edge')}: join`,
  neededHere: (edges: number) =>
    `Seam of ${counted(edges, 'edge')}: needed to keep its chart a disk`,
  started: (vertex: number) => `Cut started at vertex ${vertex}`,
  notConnected: (from: number, to: number) => `No edges connect vertex ${from} to vertex ${to}`,
  cut: (edges: number) => `Cut ${counted(edges, 'edge')}`,
  cutLoop: (edges: number) => `Cut a loop of ${counted(edges, 'edge')}`,
  alreadyCut: 'Already cut',
  cancelled: 'Cut cancelled',
  joined: (edges: number) => `Joined ${counted(edges, 'edge')}`,
  needed: 'This seam is needed to keep its chart a disk',
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

/** Charts that are selected or hidden. */
export const SELECTION = {
  hidden: (charts: number) => `${counted(charts, 'chart')} hidden`,
  one: (chart: number, triangles: number, stretch: number) =>
    `Chart ${count(chart)}: ${counted(triangles, 'triangle')}, stretch ${measure(stretch)}`,
  several: (charts: number, triangles: number, share: number) => {
    const percent = `${(100 * share).toFixed(0)}\u202f%`;
    return `${counted(charts, 'chart')}: ${counted(triangles, 'triangle')}, ${percent} of the surface`;
  },
  none: 'Select a chart first',
  locked: 'Locked charts stay. Unlock them to move them',
};

/** What was done to charts, by the names of the menu's entries. */
export const ARRANGED = {
  move: 'Moved',
  turn: 'Turned',
  scale: 'Scaled',
  left: 'Turned',
  right: 'Turned',
  straightened: 'Straightened',
  stacked: 'Stacked',
  evened: 'Evened out',
};

/** Charts that are moved. Numbers come as text. */
export const MOVING = {
  doneToOne: (done: string, chart: number) => `${done} chart ${chart}`,
  doneToSeveral: (done: string, charts: number) => `${done} ${counted(charts, 'chart')}`,
  /** What is typed, as long as it is no number. */
  typed: (typed: string) => ` ${typed}…`,
  turn: (degrees: string) => `Turn ${degrees}°`,
  scale: (factor: string) => `Scale ×${factor}`,
  along: (axis: string, distance: string) => `${axis} ${distance}`,
  /** `shift` is listed by axis. */
  move: (shift: string, texels: string) => `Move ${shift} (${texels} texels)`,
  failed: (message: string) => `The charts were not moved: ${message}`,
  nothingMoved: 'Nothing was moved',
};

/** Vertices of the layout that are pinned. */
export const PINS = {
  invitation: 'Click a vertex to pin it',
  some: (pins: number) =>
    `${counted(pins, 'pin')}. Drag one to bend its chart, click it to remove it`,
  pinned: (chart: number) => `Pinned a vertex of chart ${chart}`,
  removed: (chart: number) => `Removed a pin of chart ${chart}`,
  removedAll: (pins: number) => `Removed ${counted(pins, 'pin')}`,
  moved: (chart: number) => `Moved a pin of chart ${chart}`,
  notMoved: (message: string) => `The pin was not moved: ${message}`,
  locked: 'This chart is locked. Unlock it to drag its pins',
};

/** Keys, where the help does not show them by the names that events give them. */
export const KEY_NAMES: Record<string, string> = {
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  Escape: 'Esc',
  '-': '−',
};

/** The help's groups, in the order of the page; `where` says what must have the focus. */
export const HELP = {
  mesh: {
    title: 'Mesh view',
    where: 'Click the mesh first. 1, 3, 7, 9 and Home are those of Blender.',
    turn: 'Turn',
    zoom: 'Zoom',
    move: 'Move',
    lookFrom: 'Look from the front, the right, the top',
    otherSide: 'Look from the other side',
    whole: 'Show the whole mesh',
    shading: 'From charts to the shading before, and back',
  },
  layout: {
    title: 'Layout view',
    where: 'Click the layout first.',
    move: 'Move',
    zoom: 'Zoom',
    whole: 'Show the whole layout',
    shading: 'From charts to the shading before, and back',
  },
  tabs: {
    title: 'Meshes in tabs',
    where: 'Above the mesh, where several are open.',
    next: 'Next tab',
    open: 'Open its mesh',
    close: 'Close it',
  },
  details: {
    title: 'Details and t',
    next: 'Next tab, next point of a plot',
    use: 'Use the t of that point',
    step: 'Step the number beside t',
  },
  seams: {
    title: 'Seams',
    where: 'In the mesh view, with Cut or Join pressed.',
    click: 'Start or end a cut; remove a seam',
    loop: 'Cut the loop of an edge',
    middle: 'Click in the middle of the view',
    goOn: 'Continue a cut; remove a single edge',
    otherTool: 'Join in place of Cut, Cut in place of Join',
    cancel: 'Cancel the cut',
  },
  bounds: {
    title: 'Bounds',
    where: 'In both views of a mesh in one piece.',
    toggle: 'Paint bounds, or stop painting',
    paint: 'Paint the bound beside the button',
    erase: 'Erase bounds',
    middle: 'Paint in the middle of the view',
  },
  charts: {
    title: 'Charts',
    where: 'In the layout view, or in the mesh view with Select pressed.',
    select: 'Select a chart',
    add: 'Add a chart, or take it away',
    middle: 'Select the chart in the middle of the view',
    all: 'Select all, nothing',
    frame: 'Frame the selected charts',
    isolate: 'Isolate them; again shows all',
    hide: 'Hide them, show all',
    move: 'Move, turn, scale them in the layout',
    none: 'Select nothing',
  },
  pins: {
    title: 'Pins',
    where: 'In the layout view. P, or Pin above it, begins and ends it.',
    toggle: 'Pin vertices; again ends it',
    pin: 'Pin a vertex; remove a pin',
    middle: 'The same in the middle of the view',
    move: 'Move a pin: its chart follows, its other pins stay',
    end: 'End it',
  },
  moving: {
    title: 'Moving charts',
    where: 'After G, R or S in the layout view, or while a chart or a pin is dragged.',
    axis: 'Move along one axis; again frees it',
    snap: 'Keep to whole texels, 5°, tenths',
    nudge: 'By a texel, 1°, 1 %; with Shift by ten',
    type: 'In UV, degrees or as a factor',
    place: 'Place them',
    putBack: 'Put them back',
  },
  page: {
    title: 'Page',
    open: 'Open a mesh',
    paste: 'Open a copied file, address or text of a mesh',
    export: 'Export',
    exportAs: 'Export in another format',
    undo: 'Undo',
    redo: 'Redo',
    cancel: 'Cancel what runs, close what is open',
    help: 'Show this sheet',
  },
};

/** What does in the help the same as keys. */
export const GESTURES = {
  drag: 'drag',
  wheel: 'wheel, pinch',
  moveView: 'Shift-drag, right drag, two fingers',
  doubleClick: 'double-click',
  click: 'click',
  rightClick: 'right click',
  closeButton: '×',
  tap: 'click, tap',
  doubleTap: 'double-click, double-tap',
  shiftClick: 'Shift-click',
  altClick: 'Alt-click',
  dragBoundary: 'drag along the boundary',
  altDrag: 'Alt-drag',
  dragMoves: 'drag moves',
  number: 'a number',
  dropFile: 'drop a file',
};
