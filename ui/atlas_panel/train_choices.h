#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/design/atlas/chain_choices.h"
#include "ui/atlas_panel/train_identification.h"
#include "ui/service/service.h"

namespace geargraph {

/// Trees, inputs and frames that are listed of a train.
constexpr std::size_t kMaxListedChoices = 100;

/// By which trees, inputs and frames the identified train can be drawn.
struct TrainChoices {
  TrainAnswerPtr train;
  std::optional<ChainChoices> choices;  ///< none: more than kMaxInputTrials sets of inputs had to be tried
};
using TrainChoicesPtr = std::shared_ptr<const TrainChoices>;

/// choicesOf() the train that was drawn.
class TrainChoicesService final : public Service<TrainAnswerPtr, TrainChoicesPtr> {
 public:
  explicit TrainChoicesService(QObject* parent = nullptr);
};

struct ComparisonRequest {
  TrainAnswerPtr train;
  std::string path;  ///< of the other document
};

/// What two trains have in common, or why that cannot be said.
struct TrainComparison {
  TrainAnswerPtr train;
  std::string path;
  std::string why;         ///< the other file cannot be read, is unfinished, or one of them is too large
  MechanismPtr other;      ///< null where it cannot be read
  TrainIdentity identity;  ///< of the other
  std::optional<TrainMatch> same;
};
using TrainComparisonPtr = std::shared_ptr<const TrainComparison>;

/// Reads another document and tells which of its links are which of the train's (matchOf()).
class ComparisonService final : public Service<ComparisonRequest, TrainComparisonPtr> {
 public:
  explicit ComparisonService(QObject* parent = nullptr);
};

}  // namespace geargraph
