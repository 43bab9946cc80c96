// Small texts that are damaged at random, as by copying, cutting and bad exporters.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace abflat::test {

/// Splits a text into words, the blanks between them and line ends.
inline std::vector<std::string> piecesOf(const std::string& text) {
  std::vector<std::string> out;
  const auto kindOf = [](char c) {
    return c == '\n' || c == '\r' ? 0 : c == ' ' || c == '\t' ? 1 : 2;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isNew =
        out.empty() || kindOf(text[i]) == 0 || kindOf(text[i]) != kindOf(text[i - 1]);
    if (isNew) out.emplace_back();
    out.back() += text[i];
  }
  return out;
}

class Mutator {
 public:
  /// `words` are substituted for other words.
  Mutator(unsigned seed, std::vector<std::string> words)
      : random_(seed), words_(std::move(words)) {}

  std::string operator()(const std::string& text) {
    std::vector<std::string> pieces = piecesOf(text);
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes && !pieces.empty(); ++i) change(pieces);
    std::string out;
    for (const std::string& piece : pieces) out += piece;
    return out;
  }

  std::size_t below(std::size_t n) { return random_() % n; }

 private:
  void change(std::vector<std::string>& pieces) {
    const std::size_t at = below(pieces.size()), other = below(pieces.size());
    std::string& piece = pieces[at];
    switch (below(8)) {
      case 0:
        std::swap(piece, pieces[other]);
        break;
      case 1:
        piece = words_[below(words_.size())];
        break;
      case 2:
        piece.resize(below(piece.size() + 1));
        break;
      case 3:
        piece += piece;
        break;
      case 4:
        piece.insert(below(piece.size() + 1), words_[below(words_.size())]);
        break;
      case 5:
        pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(at), pieces[other]);
        break;
      case 6:
        pieces.resize(at);
        break;
      default:
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(at));
    }
  }

  std::mt19937 random_;
  std::vector<std::string> words_;
};

}  // namespace abflat::test
