// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cmath>
#include <limits>
#include <string_view>

namespace abflat {

/// How boundary crossings are removed.
enum class Untangle : int {
  Auto = 0,  ///< best when t is auto, none when it is a number
  None = 1,  ///< keep crossings; the result is not valid
  Local = 2,  ///< tighten only the bounds of the arcs that cross
  Global = 3,  ///< tighten all bounds alike
  Best = 4,  ///< local or global, whichever distorts less
};

inline const char* nameOf(Untangle code) {
  switch (code) {
    case Untangle::Auto:
      return "auto";
    case Untangle::None:
      return "none";
    case Untangle::Local:
      return "local";
    case Untangle::Global:
      return "global";
    case Untangle::Best:
      return "best";
  }
  return "";
}

/// How the linear systems of Newton's method are solved.
enum class LinearSolver : int {
  Schur = 0,  ///< elimination to two rows per vertex, then sparse factorisation; for large meshes, conjugate gradients preconditioned by one
  Eigen = 1,  ///< the same elimination, factored by Eigen's SimplicialLDLT
  Minres = 2,  ///< MINRES on the whole symmetric system, as in the paper
  Symmlq = 3,  ///< SYMMLQ on the whole symmetric system, as in the paper
  Gmres = 4,  ///< GMRES, as in classic ABF
  Bicgstab = 5,  ///< BiCGSTAB, as in classic ABF
};

inline const char* nameOf(LinearSolver code) {
  switch (code) {
    case LinearSolver::Schur:
      return "schur";
    case LinearSolver::Eigen:
      return "eigen";
    case LinearSolver::Minres:
      return "minres";
    case LinearSolver::Symmlq:
      return "symmlq";
    case LinearSolver::Gmres:
      return "gmres";
    case LinearSolver::Bicgstab:
      return "bicgstab";
  }
  return "";
}

/// Form of the wheel condition.
enum class Formulation : int {
  Log = 0,  ///< as a sum of logarithms, eq. (6)
  Product = 1,  ///< as a product, eq. (3), as in classic ABF; not with schur or eigen
};

inline const char* nameOf(Formulation code) {
  switch (code) {
    case Formulation::Log:
      return "log";
    case Formulation::Product:
      return "product";
  }
  return "";
}

/// "auto" as a value of the option t.
constexpr double kAutoT = 0;
/// "auto" as a value of the option memory.
constexpr double kAutoMemory = 0;

/// The options of flattening that are plain values, with their defaults.
struct FlattenOptionValues {
  /// boundary control coefficient: every interior angle of the boundary is at most t*pi (1 = convex; 2 or more = free boundary, classic ABF; auto = free, or the bounds of least distortion if a free boundary would cross itself)
  double t = 0;
  /// trade-off between angles and lengths: 0 keeps the angles as flattening found them, 1 keeps areas and lengths as well as possible (least symmetric Dirichlet energy)
  double balance = 0;
  /// how boundary crossings are removed: auto = best when t is auto, none when it is a number; none = keep crossings; the result is not valid; local = tighten only the bounds of the arcs that cross; global = tighten all bounds alike; best = local or global, whichever distorts less
  Untangle untangle = Untangle::Auto;
  /// how the linear systems of Newton's method are solved: schur = elimination to two rows per vertex, then sparse factorisation; for large meshes, conjugate gradients preconditioned by one; eigen = the same elimination, factored by Eigen's SimplicialLDLT; minres = MINRES on the whole symmetric system, as in the paper; symmlq = SYMMLQ on the whole symmetric system, as in the paper; gmres = GMRES, as in classic ABF; bicgstab = BiCGSTAB, as in classic ABF
  LinearSolver linearSolver = LinearSolver::Schur;
  /// memory for the factor of the solver's matrix, in MB; if it does not fit, the solver uses single precision, or conjugate gradients with multigrid (auto = 3072 in WebAssembly, no limit natively)
  double memory = 0;
  /// condition (5): keep boundary angles below 2 pi even if the boundary is free, so that adjacent triangles do not overlap
  bool adjacent = false;
  /// condition (9): make every interior edge of the layout Delaunay, where the connectivity allows it
  bool delaunay = false;
  /// maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one
  int threads = 0;
  /// form of the wheel condition: log = as a sum of logarithms, eq. (6); product = as a product, eq. (3), as in classic ABF; not with schur or eigen
  Formulation formulation = Formulation::Log;
  /// precondition the iterative linear solvers (the paper does not)
  bool precondition = true;
};

/// An option for people: names, default and range as on the command line.
struct OptionInfo {
  const char* name;
  const char* flag;
  const char* defaultText;
  const char* range;
  const char* help;
  bool isSwitch;  ///< takes no value
  bool isChoice;  ///< takes one of the words of its range
};

/// The options of a set, in the order of the numbers that setOption takes.
struct OptionInfos {
  const OptionInfo* first;
  int count;

  const OptionInfo& operator[](int index) const { return first[index]; }
};

inline OptionInfos optionInfos(const FlattenOptionValues&) {
  static constexpr OptionInfo kInfos[] = {
    {"t", "--t", "auto", "above 0, or auto", "boundary control coefficient: every interior angle of the boundary is at most t*pi (1 = convex; 2 or more = free boundary, classic ABF; auto = free, or the bounds of least distortion if a free boundary would cross itself)", false, false},
    {"balance", "--balance", "0", "at least 0 and at most 1", "trade-off between angles and lengths: 0 keeps the angles as flattening found them, 1 keeps areas and lengths as well as possible (least symmetric Dirichlet energy)", false, false},
    {"untangle", "--untangle", "auto", "auto, none, local, global, best", "how boundary crossings are removed: auto = best when t is auto, none when it is a number; none = keep crossings; the result is not valid; local = tighten only the bounds of the arcs that cross; global = tighten all bounds alike; best = local or global, whichever distorts less", false, true},
    {"linearSolver", "--linear-solver", "schur", "schur, eigen, minres, symmlq, gmres, bicgstab", "how the linear systems of Newton's method are solved: schur = elimination to two rows per vertex, then sparse factorisation; for large meshes, conjugate gradients preconditioned by one; eigen = the same elimination, factored by Eigen's SimplicialLDLT; minres = MINRES on the whole symmetric system, as in the paper; symmlq = SYMMLQ on the whole symmetric system, as in the paper; gmres = GMRES, as in classic ABF; bicgstab = BiCGSTAB, as in classic ABF", false, true},
    {"memory", "--memory", "auto", "above 0, or auto", "memory for the factor of the solver's matrix, in MB; if it does not fit, the solver uses single precision, or conjugate gradients with multigrid (auto = 3072 in WebAssembly, no limit natively)", false, false},
    {"adjacent", "--adjacent", "false", "", "condition (5): keep boundary angles below 2 pi even if the boundary is free, so that adjacent triangles do not overlap", true, false},
    {"delaunay", "--delaunay", "false", "", "condition (9): make every interior edge of the layout Delaunay, where the connectivity allows it", true, false},
    {"threads", "--threads", "0", "at least 0 and at most 256, whole", "maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one", false, false},
    {"formulation", "--formulation", "log", "log, product", "form of the wheel condition: log = as a sum of logarithms, eq. (6); product = as a product, eq. (3), as in classic ABF; not with schur or eigen", false, true},
    {"precondition", "--no-precondition", "true", "", "do not precondition the iterative linear solvers (the paper does not)", true, false},
  };
  return {kInfos, 10};
}

/// Sets an option from a number: choices by their index, booleans as 0 or 1. False when out of range, with nothing set. Without `isWord`
/// the numbers that stand for words are refused.
inline bool setOption(FlattenOptionValues& options, int index, double value,
                      [[maybe_unused]] bool isWord = true) {
  switch (index) {
    case 0:
      if (!((value > 0 && value <= std::numeric_limits<double>::max()) || (isWord && value == 0))) return false;
      options.t = static_cast<double>(value);
      return true;
    case 1:
      if (!(value >= 0 && value <= 1)) return false;
      options.balance = static_cast<double>(value);
      return true;
    case 2:
      if (!(value >= 0 && value < 5 && value == std::trunc(value))) return false;
      options.untangle = static_cast<Untangle>(static_cast<int>(value));
      return true;
    case 3:
      if (!(value >= 0 && value < 6 && value == std::trunc(value))) return false;
      options.linearSolver = static_cast<LinearSolver>(static_cast<int>(value));
      return true;
    case 4:
      if (!((value > 0 && value <= std::numeric_limits<double>::max()) || (isWord && value == 0))) return false;
      options.memory = static_cast<double>(value);
      return true;
    case 5:
      if (!(value == 0 || value == 1)) return false;
      options.adjacent = value != 0;
      return true;
    case 6:
      if (!(value == 0 || value == 1)) return false;
      options.delaunay = value != 0;
      return true;
    case 7:
      if (!((value >= 0 && value <= 256) && value == std::trunc(value))) return false;
      options.threads = static_cast<int>(value);
      return true;
    case 8:
      if (!(value >= 0 && value < 2 && value == std::trunc(value))) return false;
      options.formulation = static_cast<Formulation>(static_cast<int>(value));
      return true;
    case 9:
      if (!(value == 0 || value == 1)) return false;
      options.precondition = value != 0;
      return true;
  }
  return false;
}

/// The number that stands for a word ("auto") or a choice of an option.
inline double wordValue(const FlattenOptionValues&, int index, std::string_view text, bool& found) {
  if (index == 0 && text == "auto") return found = true, 0;
  if (index == 2 && text == "auto") return found = true, 0;
  if (index == 2 && text == "none") return found = true, 1;
  if (index == 2 && text == "local") return found = true, 2;
  if (index == 2 && text == "global") return found = true, 3;
  if (index == 2 && text == "best") return found = true, 4;
  if (index == 3 && text == "schur") return found = true, 0;
  if (index == 3 && text == "eigen") return found = true, 1;
  if (index == 3 && text == "minres") return found = true, 2;
  if (index == 3 && text == "symmlq") return found = true, 3;
  if (index == 3 && text == "gmres") return found = true, 4;
  if (index == 3 && text == "bicgstab") return found = true, 5;
  if (index == 4 && text == "auto") return found = true, 0;
  if (index == 8 && text == "log") return found = true, 0;
  if (index == 8 && text == "product") return found = true, 1;
  return found = false, 0;
}

/// The size of a unit written behind a number ("3G") in the unit of the option; 0 when there is none of that name.
inline double unitSize(const FlattenOptionValues&, [[maybe_unused]] int index,
                       [[maybe_unused]] char letter) {
  if (index == 4 && letter == 'M') return 1;
  if (index == 4 && letter == 'G') return 1024;
  if (index == 4 && letter == 'T') return 1048576;
  return 0;
}

/// Calls visit(name, value) for every option; words and choices are passed as text.
template <class Visit>
void forEachOption(const FlattenOptionValues& options, Visit&& visit) {
  if (options.t == 0)
    visit("t", "auto");
  else
    visit("t", options.t);
  visit("balance", options.balance);
  visit("untangle", nameOf(options.untangle));
  visit("linearSolver", nameOf(options.linearSolver));
  if (options.memory == 0)
    visit("memory", "auto");
  else
    visit("memory", options.memory);
  visit("adjacent", options.adjacent);
  visit("delaunay", options.delaunay);
  visit("threads", options.threads);
  visit("formulation", nameOf(options.formulation));
  visit("precondition", options.precondition);
}

}  // namespace abflat
