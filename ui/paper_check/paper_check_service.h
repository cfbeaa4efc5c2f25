#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/mechanism/model/mechanism.h"
#include "core/teaching/paper_check/paper_check.h"
#include "ui/service/service.h"

namespace geargraph::inline ui_paper_check {

/// A text of the user's that is to be compared with what is derived from a mechanism.
struct PaperCheckRequest {
  MechanismPtr mechanism;
  std::string text;
  std::optional<PaperMatrix> kind = {};  ///< recognised if empty
};

/// A verdict, or why there is none.
struct PaperCheckAnswer {
  MechanismPtr mechanism;  ///< what the text was compared with
  std::optional<PaperVerdict> verdict;
  Diagnostics faults;  ///< of the text with line and column; of the mechanism without
};
using PaperCheckAnswerPtr = std::shared_ptr<const PaperCheckAnswer>;

/// Checks the user's matrices and equations off the GUI thread. The derived matrices of a mechanism are kept
/// while only the text changes.
///
/// @pre the mechanisms that are sent have at most kMostExerciseLinks moving links
class PaperCheckService final : public Service<PaperCheckRequest, PaperCheckAnswerPtr> {
 public:
  explicit PaperCheckService(QObject* parent = nullptr);
};

}  // namespace geargraph::inline ui_paper_check
