// Several atlases of equal size for one scene, at one texel density.

import { AbflatError } from './base/errors.js';
import { ownFields } from './messages/fields.js';
import { shown } from './messages/validate.js';
import type { UnwrapOptions, UnwrapProgress, UnwrapResult } from './types/index.js';

const MOST_PAGES = 1024;

const invalid = (message: string) => new AbflatError('InvalidOption', message);

/** What is about places in one atlas. */
const OF_ONE_ATLAS = ['udim', 'fixedFaces', 'fixedCharts', 'keepsPlaces', 'known', 'pins'] as const;

/** `pages`: from the caller. */
export function checkPages(pages: unknown, options: UnwrapOptions): void {
  if (pages === undefined) return;
  if (!Number.isInteger(pages) || (pages as number) < 1 || (pages as number) > MOST_PAGES)
    throw invalid(`pages must be a whole number from 1 to ${MOST_PAGES}, not ${shown(pages)}.`);
  const own = ownFields(options);
  const other = OF_ONE_ATLAS.find((name) => own[name] !== undefined && own[name] !== false);
  if (other) throw invalid(`pages does not go with ${other}, which is about places in one atlas.`);
}

/** Something that lies on one page as a whole. `size`: its share of the room on pages, roughly. */
export interface Sized<T> {
  thing: T;
  size: number;
}

/** How a page is laid out now. */
export type PageOptions = Pick<
  UnwrapOptions,
  'texelDensity' | 'seams' | 'seamEdges' | 'known' | 'onProgress'
>;

type Lay<T> = (things: T[], options: PageOptions) => UnwrapResult | Promise<UnwrapResult>;

interface LaidPage<T> {
  things: Sized<T>[];
  result: UnwrapResult;
}

/**
 * Deals things to pages and lays these out at one texel density: the one that is given, or as much
 * as there is room for. None is empty: there are fewer if there are not enough things with a size.
 * Resolves to the last layout of each page.
 */
export async function layPages<T>(
  things: readonly Sized<T>[],
  pages: number,
  { texelDensity = 'auto', onProgress }: Pick<UnwrapOptions, 'texelDensity' | 'onProgress'>,
  lay: Lay<T>,
): Promise<UnwrapResult[]> {
  const dealt = deal(things, pages);
  const isFixed = texelDensity !== 'auto' || dealt.length === 1;
  // Of the progress: where laying out ends, and where moving does.
  const [laid, moved] = isFixed ? [1, 1] : [0.5, 0.75];
  const layTold =
    (from: number, to: number) =>
    async (page: readonly Sized<T>[], options: PageOptions = {}): Promise<LaidPage<T>> => {
      const tell = (progress: UnwrapProgress) =>
        onProgress?.({ ...progress, fraction: from + (to - from) * progress.fraction });
      const own = page.map(({ thing }) => thing);
      const result = await lay(own, { ...options, ...(onProgress && { onProgress: tell }) });
      return { things: [...page], result };
    };
  const part = (i: number, count: number, from: number, to: number) =>
    layTold(from + ((to - from) * i) / count, from + ((to - from) * (i + 1)) / count);
  const found: LaidPage<T>[] = [];
  for (const [i, page] of dealt.entries()) found.push(await part(i, dealt.length, 0, laid)(page));
  if (!isFixed) {
    await fillAlike(found, (i) => part(i, 2 * MOST_MOVES, laid, moved));
    await atOneDensity(found, (i) => part(i, found.length, moved, 1));
  }
  return found.map(({ result }) => result);
}

/** The largest first, each to the page with the least. On a page they keep their order. */
function deal<T>(things: readonly Sized<T>[], pages: number): Sized<T>[][] {
  const count = Math.max(1, Math.min(pages, things.filter(({ size }) => size > 0).length));
  const filled = Array.from({ length: count }, () => 0);
  const pageOf = new Map<Sized<T>, number>();
  for (const each of [...things].sort((a, b) => b.size - a.size)) {
    const page = filled.indexOf(Math.min(...filled));
    filled[page] = (filled[page] ?? 0) + each.size;
    pageOf.set(each, page);
  }
  return filled.map((_, page) => things.filter((each) => pageOf.get(each) === page));
}

type LayAgain<T> = (page: readonly Sized<T>[], options?: PageOptions) => Promise<LaidPage<T>>;

const densityOf = ({ result }: LaidPage<unknown>) => result.report.atlas.texelDensity;

/** How much room a page needs at a texel density of 1. */
const needOf = (page: LaidPage<unknown>) => densityOf(page) ** -2;

const MOST_MOVES = 4;

/** Moves things from the page that needs the most room, as long as that helps. */
async function fillAlike<T>(pages: LaidPage<T>[], layFor: (i: number) => LayAgain<T>) {
  for (let move = 0; move < MOST_MOVES; ++move) {
    const byNeed = [...pages].sort((a, b) => needOf(b) - needOf(a));
    const [from, to] = [byNeed[0], byNeed.at(-1)] as [LaidPage<T>, LaidPage<T>];
    const moving = worthMoving(from, to);
    if (!moving) return;
    const less = await layFor(2 * move)(from.things.filter((each) => each !== moving));
    const more = await layFor(2 * move + 1)([...to.things, moving]);
    if (Math.max(needOf(less), needOf(more)) >= needOf(from)) return;
    pages[pages.indexOf(from)] = less;
    pages[pages.indexOf(to)] = more;
  }
}

/** The one that makes two pages most alike, if that promises to gain texels. */
function worthMoving<T>(from: LaidPage<T>, to: LaidPage<T>): Sized<T> | undefined {
  const LEAST_GAIN = 0.97;
  const perSize = (page: LaidPage<T>) =>
    needOf(page) / page.things.reduce((sum, { size }) => sum + size, 0);
  const most = ({ size }: Sized<T>) =>
    Math.max(needOf(from) - size * perSize(from), needOf(to) + size * perSize(to));
  const sized = from.things.filter(({ size }) => size > 0);
  if (sized.length < 2) return undefined;
  const best = sized.reduce((a, b) => (most(b) < most(a) ? b : a));
  return most(best) < LEAST_GAIN * needOf(from) ? best : undefined;
}

/**
 * Lays out pages whose charts are larger again, with the seams that they have, at the texel density
 * of the page with the smallest.
 */
async function atOneDensity<T>(pages: LaidPage<T>[], layFor: (i: number) => LayAgain<T>) {
  // What fits at a density nearly always fits at a lower one.
  const LESS = 0.99;
  const again = async (texelDensity: number) => {
    const out: LaidPage<T>[] = [];
    for (const [i, page] of pages.entries()) {
      const { seams, ...known } = page.result;
      const options: PageOptions = { texelDensity, seams: 'none', seamEdges: seams, known };
      const isDone = densityOf(page) === texelDensity;
      out.push(isDone ? page : await layFor(i)(page.things, options));
    }
    return out;
  };
  for (let density = Math.min(...pages.map(densityOf)); ; density *= LESS) {
    try {
      pages.splice(0, pages.length, ...(await again(density)));
      return;
    } catch (error) {
      if ((error as AbflatError).code !== 'AtlasTooSmall') throw error;
    }
  }
}

/** A note if there are fewer pages than were asked for. */
export function pagesNote(pages: number, count: number, what: string): string[] {
  if (count >= pages) return [];
  return [
    `${count} of ${pages} pages ${count === 1 ? 'is' : 'are'} used, since no more ${what} have a surface`,
  ];
}
