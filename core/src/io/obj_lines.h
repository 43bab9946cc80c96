#pragma once

#include <string>
#include <string_view>

namespace abflat {

/// One logical line of an OBJ text. A backslash at the end of a line joins it with the next one,
/// unless that one begins a record of its own. Only lines of the kinds named here are joined: all
/// others are skipped or copied along with whatever follows them, and the names they hold may be
/// paths that end in a backslash.
struct ObjLine {
  enum class Kind { Vertex, Texcoord, Face, Polyline, Other };
  Kind kind = Kind::Other;
  std::size_t number = 0;      ///< of its first physical line, counted from 1
  std::string_view text;       ///< with its line end
  std::string_view arguments;  ///< between keyword and comment (may hold joined line ends)
  std::string_view comment;    ///< with its #, without the line end; empty if there is none
  bool isJoined = false;       ///< consists of several physical lines
};

/// Iterates the logical lines of an OBJ text.
class ObjLines {
 public:
  explicit ObjLines(std::string_view text) : rest_(text) {}
  bool next(ObjLine& line);

  /// The text not iterated yet; begins at a logical line.
  std::string_view rest() const { return rest_; }
  /// Number of the line that `rest` begins with, counted from 1.
  std::size_t number() const { return number_; }
  /// Drops the first `size` bytes of `rest`, which must be one physical line that is not joined
  /// with the next.
  void skipLine(std::size_t size) {
    rest_.remove_prefix(size);
    ++number_;
  }

 private:
  std::string_view rest_;
  std::size_t number_ = 1;
};

/// The arguments with the joints between physical lines blanked out; kept in `storage` if there are
/// any.
std::string_view argumentsOf(const ObjLine& line, std::string& storage);

}  // namespace abflat
