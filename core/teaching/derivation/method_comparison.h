#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/teaching/derivation/hand_calculation.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

// Both methods compared on one mechanism: which steps correspond to each other, the sizes of their equations,
// and the operations by hand. Everything is counted on this mechanism.

/// How a step of one method corresponds to one of the other.
enum class StepRelation {
  same,        ///< both do the same
  equivalent,  ///< one follows from the other: two forms of one statement
  onlyMatroid,
  onlyTtGraph,
};

/// A step of both methods, in words with formulas between dollar signs; empty where a method has none.
struct ComparedStep {
  std::string name;
  std::string matroid;
  std::string ttGraph;
  std::string relationWords;  ///< what they have in common, or what the other method lacks
  StepRelation relation = StepRelation::same;
};
/// The steps, with the numbers of the paper's equations.
[[nodiscard]] std::vector<ComparedStep> comparedSteps();

/// "1 product", "12 products", translated.
[[nodiscard]] std::string productsText(const Operations& operations);
/// "1 sum", "12 sums", translated.
[[nodiscard]] std::string sumsText(const Operations& operations);

/// One mesh by both methods: a term for each joint of its cycle.
struct ComparedMesh {
  struct Term {
    JointOrdinal joint = 0;
    Rational matroid;  ///< the entry of P, divided by the radius of the head's gear
    /// The joint's coefficient in w_ik - s n w_jk with both circuits substituted, times N_tail / N_head and
    /// the row's sign.
    Rational ttGraph;
  };
  MeshOrdinal mesh = 0;
  ByJoint<Term> terms;
  bool isEqual = false;  ///< all terms, exactly
  int sign = 0;          ///< of the terminal equation
};

/// The size of a method's equations and its operation counts.
struct MethodSize {
  int unknowns = 0;
  int equations = 0;
  int rows = 0;  ///< of its matrix
  int columns = 0;
  long long nonZeros = 0;
  /// From the drawing to the equations. T-T: only the ratio of teeth of each mesh; signs are read from the
  /// drawing.
  Operations setUp;
  Operations numbers;                 ///< from the equations to the solution matrix
  std::optional<Operations> symbols;  ///< the same in gear ratios; none if entries grow too long, or
                                      ///< were not asked for
};

struct MethodComparison {
  int links = 0;  ///< moving
  int meshes = 0;
  std::vector<ComparedMesh> perMesh;
  MethodSize matroid;
  MethodSize ttGraph;
  bool isEqual = false;  ///< both hand calculations came to the same matrix
};

/// With more links the hand calculations are not carried out.
constexpr int kMaxComparedLinks = 60;

/// Which hand calculations are carried out: in fractions only, or also in symbols.
enum class ComparisonDepth { numbers, symbols };
/// Compares the methods on a mechanism. std::nullopt if it has more than kMaxComparedLinks links, a method
/// has no solution for it, or `stop` was requested.
/// Cost: O(n^3) operations on fractions and on functions of the ratios.
/// The first step of the analysis suffices (analyzeLive()).
[[nodiscard]] std::optional<MethodComparison> compareMethods(const AnalysisSnapshot& snapshot,
                                                             ComparisonDepth depth = ComparisonDepth::symbols,
                                                             const std::stop_token& stop = {});

/// A claim of the paper's conclusion, with the evidence of this comparison for and against it; with formulas
/// between dollar signs.
struct ComparedClaim {
  std::string claim;
  std::vector<std::string> evidenceFor;
  std::vector<std::string> evidenceAgainst;
};
[[nodiscard]] std::vector<ComparedClaim> claimsOf(const MethodComparison& comparison);

}  // namespace geargraph
