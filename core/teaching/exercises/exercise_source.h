#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// With more moving links, exercises cannot be answered on paper.
constexpr int kMaxExerciseLinks = 60;

/// A typical mistake in a row of P: with the teeth exchanged, or with the wrong sign of the head.
enum class RowChange { none, upsideDown, signOfHead };

/// Couplings engaged together, and the resulting motion for the drive and driven link of a state.
struct EngagedSet {
  std::vector<int> couplings;  ///< by position, ascending
  StateSolution solution;
};

/// A mechanism with the results from which its exercises are generated, for the train with every coupling
/// released. An immutable value.
class ExerciseSource {
 public:
  /// Cost: a live analysis, an exact solution; with states the solutions of all sets of couplings that are
  /// considered (kMaxEngagedSets). @pre at most kMaxExerciseLinks moving links
  explicit ExerciseSource(const Mechanism& mechanism);

  [[nodiscard]] const Mechanism& mechanism() const { return *m_snapshot->mechanism; }
  [[nodiscard]] const SnapshotPtr& snapshot() const { return m_snapshot; }
  [[nodiscard]] const Digraph& graph() const { return *m_snapshot->graph; }
  [[nodiscard]] const IntegerMatrixPtr& matrix(MatrixKind kind) const { return m_snapshot->matrix(kind); }
  /// Null if the turning joints are no spanning tree.
  [[nodiscard]] const SpanningTree* tree() const { return m_snapshot->tree.get(); }
  /// Null if a mesh has no equations.
  [[nodiscard]] const TtGraph* ttGraph() const;
  /// Null if a mesh has no geometry.
  [[nodiscard]] const MatroidAnalysis* matroid() const {
    return hasSlides(*m_snapshot->mechanism) ? nullptr : m_snapshot->matroid();
  }
  [[nodiscard]] MeshKind meshKind(MeshOrdinal mesh) const;

  /// A valid set of inputs, and by joint its rate as a combination of them. @pre matroid()
  [[nodiscard]] const std::vector<int>& inputs() const { return matroid()->choice.joints; }
  [[nodiscard]] const std::vector<std::vector<Rational>>& rates() const { return m_rates; }
  /// The row of P of a mesh in numbers of teeth, by joint, including zeros, with a mistake if wanted. @pre
  /// matroid()
  [[nodiscard]] std::vector<Rational> teethRow(MeshOrdinal mesh, RowChange change = RowChange::none) const;

  /// The most sets of couplings that are considered.
  static constexpr std::size_t kMaxEngagedSets = 256;
  /// By state of the document: the considered sets of couplings with their results. @pre there is such a
  /// state
  [[nodiscard]] const std::vector<EngagedSet>& engagedSets(int state) const {
    return m_engagedSets[static_cast<std::size_t>(state)];
  }
  /// The position among engagedSets(state) of the couplings that the state engages; std::nullopt if that set
  /// was not considered.
  [[nodiscard]] std::optional<std::size_t> setOfState(int state) const;

  [[nodiscard]] std::string linkLabel(LinkOrdinal node) const {
    return std::to_string(graph().nodeLabel(node));
  }
  [[nodiscard]] std::string edgeLabel(int edge) const { return std::to_string(graph().edgeLabel(edge)); }
  [[nodiscard]] std::string meshLabel(MeshOrdinal mesh) const { return edgeLabel(graph().t() + mesh); }
  [[nodiscard]] ElementId linkId(LinkOrdinal node) const { return graph().nodeId(node); }
  [[nodiscard]] ElementId edgeId(int edge) const { return graph().edgeId(edge); }
  [[nodiscard]] ElementId meshId(MeshOrdinal mesh) const { return edgeId(graph().t() + mesh); }

 private:
  void solveRates();
  void solveStates();

  SnapshotPtr m_snapshot;
  std::vector<std::vector<Rational>> m_rates;
  std::vector<std::vector<EngagedSet>> m_engagedSets;
};

enum class Difficulty { easy, medium, hard };

/// The difficulty, estimated from cycles, inputs and uncommon features of the mechanism.
struct DifficultyNote {
  Difficulty level = Difficulty::easy;
  std::string text;  ///< "medium: 4 cycles, 3 inputs"
};
[[nodiscard]] DifficultyNote difficultyOf(const ExerciseSource& source);
/// "Medium": for sheets, whose questions ask for the counts of the note.
[[nodiscard]] std::string difficultyTitle(Difficulty level);

}  // namespace geargraph
