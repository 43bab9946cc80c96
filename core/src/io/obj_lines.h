#pragma once

#include <string_view>

namespace abflat {

/// One logical line of an OBJ text; a backslash at the end of a line joins it with the next.
struct ObjLine {
  enum class Kind { Vertex, Texcoord, Face, Other };
  Kind kind = Kind::Other;
  std::size_t number = 0;  ///< of its first physical line, counted from 1
  std::string_view text;   ///< with its line end
  std::string_view
      arguments;  ///< after the keyword, without comment and line end (may hold joined line ends)
};

/// Iterates the logical lines of an OBJ text.
class ObjLines {
 public:
  explicit ObjLines(std::string_view text) : rest_(text) {}
  bool next(ObjLine& line);

 private:
  std::string_view rest_;
  std::size_t number_ = 1;
};

/// Whether a logical line consists of several physical ones.
inline bool isJoined(const ObjLine& line) {
  return line.arguments.find('\n') != std::string_view::npos;
}

}  // namespace abflat
