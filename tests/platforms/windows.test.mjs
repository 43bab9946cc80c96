// The core on Windows, run by wine.

import { testPlatform } from './support/platform.mjs';

testPlatform('windows');
