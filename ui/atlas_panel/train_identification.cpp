#include "ui/atlas_panel/train_identification.h"

#include "core/design/atlas/chain_document.h"
#include "core/mechanism/model/difference.h"

namespace geargraph {
namespace {

void answerIdentity(const PlacedMechanism& placed, const IdentificationService::Responder& respond) {
  static const auto catalogue = std::make_shared<const ChainCatalogue>(Atlas::shipped());
  auto answer = std::make_shared<TrainAnswer>();
  answer->catalogue = catalogue;
  answer->mechanism = placed.pointer();
  answer->isTooLarge = placed.mechanism().links.size() > kMaxIdentifiedLinks;
  if (answer->isTooLarge) return respond(answer);
  auto drawn = drawnChain(placed, placed.placement());
  if (!drawn) {
    answer->why = drawn.error();
    return respond(answer);
  }
  answer->identity = identifyTrain(placed, placed.placement(), *drawn, catalogue->atlas(), respond.stop());
  answer->drawn = *std::move(drawn);
  if (answer->identity) respond(answer);
}

void answerDetails(const AtlasChain* chain, const ChainDetailsService::Responder& respond) {
  auto details = std::make_shared<ChainDetails>();
  details->chain = chain;
  details->relatives = relativesOf(chain->chain, Atlas::shipped());
  if (chain->number.dof == 0) details->lockedMeshes = degenerateMeshes(chain->chain);
  respond(details);
}

void answerDocument(const AtlasChain* chain, const ChainDocumentService::Responder& respond) {
  Mechanism made = chainDocument(chain->chain, chain->number.toString(), {}, respond.stop());
  if (!respond.stop().stop_requested()) respond(std::make_shared<const Mechanism>(std::move(made)));
}

bool isSameChainDrawn(const PlacedMechanism& before, const PlacedMechanism& now) {
  return isSameTrain(before, now);
}

}  // namespace

IdentificationService::IdentificationService(QObject* parent)
    : Service(answerIdentity, parent, {.same = &isSameChainDrawn}) {}

ChainDetailsService::ChainDetailsService(QObject* parent) : Service(answerDetails, parent) {}

ChainDocumentService::ChainDocumentService(QObject* parent) : Service(answerDocument, parent) {}

}  // namespace geargraph
