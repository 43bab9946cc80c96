// Values that the browser keeps for the page, files included. All of them are written at once or not at all.

const DATABASE = 'abflat';
const STORE = 'visit';

const resultOf = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });

async function inStore<T>(
  mode: IDBTransactionMode,
  use: (store: IDBObjectStore) => Promise<T>,
): Promise<T> {
  const request = indexedDB.open(DATABASE, 1);
  request.onupgradeneeded = () => request.result.createObjectStore(STORE);
  const database = await resultOf(request);
  try {
    const transaction = database.transaction(STORE, mode);
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
  } finally {
    database.close();
  }
}

/** Undefined for what is not there. */
export const readStored = (names: string[]): Promise<unknown[]> =>
  inStore('readonly', (store) => Promise.all(names.map((name) => resultOf(store.get(name)))));

/** `large` is only written where it is not there yet, under this `id`: another page may have written its own. */
export const writeStored = (
  values: Record<string, unknown>,
  large: { id: string; values: Record<string, unknown> },
): Promise<unknown> =>
  inStore('readwrite', async (store) => {
    const isThere = (await resultOf(store.get('id'))) === large.id;
    const all = isThere ? values : { ...values, ...large.values, id: large.id };
    for (const [name, value] of Object.entries(all)) store.put(value, name);
  });

export const forgetStored = (): Promise<unknown> =>
  inStore('readwrite', (store) => resultOf(store.clear()));
