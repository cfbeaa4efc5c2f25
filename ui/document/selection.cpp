#include "ui/document/selection.h"

namespace geargraph {

void Selection::select(std::set<ElementId> elements) {
  elements = existing(std::move(elements));
  if (elements == m_selected) return;
  m_selected = std::move(elements);
  emit selectionChanged();
}

void Selection::toggle(const ElementId& element) {
  std::set<ElementId> elements = m_selected;
  if (elements.erase(element) == 0) elements.insert(element);
  select(std::move(elements));
}

void Selection::hover(std::set<ElementId> elements) {
  elements = existing(std::move(elements));
  if (elements == m_hovered) return;
  m_hovered = std::move(elements);
  emit hoverChanged();
}

void Selection::setFallbackHighlight(std::set<ElementId> elements) {
  elements = existing(std::move(elements));
  if (elements == m_fallbackHighlight) return;
  m_fallbackHighlight = std::move(elements);
  if (m_hovered.empty()) emit hoverChanged();
}

}  // namespace geargraph

#include "moc_selection.cpp"
