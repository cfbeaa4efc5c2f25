#include "core/mechanism/graph/integer_matrix.h"

#include <array>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

struct KindEntry {
  MatrixKind kind;
  std::string_view command;
  std::string_view json;
  std::string_view symbol;
  std::string_view title;
  PaperEquation equation;
};

constexpr std::array kKinds = {
    KindEntry{MatrixKind::incidence, "incidence", "incidence", "Γ⁰", toTranslate("Incidence matrix"),
              PaperEquation::incidenceMatrix},
    KindEntry{MatrixKind::reducedIncidence, "reduced-incidence", "reducedIncidence", "Γ = [G | G*]",
              toTranslate("Reduced incidence matrix"), PaperEquation::reducedIncidenceMatrix},
    KindEntry{MatrixKind::path, "path", "path", "Z", toTranslate("Path matrix"), PaperEquation::pathMatrix},
    KindEntry{MatrixKind::spanningTree, "spanning-tree", "spanningTree", "T",
              toTranslate("Spanning-tree matrix"), PaperEquation::spanningTreeMatrix},
    KindEntry{MatrixKind::cycleBasis, "cycle-basis", "cycleBasis", "C = [T | U]",
              toTranslate("Cycle-basis matrix"), PaperEquation::cycleBasisMatrix},
    KindEntry{MatrixKind::cutset, "cutset", "cutset", "Q = [U | −Tᵀ]",
              toTranslate("Fundamental cutset matrix"), PaperEquation::none},
};

const KindEntry& entryOf(MatrixKind kind) {
  const KindEntry& entry = kKinds.at(static_cast<std::size_t>(kind));
  GEARGRAPH_REQUIRE(entry.kind == kind);
  return entry;
}

}  // namespace

const std::vector<MatrixKind>& allMatrixKinds() {
  static const std::vector<MatrixKind> kinds = [] {
    std::vector<MatrixKind> all;
    for (const KindEntry& entry : kKinds) all.push_back(entry.kind);
    return all;
  }();
  return kinds;
}

std::string_view matrixCommandName(MatrixKind kind) {
  return entryOf(kind).command;
}
std::string_view matrixJsonName(MatrixKind kind) {
  return entryOf(kind).json;
}
std::string_view matrixSymbol(MatrixKind kind) {
  return entryOf(kind).symbol;
}
std::string_view matrixTitle(MatrixKind kind) {
  return entryOf(kind).title;
}
PaperEquation matrixEquation(MatrixKind kind) {
  return entryOf(kind).equation;
}

}  // namespace geargraph
