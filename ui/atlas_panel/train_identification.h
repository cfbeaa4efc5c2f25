#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/design/atlas/identify.h"
#include "core/mechanism/placement/placed_mechanism.h"
#include "ui/atlas_panel/chain_catalogue.h"
#include "ui/service/service.h"

namespace geargraph {

/// Which chains the document is made of, or why that cannot be said.
struct TrainAnswer {
  std::shared_ptr<const ChainCatalogue> catalogue;  ///< the program's, the same in all answers
  MechanismPtr mechanism;                           ///< that was identified
  Diagnostics why;                                  ///< the train is unfinished
  bool isTooLarge = false;                          ///< over kMaxIdentifiedLinks
  std::optional<DrawnChain> drawn;                  ///< with all its links; none where it is unfinished
  std::optional<TrainIdentity> identity;
};
using TrainAnswerPtr = std::shared_ptr<const TrainAnswer>;

/// Identifies the document, on a thread of its own; the first answer reads the atlas, too. A document that
/// differs only in names and places is not identified again, and is not the answer's mechanism: links have
/// the same places in it.
class IdentificationService final : public Service<PlacedMechanism, TrainAnswerPtr> {
 public:
  explicit IdentificationService(QObject* parent = nullptr);
};

/// What is told of a chain that somebody looks at.
struct ChainDetails {
  const AtlasChain* chain = nullptr;
  ChainRelatives relatives;
  std::optional<std::vector<int>> lockedMeshes;  ///< of a train that cannot turn
};
using ChainDetailsPtr = std::shared_ptr<const ChainDetails>;

/// Looks up the relatives of a chain of the program's atlas: some milliseconds.
class ChainDetailsService final : public Service<const AtlasChain*, ChainDetailsPtr> {
 public:
  explicit ChainDetailsService(QObject* parent = nullptr);
};

/// Makes documents of chains of the program's atlas (chainDocument()).
class ChainDocumentService final : public Service<const AtlasChain*, MechanismPtr> {
 public:
  explicit ChainDocumentService(QObject* parent = nullptr);
};

}  // namespace geargraph
