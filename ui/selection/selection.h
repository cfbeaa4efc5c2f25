#pragma once

#include <QObject>
#include <algorithm>
#include <optional>
#include <set>

#include "core/foundations/base/id.h"

namespace geargraph::inline selection {

/// What the person points at, shared by all views of a window: the selected elements, the one under the
/// mouse, and the elements that a derived thing under the mouse stands for (a cycle, a chip of the status
/// bar, a problem). Ids only, so it survives undo and redo; ids that vanish are dropped by keepOnly().
class Selection : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  [[nodiscard]] const std::set<ElementId>& selected() const { return m_selected; }
  [[nodiscard]] bool isSelected(const ElementId& element) const { return m_selected.contains(element); }
  void select(std::set<ElementId> elements);
  void toggle(const ElementId& element);
  void clear() { select({}); }

  /// All elements that are to light up for what is under the mouse; empty where nothing is.
  [[nodiscard]] const std::set<ElementId>& hovered() const { return m_hovered.empty() ? m_lit : m_hovered; }
  [[nodiscard]] bool isHovered(const ElementId& element) const { return hovered().contains(element); }
  void hover(std::set<ElementId> elements);
  void hover(const ElementId& element) { hover(std::set<ElementId>{element}); }
  void unhover() { hover(std::set<ElementId>{}); }

  /// What is lit while nothing is under the mouse: what a view explains of the selection.
  void keepLit(std::set<ElementId> elements);

  /// Drops what `exists` denies: after every change of the document.
  template <class Exists>
  void keepOnly(Exists exists) {
    if (!std::all_of(m_selected.begin(), m_selected.end(), exists)) select(kept(m_selected, exists));
    if (!std::all_of(m_hovered.begin(), m_hovered.end(), exists)) hover(kept(m_hovered, exists));
    if (!std::all_of(m_lit.begin(), m_lit.end(), exists)) keepLit(kept(m_lit, exists));
  }

 signals:
  void selectionChanged();
  void hoverChanged();

 private:
  template <class Exists>
  static std::set<ElementId> kept(std::set<ElementId> elements, Exists exists) {
    std::erase_if(elements, [&](const ElementId& element) { return !exists(element); });
    return elements;
  }

  std::set<ElementId> m_selected;
  std::set<ElementId> m_hovered;
  std::set<ElementId> m_lit;
};

}  // namespace geargraph::inline selection
