#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/design/teeth_search/teeth_search.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"

namespace geargraph {

/// The most planets of which TeethChoice tells whether they go in.
constexpr int kMaxPlanetsTold = 24;

/// A choice of teeth with what one wants to know before taking it.
struct TeethChoice {
  FoundTeeth found;
  std::vector<MeshTeeth> teeth;  ///< by mesh
  std::vector<int> planets;  ///< numbers of equal planets, from 2, that go in and clear; none without planets
  std::vector<char> hunting;          ///< by mesh: do its teeth have no common factor?
  std::vector<std::string> undercut;  ///< gears that a rack would undercut, "15:tail"
  std::optional<double> efficiency;   ///< the smallest of the ratios; none without losses, or self-locking
  std::optional<double> backward;     ///< the same with the power the other way
};

struct TeethAnswer {
  std::shared_ptr<const TeethProblem> problem;
  TeethFound found;
  std::vector<TeethChoice> choices;    ///< of found.best; of equal errors the most efficient first
  std::optional<TeethChoice> nearest;  ///< of found.nearest
  /// Where several ratios are wished and none was found: the positions of each that no choice meets, or else
  /// of each two that no choice meets together. Empty also where only more of them exclude each other.
  std::vector<std::vector<int>> conflicts;
};

/// What the conflicts of an answer are, a sentence each: "No choice has ratio 2 (9/2)."
[[nodiscard]] std::vector<std::string> conflictSentences(const TeethAnswer& answer);

/// The teeth for a wish about a drawn train: the best choices and the counts of all. An error where the train
/// leaves nothing to choose (teethProblemOf()). Not complete if `stop` was requested.
/// Cost: as searchTeeth(), and a statics of each choice where it has losses; where several ratios exclude
/// each other a search for each of them and for each two, until the first choice.
/// @pre the wish was read for this mechanism
[[nodiscard]] Expected<TeethAnswer> teethFor(const PlacedMechanism& drawn, const TeethWish& wish,
                                             const TeethSearchOptions& options = {},
                                             const std::stop_token& stop = {});

/// What there is to know of teeth that meet a wish. Its cost is a statics where the train has losses.
[[nodiscard]] TeethChoice choiceOf(const TeethProblem& problem, FoundTeeth found,
                                   const std::stop_token& stop = {});

/// These teeth for every mesh of the document. @pre an entry for each wheel
[[nodiscard]] std::vector<MeshTeeth> meshTeethOf(const TeethProblem& problem, std::span<const int> teeth);

/// The drawn train with these teeth, as one edit: distances and places follow (withAllTeethFitted()). Rejects
/// what fitting rejects.
[[nodiscard]] Expected<PlacedMechanism> withTeethChosen(const PlacedMechanism& drawn,
                                                        const TeethChoice& choice);

}  // namespace geargraph
