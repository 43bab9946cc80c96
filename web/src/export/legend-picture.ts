// What the page shows above the layout, drawn into a picture of it.

import { element } from '../base/dom';

/** Where the layout lies in the picture, in pixels. */
export interface Place {
  x: number;
  y: number;
  /** Pixels per css pixel. */
  pixelRatio: number;
}

type Pen = CanvasRenderingContext2D;
/** A colour of the theme, by the name of its variable. */
type ColorOf = (name: string) => string;

/** In css pixels. */
const LEGEND = { width: 224, height: 62, margin: 10, padding: 10, ramp: 8 };
const RAMP = ['--ramp-0', '--ramp-1', '--ramp-2', '--ramp-3'];
const TWO_SIDED = ['--heat-less', '--heat-same', '--heat-more'];

/** Title, scale and its ends in the lower right corner, if a heat map is shown. */
export function drawLegend(
  pen: Pen,
  { right, bottom, pixelRatio }: Place & { right: number; bottom: number },
  color: ColorOf,
): void {
  if (element('legend', HTMLElement).hidden) return;
  const { width, height, margin, padding, ramp } = LEGEND;
  pen.save();
  pen.translate(right - (width + margin) * pixelRatio, bottom - (height + margin) * pixelRatio);
  pen.scale(pixelRatio, pixelRatio);
  drawBox(pen, color);
  const inner = width - 2 * padding;
  pen.fillStyle = rampOf(pen, padding, inner, color);
  pen.fillRect(padding, 28, inner, ramp);
  const text = (id: string) => element(id, HTMLElement).textContent ?? '';
  write(pen, text('legend-title'), padding, 20, `600 12px ${fontOf()}`, color('--text'));
  write(pen, text('legend-low'), padding, 52, `12px ${fontOf()}`, color('--muted'));
  pen.textAlign = 'right';
  write(pen, text('legend-most'), width - padding, 52, `12px ${fontOf()}`, color('--muted'));
  pen.restore();
}

function drawBox(pen: Pen, color: ColorOf): void {
  pen.beginPath();
  pen.roundRect(0.5, 0.5, LEGEND.width - 1, LEGEND.height - 1, 6);
  pen.fillStyle = color('--panel');
  pen.fill();
  pen.strokeStyle = color('--line');
  pen.stroke();
}

function rampOf(pen: Pen, from: number, width: number, color: ColorOf): CanvasGradient {
  const isTwoSided = element('legend-bar', HTMLElement).classList.contains('two-sided');
  const names = isTwoSided ? TWO_SIDED : RAMP;
  const ramp = pen.createLinearGradient(from, 0, from + width, 0);
  names.forEach((name, i) => {
    ramp.addColorStop(i / (names.length - 1), color(name));
  });
  return ramp;
}

/** The numbers of UDIM tiles, where the page has them. */
export function drawTiles(pen: Pen, { x, y, pixelRatio }: Place, color: ColorOf): void {
  const tiles = element('tiles', HTMLElement);
  const around = tiles.getBoundingClientRect();
  pen.save();
  pen.translate(x, y);
  pen.scale(pixelRatio, pixelRatio);
  pen.strokeStyle = color('--view');
  pen.lineWidth = 3;
  pen.lineJoin = 'round';
  for (const tile of tiles.children) {
    const { left, bottom } = tile.getBoundingClientRect();
    const [at, base, text] = [left - around.left, bottom - around.top - 3, tile.textContent ?? ''];
    pen.font = `11px ${fontOf()}`;
    pen.strokeText(text, at, base);
    write(pen, text, at, base, pen.font, color('--text'));
  }
  pen.restore();
}

function write(pen: Pen, text: string, x: number, y: number, font: string, color: string): void {
  pen.font = font;
  pen.fillStyle = color;
  pen.fillText(text, x, y);
}

const fontOf = () => getComputedStyle(document.body).fontFamily;
