#include <algorithm>

#include "abflat/verify.h"
#include "verify/findings.h"

namespace abflat {
namespace {

VerifyRule ruleOf(MeshDifferenceKind kind) {
  switch (kind) {
    case MeshDifferenceKind::Geometry:
      return VerifyRule::Geometry;
    case MeshDifferenceKind::Order:
      return VerifyRule::Order;
    case MeshDifferenceKind::Attribute:
      break;
  }
  return VerifyRule::Attributes;
}

}  // namespace

void addDifferences(const std::vector<MeshDifference>& differences, VerifyReport& report) {
  for (const MeshDifference& difference : differences) {
    VerifyFinding found;
    found.rule = ruleOf(difference.kind);
    found.message = difference.message;
    found.faces = difference.faces;
    found.faces.resize(std::min(found.faces.size(), kMostListed));
    report.findings.push_back(std::move(found));
    report.valid = false;
  }
}

}  // namespace abflat
