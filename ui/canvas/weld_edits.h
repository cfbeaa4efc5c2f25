#pragma once

#include <optional>
#include <set>
#include <utility>

#include "ui/document/document.h"

namespace geargraph {

// Welds and splits of the selected links, to be applied or only previewed (MenuPreview).

/// The two links of a selection of two links, the one with the smaller label first: that one stays.
/// std::nullopt for any other selection.
[[nodiscard]] std::optional<std::pair<LinkId, LinkId>> linksToWeld(const Mechanism& now,
                                                                   const std::set<ElementId>& selected);
/// "Weld link 3 and link 7": both become the first one.
[[nodiscard]] Edit weldEdit(const Mechanism& now, LinkId kept, LinkId other);
/// Why the selected links cannot be welded, as a sentence; empty if they can. Cost: that of the edit.
[[nodiscard]] QString whyNoWeld(const Mechanism& now, const std::set<ElementId>& selected);

/// The link that is to be split and what its new half takes: the selected joints, meshes and couplings, or
/// the side of the train that was drawn last where only the link is selected.
struct Split {
  LinkId link;
  std::vector<ElementId> moving;
};
/// std::nullopt unless one link is selected, and besides it only joints, meshes and couplings.
[[nodiscard]] std::optional<Split> splitOf(const Mechanism& now, const std::set<ElementId>& selected);
/// The new link is the last of its list, its node at `at`.
[[nodiscard]] Edit splitEdit(const Mechanism& now, const Split& split, std::optional<CanvasPoint> at);
/// Why the selected link cannot be split, as a sentence; empty if it can. Cost: that of the edit.
[[nodiscard]] QString whyNoSplit(const Mechanism& now, const std::set<ElementId>& selected);

}  // namespace geargraph
