import { Vector3 } from 'three';
import type { Solid } from '../surface/solid';
import { edgeBetween, type SurfaceGraph } from '../surface/surface-graph';
import type { Pixel, Sight } from '../view/sight';

/** The farthest a target may be from the pointer, in css pixels. */
export const REACH = 12;
/** How many candidates are tested for visibility; further ones would be hidden too. */
const MOST_TRIES = 6;
/** How far a point may lie behind the surface that it is on, as a share of the distance. */
const SLACK = 2e-3;

interface Candidate {
  index: number;
  pixels: number;
  point: Vector3;
}

/**
 * The vertex under a pixel: one of `wanted` that is in reach and visible, otherwise the nearest
 * corner of the triangle there; -1 if there is none.
 */
export function vertexAt(solid: Solid, sight: Sight, at: Pixel, wanted: Iterable<number>): number {
  const near: Candidate[] = [];
  for (const v of wanted) {
    const pixel = sight.pixel(solid.points, v);
    const pixels = pixel ? distance(pixel, at) : Infinity;
    if (pixels <= REACH) near.push({ index: v, pixels, point: pointOf(solid, v) });
  }
  const snapped = nearestInSight(solid, sight, near);
  if (snapped >= 0) return snapped;
  const hit = solid.firstHit(sight.ray(at));
  if (!hit) return -1;
  const corners = solid.indices.subarray(3 * hit.triangle, 3 * hit.triangle + 3);
  const pixels = (v: number) => {
    const pixel = sight.pixel(solid.points, v); // none behind the eye
    return pixel ? distance(pixel, at) : Infinity;
  };
  return corners.reduce((best, v) => (pixels(v) < pixels(best) ? v : best));
}

/**
 * The edge of `edges` (two vertices each in `ends`) that is nearest to a pixel, in reach and
 * visible; -1 if there is none.
 */
export function edgeAt(
  solid: Solid,
  sight: Sight,
  at: Pixel,
  ends: Uint32Array,
  edges: Iterable<number>,
): number {
  const near: Candidate[] = [];
  for (const index of edges) {
    const [a, b] = [ends[2 * index], ends[2 * index + 1]];
    const [from, to] = [sight.pixel(solid.points, a), sight.pixel(solid.points, b)];
    if (!from || !to) continue;
    const share = nearestShare(from, to, at);
    const pixels = distance(between(from, to, share), at);
    if (pixels > REACH) continue;
    near.push({ index, pixels, point: pointOf(solid, a).lerp(pointOf(solid, b), share) });
  }
  return nearestInSight(solid, sight, near);
}

/** The edge near a pixel that is not near either of its ends; -1 if there is none. */
export function edgeAwayFromEnds(
  solid: Solid,
  graph: SurfaceGraph,
  sight: Sight,
  at: Pixel,
): number {
  const hit = solid.firstHit(sight.ray(at));
  if (!hit) return -1;
  const corners = solid.indices.subarray(3 * hit.triangle, 3 * hit.triangle + 3);
  let [nearest, least] = [-1, REACH];
  corners.forEach((a, i) => {
    const b = corners[(i + 1) % 3];
    const [from, to] = [sight.pixel(solid.points, a), sight.pixel(solid.points, b)];
    const edge = edgeBetween(graph, a, b);
    if (!from || !to || edge < 0) return;
    const share = nearestShare(from, to, at);
    const pixels = distance(between(from, to, share), at);
    const length = distance(from, to);
    const isNearEnd = length * Math.min(share, 1 - share) < Math.min(REACH, length / 4);
    if (pixels > least) return;
    least = pixels;
    nearest = isNearEnd ? -1 : edge;
  });
  return nearest;
}

function nearestInSight(solid: Solid, sight: Sight, candidates: Candidate[]): number {
  candidates.sort((a, b) => a.pixels - b.pixels || a.index - b.index);
  const found = candidates.slice(0, MOST_TRIES).find(({ point }) => isInSight(solid, sight, point));
  return found ? found.index : -1;
}

export function isInSight(solid: Solid, sight: Sight, point: Vector3): boolean {
  const pixel = sight.pixel(point.toArray(), 0);
  if (!pixel) return false;
  const ray = sight.ray(pixel);
  const hit = solid.firstHit(ray);
  return !hit || hit.distance >= (1 - SLACK) * point.distanceTo(ray.origin);
}

export function pointOf({ points }: Solid, v: number): Vector3 {
  return new Vector3().fromArray(points, 3 * v);
}

export function distance(a: Pixel, b: Pixel): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

export const between = (from: Pixel, to: Pixel, share: number): Pixel => ({
  x: from.x + share * (to.x - from.x),
  y: from.y + share * (to.y - from.y),
});

/** How far along the line between two pixels it comes nearest to a third, 0 to 1. */
export function nearestShare(from: Pixel, to: Pixel, at: Pixel): number {
  const [x, y] = [to.x - from.x, to.y - from.y];
  const along = (at.x - from.x) * x + (at.y - from.y) * y;
  const square = x * x + y * y;
  return square > 0 ? Math.min(1, Math.max(0, along / square)) : 0;
}
