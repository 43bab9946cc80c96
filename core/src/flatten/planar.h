#pragma once

#include <optional>

#include "boundary/chart_flattener.h"

namespace abflat {

/// The layout of a flat chart: its projection onto its plane, which keeps all lengths, with parts
/// of its boundary that touch each other drawn back. None if the chart is not flat, or if the
/// projection covers something twice.
std::optional<Attempt> projectPlanar(const DiskChart& chart);

}  // namespace abflat
