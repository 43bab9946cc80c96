import { loadPart, reasonOf } from '../base/load-part';
import { FETCHING } from '../words/web';
import { type Address, addressOf } from './address';
import type { Watch } from './fetch-file';
import type { Gathering } from './gathering';

/** Shown at most this often, in milliseconds. */
const PAUSE = 100;

const loadSheet = () => loadPart(import('./web-sheet'));
const loadFetch = () => loadPart(import('./fetch-mesh'));

/** Opens meshes from the web, each after asking. */
export class FromWeb {
  private isAsking = false;

  constructor(
    private readonly gathering: Gathering,
    private readonly refused: (reason: string) => void,
  ) {}

  /** Asks for a mesh from any server. */
  open(text: string): void {
    if (this.isAsking) return;
    let address: Address;
    try {
      address = addressOf(text, location.href);
    } catch (error) {
      this.refused((error as Error).message);
      return;
    }
    this.isAsking = true;
    this.agreed(address)
      .then((isAgreed) => isAgreed && this.fetch(address))
      .catch((error: Error) => this.refused(reasonOf(error)))
      .finally(() => {
        this.isAsking = false;
      });
  }

  /** Fetches without asking. */
  fetch(address: Address): void {
    const { name, host } = address;
    this.gathering.start({
      name,
      doing: FETCHING.started(name, host),
      task: async (signal) => (await loadFetch()).fetchMesh(address, this.watch(signal)),
    });
  }

  private async agreed(address: Address): Promise<boolean> {
    const { ask, openFrom } = await loadSheet();
    return ask(openFrom(address, address.isOwn ? await ownSize(address.url) : null));
  }

  private watch(signal: AbortSignal): Watch {
    let last = 0;
    return {
      signal,
      progress: (name, received, total) => {
        const now = performance.now();
        if (now - last < PAUSE || signal.aborted) return;
        last = now;
        const fraction = total ? Math.min(1, received / total) : 0;
        this.gathering.progress(fraction, progressText(name, received, total));
      },
      allow: async (name, bytes) => {
        const { ask, fetchLarge } = await loadSheet();
        if (!(await ask(fetchLarge(name, bytes)))) this.gathering.stop();
        signal.throwIfAborted();
      },
    };
  }
}

/** A compressed answer holds more than was announced. */
function progressText(name: string, received: number, total: number | null): string {
  const known = total !== null && total >= received ? total : null;
  return FETCHING.progress(name, received, known);
}

/** The server of the page has been asked for the page itself, so asking it for a size tells it nothing new. */
async function ownSize(url: URL): Promise<number | null> {
  const answer = await fetch(url, { method: 'HEAD' }).catch(() => null);
  const length = answer?.ok ? answer.headers.get('Content-Length') : null;
  return length ? Number(length) : null;
}
