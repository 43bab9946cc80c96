// More generated disks than a usual run has time for.

import { testGeneratedDisks } from '../support/flattened-disks.mjs';

testGeneratedDisks(60, 300);
