import { sentence } from '../words/format';
import { Lost, NOT_LOADED, notLoaded } from './lost';

/** A part of the page that is not part of its first load. */
export const loadPart = <T>(part: Promise<T>): Promise<T> =>
  part.catch(({ message }: Error) => {
    throw notLoaded(message);
  });

/** The same in a worker. */
export const loadInWorker = <T>(part: Promise<T>): Promise<T> =>
  part.catch(({ message }: Error) => {
    throw Object.assign(new Error(message), { name: NOT_LOADED });
  });

/** As a sentence of its own. Other messages may begin with the name of a file. */
export const reasonOf = (error: Error): string =>
  error instanceof Lost ? sentence(error.message) : error.message;
