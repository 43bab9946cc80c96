import type { FlatDrawing } from '../model/drawing';
import { drawLayout } from './draw-layout';
import { drawFlatMesh, drawMarks } from './draw-mesh';
import type { FlatPicture } from './picture';

/** Both views of a layout; `chartCount` is the number of charts of an atlas, 0 for a disk. */
export function drawFlat(picture: FlatPicture, chartCount: number): FlatDrawing {
  return {
    mesh: drawFlatMesh(picture, chartCount),
    layout: drawLayout(picture, chartCount),
    marks: drawMarks(picture),
    spreads: picture.heat.spreads,
    chartColors: picture.chartColors ?? null,
  };
}
