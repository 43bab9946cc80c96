// Entry of the Web Worker that packs and verifies layouts.

import { serveWeb } from './serve-web.js';
import { startPack } from './start-pack.js';

serveWeb(startPack);
