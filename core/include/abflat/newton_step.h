#pragma once

#include "abflat/generated/newton_step.h"
