#pragma once

namespace abflat {

/// A sum that carries twice the digits of a double (Knuth's two-sum), so that rounded to one it
/// hardly ever depends on the order of what is added.
class LongSum {
 public:
  void add(double x) {
    const double sum = high_ + x, virtualX = sum - high_;
    low_ += (high_ - (sum - virtualX)) + (x - virtualX);
    high_ = sum;
  }
  double value() const { return high_ + low_; }

 private:
  double high_ = 0, low_ = 0;
};

}  // namespace abflat
