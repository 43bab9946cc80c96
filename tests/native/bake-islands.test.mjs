// A texture in hundreds of islands in a layout of few charts; bake-islands.long.mjs has thousands.

import { testRebaking } from '../support/rebaked-islands.mjs';
import { isInstrumented } from '../support/run-abflat.mjs';

testRebaking({
  ball: { perSide: isInstrumented ? 5 : 10, quads: 4, texels: 34 },
  leastIslands: isInstrumented ? 150 : 600,
  mostCharts: 40,
  resolution: isInstrumented ? 512 : 1024,
});
