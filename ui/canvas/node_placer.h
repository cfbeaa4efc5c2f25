#pragma once

#include <QObject>
#include <memory>

#include "core/presentation/drawing/layout.h"
#include "ui/service/service.h"

namespace geargraph::inline canvas {

/// Knows where every link of a document stands on the sheet: where the document says so, there; else where it
/// was put before; else where the layout puts it. Small documents are laid out at once, large ones in a
/// thread of their own, the newest request first.
class NodePlacer final : public QObject {
  Q_OBJECT

 public:
  explicit NodePlacer(QObject* parent = nullptr);

  /// The places known now. Emits placesFound() later if some are still being sought.
  [[nodiscard]] NodePositions placesOf(const MechanismPtr& mechanism);
  [[nodiscard]] bool isSeeking() const { return m_sought != nullptr; }

  /// Seeks a new layout for all links; laidOut() follows, at once for a small document.
  void layOut(const MechanismPtr& mechanism);

  /// The document with every place that is known written into it, so that saving keeps what is seen.
  [[nodiscard]] Mechanism adopted(Mechanism mechanism) const;
  /// Another document: what was found for the last one counts no more.
  void forget();

 signals:
  void placesFound();
  void laidOut(const geargraph::NodePositions& positions);

 private:
  /// The places of the links that have none, or new ones for all.
  using Search = NodePositions (*)(const Mechanism&);
  struct Request {
    MechanismPtr mechanism;
    Search search = nullptr;
  };
  struct Found {
    Search search = nullptr;
    NodePositions places;
  };
  using Searches = Service<Request, Found>;
  void onFound(const Found& found);

  NodePositions m_found;  ///< for links that the document has no place for
  MechanismPtr m_sought;  ///< whose missing places are being sought
  Searches* m_searches;
};

}  // namespace geargraph::inline canvas
