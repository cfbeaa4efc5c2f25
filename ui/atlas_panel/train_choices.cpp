#include "ui/atlas_panel/train_choices.h"

#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph {
namespace {

void answerChoices(const TrainAnswerPtr& train, const TrainChoicesService::Responder& respond) {
  auto answer = std::make_shared<TrainChoices>();
  answer->train = train;
  answer->choices = choicesOf(train->drawn->chain, train->drawn->teeth, kMaxListedChoices, respond.stop());
  if (!respond.stop().stop_requested()) respond(std::move(answer));
}

/// Reads and identifies the other document, and compares. False if `stop` was requested.
bool compare(TrainComparison& comparison, const std::stop_token& stop) {
  const auto bytes = readFile(comparison.path, kLargestFile);
  if (const auto* error = std::get_if<FileError>(&bytes)) {
    comparison.why = error->message;
    return true;
  }
  auto read = readMechanism(std::get<std::string>(bytes));
  if (!read) {
    comparison.why = read.error().front().message;
    return true;
  }
  comparison.other = std::make_shared<const Mechanism>(*std::move(read));
  const PlacedMechanism placed(comparison.other);
  const TrainIdentity& own = *comparison.train->identity;
  if (comparison.other->links.size() > kMaxIdentifiedLinks) {
    comparison.why = translated("The trains are too large to be compared.");
    return true;
  }
  const auto drawn = drawnChain(placed, placed.placement());
  if (!drawn) {
    comparison.why = drawn.error().front().message;
    return true;
  }
  auto identity =
      identifyTrain(placed, placed.placement(), *drawn, comparison.train->catalogue->atlas(), stop);
  if (!identity) return false;
  comparison.identity = *std::move(identity);
  if (std::max(own.chain.links, comparison.identity.chain.links) > kMaxMatchedLinks) {
    comparison.why = translated("The trains are too large to be compared.");
  } else {
    comparison.same = matchOf(own, comparison.identity);
  }
  return true;
}

void answerComparison(const ComparisonRequest& request, const ComparisonService::Responder& respond) {
  auto comparison = std::make_shared<TrainComparison>();
  comparison->train = request.train;
  comparison->path = request.path;
  if (compare(*comparison, respond.stop())) respond(std::move(comparison));
}

}  // namespace

TrainChoicesService::TrainChoicesService(QObject* parent) : Service(answerChoices, parent) {}

ComparisonService::ComparisonService(QObject* parent) : Service(answerComparison, parent) {}

}  // namespace geargraph
