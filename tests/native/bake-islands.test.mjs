// A texture in hundreds of islands in a layout of few charts; bake-islands.long.mjs has thousands.

import { testRebaking } from '../support/rebaked-islands.mjs';

testRebaking({
  ball: { perSide: 10, quads: 4, texels: 34 },
  leastIslands: 600,
  mostCharts: 40,
  resolution: 1024,
});
