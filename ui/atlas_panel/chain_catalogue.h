#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/design/atlas/atlas_file.h"

namespace geargraph {

/// Which chains are shown; what has no value does not decide.
struct ChainFilter {
  std::optional<int> links = {};
  std::optional<int> dof = {};  ///< 0: trains that cannot turn
  std::optional<int> axes = {};
  bool isNonfractionatedOnly = false;
  std::optional<ChainNumber> equations = {};  ///< of a rotation graph: only its chains

  friend bool operator==(const ChainFilter&, const ChainFilter&) = default;
};

/// How many chains each choice of a filter would show, all other filters as they are.
struct FilterCounts {
  std::map<int, int> links;
  std::map<int, int> dof;
  std::map<int, int> axes;
  int all = 0;              ///< with this filter
  int rotations = 0;        ///< rotation graphs among them
  int nonfractionated = 0;  ///< with isNonfractionatedOnly
};

/// The chains of an atlas with what filters ask of them, which is found out once.
class ChainCatalogue {
 public:
  /// Cost: a few milliseconds for 2,000 chains. The atlas outlives the catalogue.
  explicit ChainCatalogue(const Atlas& atlas);

  [[nodiscard]] const Atlas& atlas() const { return *m_atlas; }
  /// The chains that a filter leaves, by number. Cost: O(chains).
  [[nodiscard]] std::vector<const AtlasChain*> chosen(const ChainFilter& filter) const;
  /// Cost: O(chains). Choices that show no chain are there with 0.
  [[nodiscard]] FilterCounts counts(const ChainFilter& filter) const;

 private:
  struct Facts {
    const AtlasChain* chain = nullptr;
    bool isNonfractionated = false;
  };
  /// By how many, and by which of the filters a chain is left out.
  struct Exclusion {
    bool links = false;
    bool dof = false;
    bool axes = false;
    bool fractionated = false;
    bool equations = false;
    [[nodiscard]] int count() const { return links + dof + axes + fractionated + equations; }
  };
  [[nodiscard]] static Exclusion exclusionOf(const Facts& facts, const ChainFilter& filter);

  const Atlas* m_atlas;
  std::vector<Facts> m_facts;
};

}  // namespace geargraph
