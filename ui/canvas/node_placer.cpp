#include "ui/canvas/node_placer.h"

namespace geargraph::inline canvas {
namespace {

constexpr std::size_t kSmall = 120;  ///< links that are laid out within a few milliseconds

}  // namespace

NodePlacer::NodePlacer(QObject* parent)
    : QObject(parent),
      m_searches(new Searches(
          [](const Request& request, const Searches::Responder& respond) {
            respond({request.search, request.search(*request.mechanism)});
          },
          this)) {
  m_searches->onAnswer(this, [this](const Found& found) { onFound(found); });
  connect(m_searches, &Searches::failed, this, [this] { m_sought.reset(); });
}

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
    m_searches->request({std::make_shared<const Mechanism>(std::move(placed)), &completedPositions});
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
  m_sought.reset();
  m_searches->request({mechanism, &layoutOf});
}

void NodePlacer::forget() {
  m_found.clear();
  m_sought.reset();
  m_searches->cancel();
}

void NodePlacer::onFound(const Found& found) {
  if (found.search == &layoutOf) {
    emit laidOut(found.places);
    return;
  }
  m_sought.reset();
  m_found.insert(found.places.begin(), found.places.end());
  emit placesFound();
}

}  // namespace geargraph::inline canvas
