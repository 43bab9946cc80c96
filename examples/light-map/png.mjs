// Writes PNG files.

import { crc32, deflateSync } from 'node:zlib';

const toSrgb = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);

/** Linear colours as 8 bits of sRGB. */
export function pngOf({ side, colours }) {
  const rows = Buffer.alloc(side * (1 + 3 * side));
  for (let y = 0; y < side; ++y)
    for (let i = 0; i < 3 * side; ++i) {
      const value = Math.min(1, Math.max(0, colours[3 * side * y + i]));
      rows[y * (1 + 3 * side) + 1 + i] = Math.round(255 * toSrgb(value));
    }
  const header = Buffer.alloc(13);
  header.writeUInt32BE(side, 0);
  header.writeUInt32BE(side, 4);
  header.set([8, 2, 0, 0, 0], 8); // 8 bits, RGB
  const chunks = [
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(rows)),
    chunk('IEND', Buffer.alloc(0)),
  ];
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), ...chunks]);
}

function chunk(type, data) {
  const out = Buffer.alloc(12 + data.length);
  out.writeUInt32BE(data.length, 0);
  out.write(type, 4, 'latin1');
  data.copy(out, 8);
  out.writeUInt32BE(crc32(out.subarray(4, 8 + data.length)), 8 + data.length);
  return out;
}
