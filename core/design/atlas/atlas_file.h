#pragma once

#include <compare>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/design/atlas/chain.h"
#include "core/design/atlas/chain_form.h"
#include "core/foundations/base/expected.h"

namespace geargraph {

/// The number of a chain, `links-dof.rotation.displacement`: its place in the file of the atlas. Places never
/// change; what is new in a later file comes after them. A freedom of 0 numbers the minimal degenerate
/// chains.
struct ChainNumber {
  int links = 0;
  int dof = 0;
  int rotation = 0;      ///< of the rotation graph among those of its links and freedom, from 1
  int displacement = 0;  ///< of the displacement graph among those of its rotation graph; 0: all of them

  friend auto operator<=>(const ChainNumber&, const ChainNumber&) = default;
  /// "6-1.5.1"; without displacement "6-1.5".
  [[nodiscard]] std::string toString() const;
  /// std::nullopt if the text is no number, with or without a displacement.
  [[nodiscard]] static std::optional<ChainNumber> fromText(std::string_view text);
};

struct AtlasChain {
  ChainNumber number;
  Chain chain;
};

/// The chains of an atlas by their numbers, and by what they are.
class Atlas {
 public:
  /// The file that is part of the program: to 7 links. Read on first use, about 40 ms; thread-safe.
  [[nodiscard]] static const Atlas& shipped();

  /// Reads a file of `atlasText()`. Fails with `format`, or `syntax` with the line: what is no chain, a
  /// number out of its order, or a chain that is there already.
  [[nodiscard]] static Expected<Atlas> read(std::string_view text);

  /// All chains, by number.
  [[nodiscard]] std::span<const AtlasChain> chains() const { return m_chains; }
  /// Those of so many links and freedoms, by number; empty where the file has none.
  [[nodiscard]] std::span<const AtlasChain> chains(int links, int dof) const;
  /// The chains of a rotation graph.
  [[nodiscard]] std::span<const AtlasChain> group(const ChainNumber& number) const;
  /// Null if there is none. @pre the number has a displacement
  [[nodiscard]] const AtlasChain* find(const ChainNumber& number) const;
  /// The number of a chain; std::nullopt where the file has none such.
  [[nodiscard]] std::optional<ChainNumber> numberOf(const Chain& chain) const;
  /// The number of its rotation graph, without displacement: also found where the file lacks its displacement
  /// graph.
  [[nodiscard]] std::optional<ChainNumber> rotationNumberOf(const Chain& chain) const;
  /// The most links for which chains of this freedom are here; 0: there are none.
  [[nodiscard]] int mostLinks(int dof) const;

 private:
  std::vector<AtlasChain> m_chains;
  std::map<ChainForm, ChainNumber> m_displacements;
  std::map<ChainForm, ChainNumber> m_rotations;
};

/// How many rotation graphs and displacement graphs chains have between them.
struct ChainCounts {
  int rotations = 0;
  int displacements = 0;
};
[[nodiscard]] ChainCounts countsOf(std::span<const AtlasChain> chains);

/// The atlas as text: a section for each number of links (3 to `mostLinks`) and freedom (0, 1, 2), a line per
/// chain, links numbered from 1. Empty if `stop` was requested. Cost: that of the enumeration.
[[nodiscard]] std::string atlasText(int mostLinks, const std::stop_token& stop = {});

/// "1,2,3 1,4 2,5": the links of each axis, from 1.
[[nodiscard]] std::string axesText(const Chain& chain);
/// "2-4/1 3-4/1": the gears of each pair and their carrier.
[[nodiscard]] std::string meshesText(const Chain& chain);

}  // namespace geargraph
