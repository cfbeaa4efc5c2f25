#pragma once

#include <QObject>
#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <set>

#include "core/foundations/base/id.h"

namespace geargraph {

/// The selected and the hovered elements, shared by all views of a window. Hovered is the element under the
/// mouse, or all elements of a derived item under the mouse (a cycle, a chip of the status bar, a
/// diagnostic). Stores only ids, so it survives undo and redo; keepOnly() drops ids that no longer exist.
class Selection : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Sets which elements there are; others are neither selected nor hovered from now on. A view may be behind
  /// the document, as the 3D picture is while bodies are found, and what lies there under the mouse may be
  /// gone.
  void setExists(std::function<bool(const ElementId&)> exists) { m_exists = std::move(exists); }

  [[nodiscard]] const std::set<ElementId>& selected() const { return m_selected; }
  [[nodiscard]] bool isSelected(const ElementId& element) const { return m_selected.contains(element); }
  void select(std::set<ElementId> elements);
  void toggle(const ElementId& element);
  void clear() { select({}); }

  /// The elements to highlight: the hovered ones, else those of setFallbackHighlight().
  [[nodiscard]] const std::set<ElementId>& hovered() const {
    return m_hovered.empty() ? m_fallbackHighlight : m_hovered;
  }
  [[nodiscard]] bool isHovered(const ElementId& element) const { return hovered().contains(element); }
  void hover(std::set<ElementId> elements);
  void hover(const ElementId& element) { hover(std::set<ElementId>{element}); }
  void unhover() { hover(std::set<ElementId>{}); }

  /// Sets the elements highlighted while nothing is hovered, for what a view explains about the selection.
  void setFallbackHighlight(std::set<ElementId> elements);

  /// Drops the elements for which `exists` is false. To be called after every change of the document.
  template <class Exists>
  void keepOnly(Exists exists) {
    if (!std::all_of(m_selected.begin(), m_selected.end(), exists)) select(kept(m_selected, exists));
    if (!std::all_of(m_hovered.begin(), m_hovered.end(), exists)) hover(kept(m_hovered, exists));
    if (!std::all_of(m_fallbackHighlight.begin(), m_fallbackHighlight.end(), exists))
      setFallbackHighlight(kept(m_fallbackHighlight, exists));
  }

 signals:
  void selectionChanged();
  void hoverChanged();

 private:
  template <class Exists>
  static std::set<ElementId> kept(const std::set<ElementId>& elements, Exists exists) {
    std::set<ElementId> left;  // often few of thousands
    std::copy_if(elements.begin(), elements.end(), std::inserter(left, left.end()), exists);
    return left;
  }

  [[nodiscard]] std::set<ElementId> existing(std::set<ElementId> elements) const {
    if (m_exists) std::erase_if(elements, [this](const ElementId& element) { return !m_exists(element); });
    return elements;
  }

  std::function<bool(const ElementId&)> m_exists;
  std::set<ElementId> m_selected;
  std::set<ElementId> m_hovered;
  std::set<ElementId> m_fallbackHighlight;
};

}  // namespace geargraph
