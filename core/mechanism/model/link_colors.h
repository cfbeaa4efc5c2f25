#pragma once

#include <unordered_map>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The colours of the links before an edit, so that they stay with their links however labels move.
class LinkColors {
 public:
  explicit LinkColors(const Mechanism& before);

  /// Gives each link of `after` the colour that it had. A new link gets that of its label, or the first one
  /// that no other link has. Stored (View::colors) is what differs from the label. Cost: O(n).
  void keepIn(Mechanism& after) const;

 private:
  std::unordered_map<LinkId, int> m_numbers;  ///< of moving links
};

}  // namespace geargraph
