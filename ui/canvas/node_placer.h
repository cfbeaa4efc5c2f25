#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <unordered_map>

#include "core/presentation/drawing/layout.h"
#include "ui/service/service.h"

namespace geargraph {

/// Finds the places of all links of a document on the sheet: those of the document; else the ones found
/// before; else from the layout. Small documents are laid out synchronously, large ones on a background
/// thread, where the newest request wins.
class NodePlacer final : public QObject {
  Q_OBJECT

 public:
  explicit NodePlacer(QObject* parent = nullptr);

  /// The places known now; placesFound() follows if some are still being computed.
  [[nodiscard]] NodePositions placesOf(const MechanismPtr& mechanism);
  [[nodiscard]] bool isSeeking() const { return m_sought != nullptr; }

  /// Computes a new layout for all links; laidOut() follows, immediately for a small document.
  void layOut(const MechanismPtr& mechanism);

  /// The document with all known places stored in it, so that saving keeps the drawing.
  [[nodiscard]] Mechanism adopted(Mechanism mechanism) const;
  /// Discards the places found, for another document.
  void forget();

 signals:
  void placesFound();
  void laidOut(const geargraph::NodePositions& positions);

 private:
  [[nodiscard]] NodePositions knownPlaces(const Mechanism& mechanism) const;
  /// The places of the links that have none, or new ones for all.
  using Search = NodePositions (*)(const Mechanism&);
  struct Request {
    MechanismPtr mechanism;
    Search search = nullptr;
    std::optional<NodePositions> known = {};  ///< instead of those of the mechanism
  };
  struct Found {
    Search search = nullptr;
    NodePositions places;
  };
  using Searches = Service<Request, Found>;
  void onFound(const Found& found);

  std::unordered_map<LinkId, CanvasPoint> m_found;  ///< for links that the document has no place for
  MechanismPtr m_sought;                            ///< whose missing places are being sought
  Searches* m_searches;
};

}  // namespace geargraph
