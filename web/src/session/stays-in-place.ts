import type { Flattened, Unwrapped } from '../model/model';

/** Whether it is an earlier atlas with charts that were left where they are, or moved. */
export const staysInPlace = ({ mode, result }: Flattened | Unwrapped) =>
  mode === 'unwrap' &&
  result.report.charts.some(({ solver, fixed }) => fixed && solver === 'known');
