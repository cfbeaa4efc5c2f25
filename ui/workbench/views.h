#pragma once

#include <QObject>
#include <QPoint>
#include <vector>

#include "core/foundations/base/contract.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

namespace geargraph {
class Document;
}  // namespace geargraph
namespace geargraph {
class Selection;
}  // namespace geargraph
namespace geargraph {
class Workbench;
}  // namespace geargraph

namespace geargraph {

/// The views of one window, and what they ask of it: its signals are emitted by views and answered by the
/// window, or by another view.
class Views final : public QObject {
  Q_OBJECT

 public:
  struct Made {
    ViewEntry entry;
    ResultsView* view;
  };

  Views(Workbench& workbench, QObject* parent);

  [[nodiscard]] Workbench& workbench() const { return m_workbench; }
  [[nodiscard]] Document* document() const;
  [[nodiscard]] Selection* selection() const;

  /// Makes a view. @pre no view with this id has been made
  ResultsView& make(const ViewEntry& entry, QWidget* parent);
  /// In the order in which they were made.
  [[nodiscard]] const std::vector<Made>& made() const { return m_made; }

  /// The view of this type. @pre it has been made. Cost: O(views)
  template <class T>
  [[nodiscard]] T& get() const {
    T* const found = find<T>();
    GEARGRAPH_REQUIRE(found != nullptr);
    return *found;
  }
  /// The same; null if it has not been made.
  template <class T>
  [[nodiscard]] T* find() const {
    for (const Made& each : m_made)
      if (auto* found = dynamic_cast<T*>(each.view)) return found;
    return nullptr;
  }

  /// @pre a view with this id has been made
  [[nodiscard]] ResultsView& byId(const QString& id) const;

  void setMechanism(const MechanismPtr& mechanism);
  void setSnapshot(const SnapshotPtr& snapshot);
  void setAnswersOpen(bool isOpen);
  [[nodiscard]] bool isSettled() const;

 signals:
  /// A view has done what it was asked for.
  void settled();
  /// A view is to come to the front.
  void revealWanted(geargraph::ResultsView* view);
  /// The menu of an element.
  void menuWanted(const geargraph::ElementId& element, QPoint globalPlace);
  /// The motion at this time, s.
  void momentWanted(double time);
  /// A table as CSV is to be saved, with a name for its file.
  void tableExportWanted(const QString& name, const QString& csv);
  /// A document that the program has made is to be shown in a window of its own.
  void documentWanted(const geargraph::MechanismPtr& mechanism);
  /// Something was not possible: why, as a sentence.
  void rejected(const QString& why);

 private:
  Workbench& m_workbench;
  std::vector<Made> m_made;
};

}  // namespace geargraph
