// Every key and gesture of the page, as the help shows them.

/** Keys as events name them, with Ctrl+ and Shift+ in front of them. */
export interface Control {
  keys: string[];
  /** The same by mouse or by touch. */
  gestures?: string;
  does: string;
}

export interface ControlGroup {
  title: string;
  /** What must have the focus, for people. */
  where?: string;
  controls: Control[];
}

export const CONTROLS: ControlGroup[] = [
  {
    title: 'Mesh view',
    where: 'Click the mesh first. 1, 3, 7, 9 and Home are those of Blender.',
    controls: [
      {
        keys: ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'],
        gestures: 'drag',
        does: 'Turn',
      },
      { keys: ['+', '=', '-'], gestures: 'wheel, pinch', does: 'Zoom' },
      { keys: [], gestures: 'Shift-drag, right drag, two fingers', does: 'Move' },
      { keys: ['1', '3', '7'], does: 'Look from the front, the right, the top' },
      { keys: ['9'], does: 'Look from the other side' },
      { keys: ['Home', '0'], does: 'Show the whole mesh' },
      { keys: ['Z'], does: 'From charts to the shading before, and back' },
    ],
  },
  {
    title: 'Layout view',
    where: 'Click the layout first.',
    controls: [
      {
        keys: ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'],
        gestures: 'drag',
        does: 'Move',
      },
      { keys: ['+', '=', '-'], gestures: 'wheel, pinch', does: 'Zoom' },
      { keys: ['Home', '0'], gestures: 'double-click', does: 'Show the whole layout' },
      { keys: ['Z'], does: 'From charts to the shading before, and back' },
    ],
  },
  {
    title: 'Meshes in tabs',
    where: 'Above the mesh, where several are open.',
    controls: [
      { keys: ['ArrowLeft', 'ArrowRight', 'Home', 'End'], does: 'Next tab' },
      { keys: ['Enter', 'Space'], gestures: 'click', does: 'Open its mesh' },
      { keys: ['Delete'], gestures: '×', does: 'Close it' },
    ],
  },
  {
    title: 'Details and t',
    controls: [
      { keys: ['ArrowLeft', 'ArrowRight', 'Home', 'End'], does: 'Next tab, next point of a plot' },
      { keys: ['Enter', 'Space'], gestures: 'click', does: 'Use the t of that point' },
      { keys: ['ArrowUp', 'ArrowDown'], does: 'Step the number beside t' },
    ],
  },
  {
    title: 'Seams',
    where: 'In the mesh view, with Cut or Join pressed.',
    controls: [
      { keys: [], gestures: 'click, tap', does: 'Start or end a cut; remove a seam' },
      { keys: ['L'], gestures: 'double-click, double-tap', does: 'Cut the loop of an edge' },
      { keys: ['Enter', 'Space'], does: 'Click in the middle of the view' },
      { keys: ['Shift'], gestures: 'Shift-click', does: 'Continue a cut; remove a single edge' },
      { keys: ['Alt'], gestures: 'Alt-click', does: 'Join in place of Cut, Cut in place of Join' },
      { keys: ['Escape'], does: 'Cancel the cut' },
    ],
  },
  {
    title: 'Bounds',
    where: 'In both views of a mesh in one piece.',
    controls: [
      { keys: ['B'], does: 'Paint bounds, or stop painting' },
      { keys: [], gestures: 'drag along the boundary', does: 'Paint the bound beside the button' },
      { keys: ['Alt'], gestures: 'Alt-drag', does: 'Erase bounds' },
      { keys: ['Enter', 'Space'], does: 'Paint in the middle of the view' },
    ],
  },
  {
    title: 'Charts',
    where: 'In the layout view, or in the mesh view with Select pressed.',
    controls: [
      { keys: [], gestures: 'click, tap', does: 'Select a chart' },
      { keys: [], gestures: 'Shift-click', does: 'Add a chart, or take it away' },
      { keys: ['Enter', 'Space'], does: 'Select the chart in the middle of the view' },
      { keys: ['A', 'Alt+A'], does: 'Select all, nothing' },
      { keys: ['.'], does: 'Frame the selected charts' },
      { keys: ['/'], does: 'Isolate them; again shows all' },
      { keys: ['H', 'Alt+H'], does: 'Hide them, show all' },
      {
        keys: ['G', 'R', 'S'],
        gestures: 'drag moves',
        does: 'Move, turn, scale them in the layout',
      },
      { keys: ['Escape'], does: 'Select nothing' },
    ],
  },
  {
    title: 'Pins',
    where: 'In the layout view. P, or Pin above it, begins and ends it.',
    controls: [
      { keys: ['P'], does: 'Pin vertices; again ends it' },
      { keys: [], gestures: 'click, tap', does: 'Pin a vertex; remove a pin' },
      { keys: ['Enter', 'Space'], does: 'The same in the middle of the view' },
      { keys: ['G'], gestures: 'drag', does: 'Move a pin: its chart follows, its other pins stay' },
      { keys: ['Escape'], does: 'End it' },
    ],
  },
  {
    title: 'Moving charts',
    where: 'After G, R or S in the layout view, or while a chart or a pin is dragged.',
    controls: [
      { keys: ['X', 'Y'], does: 'Move along one axis; again frees it' },
      { keys: ['Ctrl'], does: 'Keep to whole texels, 5°, tenths' },
      {
        keys: ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'],
        does: 'By a texel, 1°, 1 %; with Shift by ten',
      },
      { keys: ['Backspace'], gestures: 'a number', does: 'In UV, degrees or as a factor' },
      { keys: ['Enter', 'Space'], gestures: 'click', does: 'Place them' },
      { keys: ['Escape'], gestures: 'right click', does: 'Put them back' },
    ],
  },
  {
    title: 'Page',
    controls: [
      { keys: ['Ctrl+O'], gestures: 'drop a file', does: 'Open a mesh' },
      { keys: ['Ctrl+V'], does: 'Open a copied file, address or text of a mesh' },
      { keys: ['Ctrl+S'], does: 'Export' },
      { keys: ['Ctrl+E'], does: 'Export in another format' },
      { keys: ['Ctrl+Z'], does: 'Undo' },
      { keys: ['Ctrl+Shift+Z', 'Ctrl+Y'], does: 'Redo' },
      { keys: ['Escape'], does: 'Cancel what runs, close what is open' },
      { keys: ['?'], does: 'Show this sheet' },
    ],
  },
];
