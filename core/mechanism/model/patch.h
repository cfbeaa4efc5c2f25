#pragma once

#include <cstddef>
#include <memory>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The difference between two versions of a document, from which either gives the other. The history stores
/// patches instead of documents: an edit of one element takes some hundred bytes, whatever the size of the
/// document.
class MechanismPatch {
 public:
  /// Cost: O(n + t + c) comparisons.
  MechanismPatch(const Mechanism& before, const Mechanism& after);

  /// The document after the edit from the one before it, and vice versa.
  /// Cost: O(n + t + c).
  /// @pre the document is the one that the patch was made from
  [[nodiscard]] Mechanism forward(Mechanism before) const;
  [[nodiscard]] Mechanism back(Mechanism after) const;

  [[nodiscard]] bool isEmpty() const { return m_isEmpty; }
  /// Memory that the patch holds, counted from its contents.
  [[nodiscard]] std::size_t bytes() const { return m_bytes; }

 private:
  struct Parts;  ///< one patch for each member of the document (patch_parts.h)

  std::shared_ptr<const Parts> m_parts;  ///< copies share it
  bool m_isEmpty = true;
  std::size_t m_bytes = 0;
};

}  // namespace geargraph
