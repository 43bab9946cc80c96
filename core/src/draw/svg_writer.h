#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace abflat {

/// A number with at most two decimals, without locale and without needless characters.
std::string svgNumber(double value);

/// Text in a form that XML may hold: markup is escaped, and anything that is not UTF-8 or not
/// allowed in XML is replaced by U+FFFD.
std::string xmlText(std::string_view text);

struct SvgAttribute {
  std::string_view name;
  std::string value;

  SvgAttribute(std::string_view n, std::string_view v) : name(n), value(v) {}
  SvgAttribute(std::string_view n, double v) : name(n), value(svgNumber(v)) {}
};
using SvgAttributes = std::initializer_list<SvgAttribute>;

/// Builds well-formed SVG elements one after another.
class SvgWriter {
 public:
  void open(std::string_view element, SvgAttributes attributes);
  void close(std::string_view element);
  void add(std::string_view element, SvgAttributes attributes);
  void text(double x, double y, std::string_view content, SvgAttributes attributes);
  void raw(std::string_view svg) { out_ += svg; }
  std::string take() { return std::move(out_); }

 private:
  void start(std::string_view element, SvgAttributes attributes);

  std::string out_;
};

/// Path data of whole numbers in relative moves, which is what makes large drawings small. Rounding
/// errors do not add up.
class SvgPath {
 public:
  void moveTo(double x, double y);
  void lineTo(double x, double y);
  /// A move at the start of a line, otherwise the next point of it.
  void add(bool isStart, double x, double y) { isStart ? moveTo(x, y) : lineTo(x, y); }
  void close();
  bool isEmpty() const { return data_.empty(); }
  const std::string& data() const { return data_; }

 private:
  void go(char command, double x, double y);

  std::string data_;
  long long x_ = 0, y_ = 0, startX_ = 0, startY_ = 0;
  char last_ = 0;
};

}  // namespace abflat
