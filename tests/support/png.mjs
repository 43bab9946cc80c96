// Reads PNG files with 8 bits for each of red, green, blue and alpha, or without alpha, or grey.

import assert from 'node:assert/strict';
import { crc32, inflateSync } from 'node:zlib';

const SIGNATURE = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);

/** [type, data] of each chunk; checks the checksums. */
function chunksOf(bytes) {
  assert.deepEqual(bytes.subarray(0, 8), SIGNATURE);
  const chunks = [];
  for (let at = 8; at < bytes.length; ) {
    const size = bytes.readUInt32BE(at);
    const typed = bytes.subarray(at + 4, at + 8 + size);
    if (crc32) assert.equal(bytes.readUInt32BE(at + 8 + size), crc32(typed));
    chunks.push([typed.toString('latin1', 0, 4), typed.subarray(4)]);
    at += 12 + size;
  }
  return chunks;
}

function paeth(a, b, c) {
  const [pa, pb, pc] = [a, b, c].map((x) => Math.abs(a + b - c - x));
  if (pa <= pb && pa <= pc) return a;
  return pb <= pc ? b : c;
}

/** { width, height, channels, at(x, y) } with the numbers of a pixel, counted from the upper left. */
export function parsePng(bytes) {
  const chunks = chunksOf(bytes);
  assert.equal(chunks.at(-1)[0], 'IEND');
  const header = chunks.find(([type]) => type === 'IHDR')[1];
  const [width, height] = [header.readUInt32BE(0), header.readUInt32BE(4)];
  const channels = { 0: 1, 2: 3, 6: 4 }[header[9]];
  assert.deepEqual([...header.subarray(8)], [8, header[9], 0, 0, 0]);
  const data = inflateSync(
    Buffer.concat(chunks.filter(([type]) => type === 'IDAT').map(([, part]) => part)),
  );
  const stride = channels * width;
  assert.equal(data.length, height * (stride + 1));
  const pixels = Buffer.alloc(height * stride);
  for (let y = 0; y < height; y++) {
    const filter = data[y * (stride + 1)];
    for (let i = 0; i < stride; i++) {
      const at = y * stride + i;
      const a = i < channels ? 0 : pixels[at - channels];
      const b = y === 0 ? 0 : pixels[at - stride];
      const c = i < channels || y === 0 ? 0 : pixels[at - stride - channels];
      const predicted = [0, a, b, (a + b) >> 1, paeth(a, b, c)][filter];
      pixels[at] = data[y * (stride + 1) + 1 + i] + predicted;
    }
  }
  return {
    width,
    height,
    channels,
    at: (x, y) => [...pixels.subarray(y * stride + channels * x, y * stride + channels * (x + 1))],
  };
}
