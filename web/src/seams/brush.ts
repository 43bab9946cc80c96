// What a brush goes over: loaded with the first stroke.

import { Vector3 } from 'three';
import type { Solid } from '../surface/solid';
import type { Pixel, Sight } from '../view/sight';
import { between, distance, isInSight, nearestShare, pointOf, REACH } from './pick';

/** The radius of a brush, in css pixels. */
const BRUSH = 8;

/** Those of some vertices that a vertex under one of several pixels could be snapped to. */
export function withinReach(
  solid: Solid,
  sight: Sight,
  pixels: Pixel[],
  vertices: Iterable<number>,
): number[] {
  const [xs, ys] = [pixels.map(({ x }) => x), pixels.map(({ y }) => y)];
  const [left, right] = [Math.min(...xs) - REACH, Math.max(...xs) + REACH];
  const [top, bottom] = [Math.min(...ys) - REACH, Math.max(...ys) + REACH];
  const found: number[] = [];
  for (const v of vertices) {
    const pixel = sight.pixel(solid.points, v);
    if (!pixel || pixel.x < left || pixel.x > right || pixel.y < top || pixel.y > bottom) continue;
    found.push(v);
  }
  return found;
}

/** Those of some points (xyz each) that are within a radius around a pixel, and visible. */
export function pointsAround(
  solid: Solid,
  sight: Sight,
  at: Pixel,
  points: Float32Array,
  radius: number,
): number[] {
  const found: number[] = [];
  for (let i = 0; 3 * i < points.length; ++i) {
    const pixel = sight.pixel(points, i);
    if (!pixel || distance(pixel, at) > radius) continue;
    if (isInSight(solid, sight, new Vector3().fromArray(points, 3 * i))) found.push(i);
  }
  return found;
}

/**
 * Those of `edges` that a brush at a pixel goes over, and that are visible: it must come near their
 * middle part, because at their ends there are others.
 */
export function edgesUnder(
  solid: Solid,
  sight: Sight,
  at: Pixel,
  ends: Uint32Array,
  edges: Iterable<number>,
): number[] {
  const found: number[] = [];
  for (const edge of edges) {
    const [a, b] = [ends[2 * edge], ends[2 * edge + 1]];
    const [from, to] = [sight.pixel(solid.points, a), sight.pixel(solid.points, b)];
    if (!from || !to) continue;
    const margin = Math.min(REACH / distance(from, to), 1 / 2);
    const share = Math.min(1 - margin, Math.max(margin, nearestShare(from, to, at)));
    if (distance(between(from, to, share), at) > BRUSH) continue;
    if (isInSight(solid, sight, pointOf(solid, a).lerp(pointOf(solid, b), share))) found.push(edge);
  }
  return found;
}
