// Entry of the Web Worker for the build `plain`.

import { plain } from './glue-plain.js';
import { serveWeb } from './serve-web.js';
import { starts } from './starts.js';

serveWeb(starts({ plain }));
