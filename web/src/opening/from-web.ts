import { Job } from '../session/job';
import { type Address, addressOf } from './address';
import type { Watch } from './fetch-file';
import { fetchMesh } from './fetch-mesh';

export interface FromWebEvents {
  /** A file is being fetched: how much of it is there, from 0 to 1, and what to say. */
  fetching(fraction: number, text: string): void;
  /** Nothing is fetched any more; `text` says how it ended. */
  fetched(text: string): void;
  files(files: File[]): void;
  refused(reason: string): void;
}

/** Shown at most this often, in milliseconds. */
const PAUSE = 100;

/** The sheet is not part of the first load. */
const loadSheet = () => import('./web-sheet');

/** Opens meshes from the web, each after asking. The latest one wins. */
export class FromWeb {
  private readonly job = new Job(() => undefined);
  private isAsking = false;

  constructor(private readonly events: FromWebEvents) {}

  /** Asks for a mesh from any server. */
  open(text: string): void {
    if (this.isAsking) return;
    let address: Address;
    try {
      address = addressOf(text, location.href);
    } catch (error) {
      this.events.refused((error as Error).message);
      return;
    }
    this.isAsking = true;
    this.agreed(address)
      .then((isAgreed) => isAgreed && this.fetch(address))
      .catch(({ message }: Error) => this.events.refused(message))
      .finally(() => {
        this.isAsking = false;
      });
  }

  /** Fetches without asking. */
  fetch(address: Address): void {
    let files: File[] = [];
    this.job
      .start(async (signal) => {
        this.events.fetching(0, `Fetching ${address.name} from ${address.host}`);
        files = await fetchMesh(address, this.watch(signal));
      })
      .then(() => {
        if (files.length === 0) return; // it was stopped
        this.events.fetched(`Fetched ${address.name}`);
        this.events.files(files);
      })
      .catch(({ message }: Error) => {
        this.events.fetched(`${address.name} was not opened`);
        this.events.refused(message);
      });
  }

  /** Returns whether there was anything to stop. */
  stop(): boolean {
    if (!this.job.isRunning) return false;
    this.job.stop();
    this.events.fetched('Cancelled');
    return true;
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
        this.events.fetching(fraction, progressText(name, received, total));
      },
      allow: async (name, bytes) => {
        const { ask, fetchLarge } = await loadSheet();
        if (!(await ask(fetchLarge(name, bytes)))) this.stop();
        signal.throwIfAborted();
      },
    };
  }
}

/** A compressed answer holds more than was announced. */
function progressText(name: string, received: number, total: number | null): string {
  const size = (bytes: number) => (bytes / 1e6).toFixed(1);
  const of = total !== null && total >= received ? ` of ${size(total)}` : '';
  return `Fetching ${name}: ${size(received)}${of}\u202fMB`;
}

/** The server of the page has been asked for the page itself, so asking it for a size tells it nothing new. */
async function ownSize(url: URL): Promise<number | null> {
  const answer = await fetch(url, { method: 'HEAD' }).catch(() => null);
  const length = answer?.ok ? answer.headers.get('Content-Length') : null;
  return length ? Number(length) : null;
}
