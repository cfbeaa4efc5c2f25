#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/design/atlas/atlas_file.h"
#include "core/design/atlas/chain.h"
#include "core/design/atlas/chain_form.h"
#include "core/design/atlas/chain_freedom.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// A drawn train as a chain: link i is the document's link i, mesh m its mesh m, axes are its axis classes.
struct DrawnChain {
  Chain chain;
  std::vector<SignedTeeth> teeth;  ///< by mesh
};

/// Fails with the diagnostics of the placement where the joints are no tree or a mesh has no carrier or
/// geometry; of treeDiagnostics() in the first case. Brakes and clutches are no part of the chain.
/// @pre the placement is the mechanism's
[[nodiscard]] Expected<DrawnChain> drawnChain(const Mechanism& mechanism, const Placement& placement);

/// Why a link is left out.
enum class RemovalReason {
  copy,    ///< of a planet: its meshes repeat an equation that is there without it
  noMesh,  ///< it is in no mesh, neither as gear nor as carrier: a housing that only bears
};
/// "copy", "no-mesh".
[[nodiscard]] std::string_view removalName(RemovalReason reason);

struct RemovedLink {
  int link = 0;
  RemovalReason why = RemovalReason::copy;
};

/// A part of a train that has at most one link in common with the others.
struct IdentifiedChain {
  std::vector<int> links;   ///< of the document, ascending; link i of `chain` is links[i]
  std::vector<int> meshes;  ///< of the document, ascending
  Chain chain;
  int dof = 0;  ///< with the teeth that are drawn, one link held
  /// Degenerate, and with these teeth, too: links turn as one. Not so where that is only because teeth are
  /// equal (Ferguson's paradox).
  bool isLocked = false;
  bool turnsByTeeth = false;                ///< these teeth leave it more freedom than others would
  std::optional<ChainNumber> rotation;      ///< without displacement; none beyond the atlas
  std::optional<ChainNumber> displacement;  //
};

/// Which chains a drawn train is made of.
struct TrainIdentity {
  std::vector<RemovedLink> removed;  ///< by link
  std::vector<int> links;            ///< that stay, ascending; link i of `chain` is links[i]
  std::vector<int> meshes;           ///< that stay, ascending
  Chain chain;                       ///< of what stays
  std::vector<IdentifiedChain> parts;
};

constexpr int kMaxIdentifiedLinks = 2'000;

/// Drops copies of planets, then links in no mesh, parts what stays at cut links, and looks each part up.
/// std::nullopt if `stop` was requested. Cost: cubic in the links of the largest part.
/// @pre the placement is the mechanism's and has a tree, `drawn` is its chain; kMaxIdentifiedLinks at most
[[nodiscard]] std::optional<TrainIdentity> identifyTrain(const Mechanism& mechanism,
                                                         const Placement& placement, const DrawnChain& drawn,
                                                         const Atlas& atlas,
                                                         const std::stop_token& stop = {});

/// The chains that are nearly this one.
struct ChainRelatives {
  std::vector<ChainNumber> sameEquations;  ///< with other shafts: the other chains of its rotation graph
  std::vector<ChainNumber> oneMeshLess;    ///< without a link that is in one mesh only, and that mesh
  std::vector<ChainNumber> oneMeshMore;    ///< with a link more, in a mesh more
  int frames = 0;                          ///< links that differ as the one that is held
};
[[nodiscard]] ChainRelatives relativesOf(const Chain& chain, const Atlas& atlas);

/// How two trains are the same, link by link.
struct TrainMatch {
  ChainLikeness likeness = ChainLikeness::displacement;
  std::vector<std::pair<int, int>> links;   ///< of the first and the second document, by the first
  std::vector<std::pair<int, int>> meshes;  //
};
constexpr int kMaxMatchedLinks = 300;

/// Compares what stays of two trains: by displacement graphs, else by rotation graphs; std::nullopt if both
/// differ. @pre at most kMaxMatchedLinks links stay of each
[[nodiscard]] std::optional<TrainMatch> matchOf(const TrainIdentity& a, const TrainIdentity& b);

}  // namespace geargraph
