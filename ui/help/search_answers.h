#pragma once

#include <QString>
#include <vector>

#include "core/theory/analysis/analysis.h"
#include "ui/document/document.h"
#include "ui/help/search_entries.h"

namespace geargraph {

/// What a question is answered from.
struct AnswerSource {
  MechanismPtr mechanism;  ///< the document now
  SnapshotPtr snapshot;    ///< its newest analysis; null: none yet
  std::set<ElementId> selected;
  bool areAnswersOpen = true;  ///< false: a lesson asks what a ratio would tell
};

/// Answers to "ratio of link 3 to 1" or "ratio ring sun", and edits for "hold ring", "release ring" and
/// "teeth 20 30" (of the selected mesh, else of each) or "teeth 15 20 30" (of mesh 15), in English or in the
/// language of the window. Links are named by label, or by words of their names. Empty for anything else.
[[nodiscard]] std::vector<SearchEntry> answersTo(const QString& query, const AnswerSource& source);

}  // namespace geargraph
