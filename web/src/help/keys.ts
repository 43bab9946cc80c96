// Every key and gesture of the page, as the help shows them.

import { GESTURES, HELP } from '../words/help';

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
    title: HELP.mesh.title,
    where: HELP.mesh.where,
    controls: [
      {
        keys: ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'],
        gestures: GESTURES.turnView,
        does: HELP.mesh.turn,
      },
      { keys: ['+', '=', '-'], gestures: GESTURES.wheel, does: HELP.mesh.zoom },
      { keys: [], gestures: GESTURES.moveView, does: HELP.mesh.move },
      { keys: ['1', '3', '7'], does: HELP.mesh.lookFrom },
      { keys: ['Ctrl+1', 'Ctrl+3', 'Ctrl+7'], does: HELP.mesh.opposite },
      { keys: ['9'], does: HELP.mesh.otherSide },
      { keys: ['5'], does: HELP.mesh.flat },
      { keys: ['Home', '0'], does: HELP.mesh.whole },
      { keys: ['Z'], does: HELP.mesh.shading },
    ],
  },
  {
    title: HELP.layout.title,
    where: HELP.layout.where,
    controls: [
      {
        keys: ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'],
        gestures: GESTURES.moveLayout,
        does: HELP.layout.move,
      },
      { keys: ['+', '=', '-'], gestures: GESTURES.wheel, does: HELP.layout.zoom },
      { keys: ['Home', '0'], gestures: GESTURES.doubleClick, does: HELP.layout.whole },
      { keys: ['Z'], does: HELP.layout.shading },
    ],
  },
  {
    title: HELP.tabs.title,
    where: HELP.tabs.where,
    controls: [
      { keys: ['ArrowLeft', 'ArrowRight', 'Home', 'End'], does: HELP.tabs.next },
      { keys: ['Enter', 'Space'], gestures: GESTURES.click, does: HELP.tabs.open },
      { keys: ['Delete'], gestures: GESTURES.closeButton, does: HELP.tabs.close },
    ],
  },
  {
    title: HELP.details.title,
    controls: [
      { keys: ['ArrowLeft', 'ArrowRight', 'Home', 'End'], does: HELP.details.next },
      { keys: ['Enter', 'Space'], gestures: GESTURES.click, does: HELP.details.use },
      { keys: ['ArrowUp', 'ArrowDown'], does: HELP.details.step },
      { keys: [], gestures: GESTURES.shiftClick, does: HELP.details.add },
    ],
  },
  {
    title: HELP.seams.title,
    where: HELP.seams.where,
    controls: [
      { keys: [], gestures: GESTURES.tap, does: HELP.seams.click },
      { keys: ['L'], gestures: GESTURES.doubleTap, does: HELP.seams.loop },
      { keys: ['Enter', 'Space'], does: HELP.seams.middle },
      { keys: ['Shift'], gestures: GESTURES.shiftClick, does: HELP.seams.goOn },
      { keys: ['Alt'], gestures: GESTURES.altClick, does: HELP.seams.otherTool },
      { keys: ['Ctrl'], gestures: GESTURES.ctrlDrag, does: HELP.seams.paint },
      { keys: ['C'], does: HELP.seams.togglePaint },
      { keys: ['Escape'], does: HELP.seams.cancel },
    ],
  },
  {
    title: HELP.bounds.title,
    where: HELP.bounds.where,
    controls: [
      { keys: ['B'], does: HELP.bounds.toggle },
      { keys: [], gestures: GESTURES.dragBoundary, does: HELP.bounds.paint },
      { keys: ['Alt'], gestures: GESTURES.altDrag, does: HELP.bounds.erase },
      { keys: ['Enter', 'Space'], does: HELP.bounds.middle },
    ],
  },
  {
    title: HELP.densities.title,
    where: HELP.densities.where,
    controls: [
      { keys: ['D'], does: HELP.densities.toggle },
      { keys: [], gestures: GESTURES.dragMesh, does: HELP.densities.paint },
      { keys: ['Alt'], gestures: GESTURES.altDrag, does: HELP.densities.erase },
      { keys: ['Enter', 'Space'], does: HELP.densities.middle },
    ],
  },
  {
    title: HELP.charts.title,
    where: HELP.charts.where,
    controls: [
      { keys: [], gestures: GESTURES.tap, does: HELP.charts.select },
      { keys: [], gestures: GESTURES.shiftClick, does: HELP.charts.add },
      { keys: ['Enter', 'Space'], does: HELP.charts.middle },
      { keys: ['B'], gestures: GESTURES.dragBeside, does: HELP.charts.box },
      { keys: ['Ctrl'], gestures: GESTURES.ctrlDragLayout, does: HELP.charts.lasso },
      { keys: ['A', 'Alt+A'], does: HELP.charts.all },
      { keys: ['I'], does: HELP.charts.invert },
      { keys: ['.'], does: HELP.charts.frame },
      { keys: ['/'], does: HELP.charts.isolate },
      { keys: ['H', 'Alt+H'], does: HELP.charts.hide },
      {
        keys: ['G', 'R', 'S'],
        gestures: GESTURES.dragMoves,
        does: HELP.charts.move,
      },
      { keys: ['E'], does: HELP.charts.align },
      { keys: ['F'], does: HELP.charts.flip },
      { keys: ['Escape'], does: HELP.charts.none },
    ],
  },
  {
    title: HELP.pins.title,
    where: HELP.pins.where,
    controls: [
      { keys: ['P'], does: HELP.pins.toggle },
      { keys: [], gestures: GESTURES.tap, does: HELP.pins.pin },
      { keys: ['Enter', 'Space'], does: HELP.pins.middle },
      { keys: ['G'], gestures: GESTURES.drag, does: HELP.pins.move },
      { keys: ['Escape'], does: HELP.pins.end },
    ],
  },
  {
    title: HELP.moving.title,
    where: HELP.moving.where,
    controls: [
      { keys: ['X', 'Y'], does: HELP.moving.axis },
      { keys: ['Ctrl'], does: HELP.moving.snap },
      {
        keys: ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'],
        does: HELP.moving.nudge,
      },
      { keys: ['Backspace'], gestures: GESTURES.number, does: HELP.moving.type },
      { keys: ['Enter', 'Space'], gestures: GESTURES.click, does: HELP.moving.place },
      { keys: ['Escape'], gestures: GESTURES.rightClick, does: HELP.moving.putBack },
    ],
  },
  {
    title: HELP.page.title,
    controls: [
      { keys: ['Ctrl+O'], gestures: GESTURES.dropFile, does: HELP.page.open },
      { keys: ['Ctrl+V'], does: HELP.page.paste },
      { keys: ['Ctrl+S'], does: HELP.page.export },
      { keys: ['Ctrl+E'], does: HELP.page.exportAs },
      { keys: ['Ctrl+Z'], does: HELP.page.undo },
      { keys: ['Ctrl+Shift+Z', 'Ctrl+Y'], does: HELP.page.redo },
      { keys: ['Escape'], does: HELP.page.cancel },
      { keys: ['?'], does: HELP.page.help },
    ],
  },
];
