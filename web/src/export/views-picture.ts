import { download } from '../base/download';
import type { Views } from '../view/views';
import { SAVED, VIEWS_PICTURE } from '../words/exported';
import { drawLegend, drawTiles, type Place } from './legend-picture';

/** Saves both views side by side as they are seen, as PNG. Returns what was done, for people. */
export async function savePicture(views: Views, meshName: string): Promise<string> {
  const { mesh, layout, pixelRatio } = await views.pictures();
  const picture = sideBySide(mesh, layout, pixelRatio);
  const blob = await new Promise<Blob | null>((resolve) => picture.toBlob(resolve, 'image/png'));
  if (!blob) throw new Error(VIEWS_PICTURE.notMade);
  const name = `${meshName.replace(/\.[^.]*$/, '')}-views.png`;
  download(name, blob.type, blob);
  return SAVED.saved(name, SAVED.pixels(picture.width, picture.height));
}

/** With a line between them, and what lies above the layout on the page. */
function sideBySide(
  left: HTMLCanvasElement,
  right: HTMLCanvasElement,
  pixelRatio: number,
): HTMLCanvasElement {
  const picture = document.createElement('canvas');
  const line = Math.round(pixelRatio);
  picture.width = left.width + line + right.width;
  picture.height = Math.max(left.height, right.height);
  const pen = picture.getContext('2d');
  if (!pen) throw new Error(VIEWS_PICTURE.noMemory);
  const style = getComputedStyle(document.documentElement);
  const color = (name: string) => style.getPropertyValue(name).trim();
  pen.fillStyle = color('--view');
  pen.fillRect(0, 0, picture.width, picture.height);
  const middle = (height: number) => Math.round((picture.height - height) / 2);
  const place: Place = { x: left.width + line, y: middle(right.height), pixelRatio };
  pen.drawImage(left, 0, middle(left.height));
  pen.drawImage(right, place.x, place.y);
  pen.fillStyle = color('--line');
  pen.fillRect(left.width, 0, line, picture.height);
  drawTiles(pen, place, color);
  drawLegend(pen, { ...place, right: picture.width, bottom: place.y + right.height }, color);
  return picture;
}
