// Entry of the Web Worker that bakes.

import { serveWeb } from './serve-web.js';
import { startBake } from './start-bake.js';

serveWeb(startBake);
