// Runs in a page: compares two GLB files, given in base64.

import { bytesOf, compared } from '../../support/glb-renders.mjs';

window.compare = (before, after) => compared(bytesOf(before), bytesOf(after));
