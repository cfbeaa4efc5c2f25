#include "ui/canvas/node_placer.h"

namespace geargraph::inline canvas {
namespace {

constexpr std::size_t kSmall = 120;  ///< links that are laid out within a few milliseconds

}  // namespace

NodePlacer::NodePlacer(QObject* parent)
    : QObject(parent), m_worker([this](const Request& request, const std::stop_token&) { seek(request); }) {}

NodePositions NodePlacer::placesOf(const MechanismPtr& mechanism) {
  if (mechanism->view.nodes.size() >= mechanism->links.size()) return mechanism->view.nodes;
  Mechanism placed = adopted(*mechanism);
  if (placed.view.nodes.size() >= mechanism->links.size()) return std::move(placed.view.nodes);
  if (mechanism->links.size() <= kSmall) {
    NodePositions all = completedPositions(placed);
    m_found.insert(all.begin(), all.end());
    return all;
  }
  NodePositions known = placed.view.nodes;
  if (m_sought != mechanism) {
    start(std::make_shared<const Mechanism>(std::move(placed)), &completedPositions, &NodePlacer::remember);
    m_sought = mechanism;
  }
  return known;
}

Mechanism NodePlacer::adopted(Mechanism mechanism) const {
  for (const Link& link : mechanism.links) {
    const auto found = m_found.find(link.id);
    if (found != m_found.end()) mechanism.view.nodes.insert(*found);
  }
  return mechanism;
}

void NodePlacer::layOut(const MechanismPtr& mechanism) {
  if (mechanism->links.size() <= kSmall) {
    emit laidOut(layoutOf(*mechanism));
    return;
  }
  start(mechanism, &layoutOf, &NodePlacer::laidOut);
}

void NodePlacer::forget() {
  m_found.clear();
  m_sought.reset();
  ++m_request;
}

void NodePlacer::remember(const NodePositions& positions) {
  m_sought.reset();
  m_found.insert(positions.begin(), positions.end());
  emit placesFound();
}

void NodePlacer::start(const MechanismPtr& mechanism, Search search, Deliver deliver) {
  m_sought.reset();
  m_worker.request({mechanism, search, deliver, ++m_request});
}

void NodePlacer::seek(const Request& request) {
  const auto arrive = [this, request, found = request.search(*request.mechanism)] {
    if (request.number == m_request) (this->*request.deliver)(found);  // else nobody wants it any more
  };
  QMetaObject::invokeMethod(this, arrive, Qt::QueuedConnection);
}

}  // namespace geargraph::inline canvas
