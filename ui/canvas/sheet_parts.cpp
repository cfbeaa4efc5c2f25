#include "ui/canvas/sheet_parts.h"

#include <utility>

#include "ui/canvas/mark_painter.h"

namespace geargraph {
namespace {

QRectF boundsOf(const std::vector<Mark>& marks) {
  QRectF bounds;
  for (const Mark& mark : marks) bounds |= toQRect(extentOf(mark).grown(1));
  return bounds;
}

}  // namespace

SheetParts::SheetParts(std::vector<Mark> marks) {
  for (Mark& mark : marks) {
    auto& places = m_places[mark.z];
    std::vector<Part>& layer = m_layers[mark.z];
    const auto [place, isNew] = places.try_emplace(mark.element, layer.size());
    if (isNew) layer.push_back({mark.element, {}, {}, m_drawing});
    Part& part = layer[place->second];
    part.bounds |= toQRect(extentOf(mark).grown(1));
    part.marks.push_back(std::move(mark));
  }
}

QRectF SheetParts::set(const ElementId& element, int depth, std::vector<Mark> marks) {
  auto& places = m_places[depth];
  std::vector<Part>& layer = m_layers[depth];
  const auto place = places.find(element);
  if (place == places.end()) {
    if (marks.empty()) return {};
    places.emplace(element, layer.size());
    const QRectF bounds = boundsOf(marks);
    layer.push_back({element, std::move(marks), bounds, m_drawing});
    return bounds;
  }
  Part& part = layer[place->second];
  part.drawing = m_drawing;
  if (part.marks == marks) return {};
  const QRectF former = std::exchange(part.bounds, boundsOf(marks));
  part.marks = std::move(marks);
  const QRectF changed = former | part.bounds;
  if (part.marks.empty()) {
    places.erase(place);
    closeHoles(depth);
  }
  return changed;
}

QRectF SheetParts::setElement(const ElementId& element, std::vector<Mark> marks) {
  std::map<int, std::vector<Mark>> byDepth;
  for (const auto& [depth, places] : m_places) {
    if (places.contains(element)) byDepth[depth];
  }
  for (Mark& mark : marks) byDepth[mark.z].push_back(std::move(mark));
  QRectF changed;
  for (auto& [depth, ofDepth] : byDepth) changed |= set(element, depth, std::move(ofDepth));
  return changed;
}

QRectF SheetParts::endDrawing() {
  QRectF vanished;
  for (auto& [depth, layer] : m_layers) {
    for (Part& part : layer) {
      if (part.marks.empty() || part.drawing == m_drawing) continue;
      vanished |= std::exchange(part.bounds, {});
      part.marks.clear();
      m_places[depth].erase(part.element);
    }
    closeHoles(depth);
  }
  return vanished;
}

/// The order stays; done when half of the layer is holes, it costs O(1) for each.
void SheetParts::closeHoles(int depth) {
  std::vector<Part>& layer = m_layers[depth];
  auto& places = m_places[depth];
  if (2 * places.size() > layer.size()) return;
  std::erase_if(layer, [](const Part& part) { return part.marks.empty(); });
  for (std::size_t i = 0; i < layer.size(); ++i) places[layer[i].element] = i;
}

std::size_t SheetParts::count(int depth) const {
  const auto places = m_places.find(depth);
  return places == m_places.end() ? 0 : places->second.size();
}

std::size_t SheetParts::count() const {
  std::size_t all = 0;
  for (const auto& [depth, places] : m_places) all += places.size();
  return all;
}

QRectF SheetParts::bounds(int without) const {
  QRectF bounds;
  for (const auto& [depth, layer] : m_layers) {
    if (depth == without) continue;
    for (const Part& part : layer) bounds |= part.bounds;
  }
  return bounds;
}

}  // namespace geargraph
