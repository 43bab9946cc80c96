// Values that the browser keeps for the page, files included. All of them are written at once or not at all.

const DATABASE = 'abflat';
const STORE = 'visit';

const resultOf = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });

const putAll = (store: IDBObjectStore, values: Record<string, unknown>): void => {
  for (const [name, value] of Object.entries(values)) store.put(value, name);
};

export class Stored {
  /** Stays open from the first use on: when the page is left there is no time to open it. */
  private database: IDBDatabase | null = null;

  /** Undefined for what is not there. */
  read(names: string[]): Promise<unknown[]> {
    return this.inStore('readonly', (store) =>
      Promise.all(names.map((name) => resultOf(store.get(name)))),
    );
  }

  /** `large` is only written where it is not there yet, under this `id`: another page may have written its own. */
  async write(
    values: Record<string, unknown>,
    large: { id: string; values: Record<string, unknown> },
  ): Promise<void> {
    await this.inStore('readwrite', async (store) => {
      const isThere = (await resultOf(store.get('id'))) === large.id;
      putAll(store, isThere ? values : { ...values, ...large.values, id: large.id });
    });
  }

  /** For a page that is being left: nothing can be waited for any more. */
  writeAtOnce(values: Record<string, unknown>): void {
    const transaction = this.database?.transaction(STORE, 'readwrite');
    if (!transaction) return;
    putAll(transaction.objectStore(STORE), values);
    transaction.commit();
  }

  async forget(): Promise<void> {
    await this.inStore('readwrite', (store) => resultOf(store.clear()));
  }

  private async inStore<T>(
    mode: IDBTransactionMode,
    use: (store: IDBObjectStore) => Promise<T>,
  ): Promise<T> {
    this.database ??= await this.open();
    const transaction = this.database.transaction(STORE, mode);
    const done = new Promise<void>((resolve, reject) => {
      transaction.oncomplete = () => resolve();
      transaction.onabort = () => reject(transaction.error);
    });
    const using = use(transaction.objectStore(STORE)).catch((error: unknown) => {
      transaction.abort();
      throw error;
    });
    const [value] = await Promise.all([using, done]);
    return value;
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
