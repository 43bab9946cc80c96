// As bake-islands.test.mjs, at the size of a scan: 300,000 faces in 10,000 islands.

import { testRebaking } from '../support/rebaked-islands.mjs';

testRebaking({
  ball: { perSide: 41, quads: 4, texels: 40 },
  leastIslands: 10_000,
  mostCharts: 100,
  resolution: 4096,
});
