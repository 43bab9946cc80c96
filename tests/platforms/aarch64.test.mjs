// The core on ARM, run by qemu.

import { testPlatform } from './support/platform.mjs';

testPlatform('aarch64');
