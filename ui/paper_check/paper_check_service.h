#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/mechanism/model/mechanism.h"
#include "core/teaching/paper_check/paper_check.h"
#include "ui/service/service.h"

namespace geargraph::inline ui_paper_check {

/// The user's text, to be compared with the matrices and equations derived from a mechanism.
struct PaperCheckRequest {
  MechanismPtr mechanism;
  std::string text;
  std::optional<PaperMatrix> kind = {};  ///< empty: recognized from the text
};

/// A verdict, or the reasons why there is none.
struct PaperCheckAnswer {
  MechanismPtr mechanism;  ///< what the text was compared with
  std::optional<PaperVerdict> verdict;
  Diagnostics faults;  ///< with line and column if about the text, without if about the mechanism
};
using PaperCheckAnswerPtr = std::shared_ptr<const PaperCheckAnswer>;

/// Checks the user's matrices and equations on a background thread. The derived matrices are cached while
/// only the text changes.
///
/// @pre requested mechanisms have at most kMaxExerciseLinks moving links
class PaperCheckService final : public Service<PaperCheckRequest, PaperCheckAnswerPtr> {
 public:
  explicit PaperCheckService(QObject* parent = nullptr);
};

}  // namespace geargraph::inline ui_paper_check
