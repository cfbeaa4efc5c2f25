#include "ui/canvas/node_placer.h"

#include <utility>

namespace geargraph {
namespace {

constexpr std::size_t kSmall = 120;  ///< links that are laid out within a few milliseconds

Mechanism withPlaces(Mechanism mechanism, NodePositions places) {
  mechanism.view.nodes = std::move(places);
  return mechanism;
}

}  // namespace

NodePlacer::NodePlacer(QObject* parent)
    : QObject(parent),
      m_searches(new Searches(
          [](const Request& request, const Searches::Responder& respond) {
            respond({request.search, request.known
                                         ? request.search(withPlaces(*request.mechanism, *request.known))
                                         : request.search(*request.mechanism)});
          },
          this)) {
  m_searches->onAnswer(this, [this](const Found& found) { onFound(found); });
  connect(m_searches, &Searches::failed, this, [this] { m_sought.reset(); });
}

NodePositions NodePlacer::placesOf(const MechanismPtr& mechanism) {
  if (mechanism->view.nodes.size() >= mechanism->links.size()) return mechanism->view.nodes;
  NodePositions known = knownPlaces(*mechanism);
  const bool isSmall = mechanism->links.size() <= kSmall;
  if (known.size() >= mechanism->links.size() || (!isSmall && m_sought == mechanism)) return known;
  if (isSmall) {
    NodePositions all = completedPositions(withPlaces(*mechanism, known));
    m_found.insert(all.begin(), all.end());
    return all;
  }
  m_searches->request({mechanism, &completedPositions, known});
  m_sought = mechanism;
  return known;
}

Mechanism NodePlacer::adopted(Mechanism mechanism) const {
  mechanism.view.nodes = knownPlaces(mechanism);
  return mechanism;
}

/// Those that the document has, and those that have been found.
NodePositions NodePlacer::knownPlaces(const Mechanism& mechanism) const {
  NodePositions places = mechanism.view.nodes;
  for (const Link& link : mechanism.links) {
    const auto found = m_found.find(link.id);
    if (found != m_found.end()) places.insert(*found);
  }
  return places;
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

}  // namespace geargraph

#include "moc_node_placer.cpp"
