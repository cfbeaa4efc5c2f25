#pragma once

#include <QString>
#include <string>

#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The text for a link in a row of a panel: "link 4 (sun)"; "link 4" without a name, or with one that repeats
/// the label. Long names are shortened at their end.
[[nodiscard]] QString linkText(const QString& label, const std::string& name);
/// The motion of a joint as that of its head link: "link 6 (tool) relative to 3"; only "link 6 (tool)" if the
/// tail is the ground.
[[nodiscard]] QString relativeText(const QString& head, const std::string& headName, const QString& tail);

/// The names of the links of a snapshot. Renaming a link does not repeat the analysis, so names come from the
/// newest document if it has the same links.
class LinkNames {
 public:
  void setSnapshot(const SnapshotPtr& snapshot) { m_snapshot = snapshot; }
  void setNewest(MechanismPtr mechanism) { m_newest = std::move(mechanism); }
  /// The name of a node of the snapshot's digraph. Cost: O(1).
  [[nodiscard]] const std::string& nameOf(int node) const;

 private:
  SnapshotPtr m_snapshot;
  MechanismPtr m_newest;
};

}  // namespace geargraph
