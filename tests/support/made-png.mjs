// Makes PNG files with 8 bits each for red, green, blue and alpha.

import { crc32, deflateSync } from 'node:zlib';

const SIGNATURE = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);

function chunk(type, data) {
  const typed = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const out = Buffer.alloc(typed.length + 8);
  out.writeUInt32BE(data.length, 0);
  typed.copy(out, 4);
  out.writeUInt32BE(crc32(typed), typed.length + 4);
  return out;
}

/** `pixels` has four bytes for each pixel, in rows from the upper left. */
export function encodedPng(width, height, pixels) {
  const stride = 4 * width;
  const rows = Buffer.alloc(height * (stride + 1));
  for (let y = 0; y < height; y++)
    rows.set(pixels.subarray(y * stride, (y + 1) * stride), y * (stride + 1) + 1);
  return pngOf(width, height, [8, 6], rows);
}

/** `kind`: bits of a channel, and which channels there are. */
function pngOf(width, height, kind, rows) {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set(kind, 8);
  return Buffer.concat([
    SIGNATURE,
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(rows)),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

/** One bit for each pixel, all black but the first few. */
export function greyPng(width, height, first = 0) {
  const rows = Buffer.alloc(height * (Math.ceil(width / 8) + 1));
  rows[1] = first;
  return pngOf(width, height, [1, 0], rows);
}

/** `at(x, y)` has the three or four numbers of a pixel, counted from the upper left. */
export function madePng(width, height, at) {
  const pixels = Buffer.alloc(4 * width * height);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const [red, green, blue, alpha = 255] = at(x, y);
      pixels.set([red, green, blue, alpha], 4 * (y * width + x));
    }
  return encodedPng(width, height, pixels);
}

/** Grey with 16 bits; `at(x, y)` is from 0 to 65535. */
export function grey16Png(width, height, at) {
  const rows = Buffer.alloc(height * (2 * width + 1));
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) rows.writeUInt16BE(at(x, y), y * (2 * width + 1) + 1 + 2 * x);
  return pngOf(width, height, [16, 0], rows);
}
