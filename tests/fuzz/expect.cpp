#include "expect.h"

#include <cstdio>
#include <cstdlib>

namespace abflat::fuzz {

void expect(bool holds, const std::string& property) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", property.c_str());
  std::abort();
}

void expectReason(const Status& status, const std::set<StatusCode>& reasons) {
  expect(!status.message.empty(), "a refusal has a reason");
  expect(reasons.count(status.code) == 1, "not a reason to refuse: " + status.message);
}

}  // namespace abflat::fuzz
