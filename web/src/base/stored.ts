// Values that the browser keeps for the page, files included. All of them are written at once or not at all.

const DATABASE = 'abflat';
const STORE = 'visit';

const resultOf = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });

export class Stored {
  /** Stays open from the first use on: when the page is left there is no time to open it. */
  private database: IDBDatabase | null = null;

  /** Undefined for what is not there. */
  async read(names: string[]): Promise<unknown[]> {
    const values: unknown[] = [];
    await this.inStore('readonly', (store) => {
      names.forEach((name, i) => {
        store.get(name).onsuccess = ({ target }) => {
          values[i] = (target as IDBRequest).result;
        };
      });
    });
    return values;
  }

  /** From the second use on, all that has to be done is done when this returns. */
  write(values: Record<string, unknown>): Promise<void> {
    return this.inStore('readwrite', (store) => {
      for (const [name, value] of Object.entries(values)) store.put(value, name);
    });
  }

  forget(): Promise<void> {
    return this.inStore('readwrite', (store) => store.clear());
  }

  private async inStore(
    mode: IDBTransactionMode,
    use: (store: IDBObjectStore) => void,
  ): Promise<void> {
    this.database ??= await this.open();
    const transaction = this.database.transaction(STORE, mode);
    const done = new Promise<void>((resolve, reject) => {
      transaction.oncomplete = () => resolve();
      transaction.onabort = () => reject(transaction.error);
    });
    use(transaction.objectStore(STORE));
    // A page that is left takes back what it has not committed, and all that waits behind that.
    transaction.commit();
    await done;
  }

  private async open(): Promise<IDBDatabase> {
    const request = indexedDB.open(DATABASE, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE);
    const database = await resultOf(request);
    // The data of the page was deleted, or is about to be: the next use opens it anew.
    const lose = (): void => {
      if (this.database === database) this.database = null;
    };
    database.onclose = lose;
    database.onversionchange = () => {
      database.close();
      lose();
    };
    return database;
  }
}
