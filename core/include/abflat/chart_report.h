#pragma once

#include "abflat/flatten_options.h"
#include "abflat/generated/chart_report.h"
#include "abflat/newton_step.h"
