#pragma once

#include <QString>
#include <string>

#include "core/theory/analysis/analysis.h"

namespace geargraph::inline models {

/// A link in a row of a panel: "link 4 (sun)"; "link 4" without a name, or with one that repeats the label.
/// Long names are shortened at their end.
[[nodiscard]] QString linkText(const QString& label, const std::string& name);
/// The same by itself where it is short: "sun", else "link 4".
[[nodiscard]] QString shortLinkText(const QString& label, const std::string& name);
/// A joint's motion as that of its head: "link 6 (tool) relative to 3"; on the ground the latter is left out.
[[nodiscard]] QString relativeText(const QString& head, const std::string& headName, const QString& tail);

/// Names of the links of a snapshot. Renaming a link is no reason to analyse anew, so that names are asked of
/// the newest document where it has the same links.
class LinkNames {
 public:
  void setSnapshot(const SnapshotPtr& snapshot) { m_snapshot = snapshot; }
  void setNewest(MechanismPtr mechanism) { m_newest = std::move(mechanism); }
  /// Of a node of the snapshot's digraph. Cost: O(1).
  [[nodiscard]] const std::string& nameOf(int node) const;

 private:
  SnapshotPtr m_snapshot;
  MechanismPtr m_newest;
};

}  // namespace geargraph::inline models
