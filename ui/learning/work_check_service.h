#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/mechanism/model/mechanism.h"
#include "core/teaching/work_check/work_check.h"
#include "ui/service/service.h"

namespace geargraph {

/// The user's text, to be compared with the matrices and equations derived from a mechanism.
struct WorkCheckRequest {
  MechanismPtr mechanism;
  std::string text;
  std::optional<PaperMatrix> kind = {};  ///< empty: recognized from the text
};

/// A verdict, or the reasons why there is none.
struct WorkCheckAnswer {
  MechanismPtr mechanism;  ///< what the text was compared with
  std::optional<WorkVerdict> verdict;
  Diagnostics faults;  ///< with line and column if about the text, without if about the mechanism
};
using WorkCheckAnswerPtr = std::shared_ptr<const WorkCheckAnswer>;

/// Checks the user's matrices and equations on a background thread. The derived matrices are cached while
/// only the text changes.
///
/// @pre requested mechanisms have at most kMaxExerciseLinks moving links
class WorkCheckService final : public Service<WorkCheckRequest, WorkCheckAnswerPtr> {
 public:
  explicit WorkCheckService(QObject* parent = nullptr);
};

}  // namespace geargraph
