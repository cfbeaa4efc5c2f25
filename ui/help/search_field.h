#pragma once

#include <QLineEdit>
#include <QPointer>
#include <memory>
#include <vector>

#include "core/theory/analysis/analysis.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/help/search_model.h"
#include "ui/help/search_popup.h"
#include "ui/service/service.h"

class QMenuBar;

namespace geargraph {

/// The search field for commands, elements of the document, terms and headings of the manual; it answers
/// questions, too (search_answers.h). The arrow keys choose an entry, Enter executes it, Esc returns the
/// focus to the former widget.
///
/// Entries are collected when the search begins, so an idle field costs nothing; elements on another thread.
class SearchField : public QLineEdit {
  Q_OBJECT

  using ElementEntries = std::shared_ptr<const std::vector<SearchEntry>>;

 public:
  enum class Scope { everything, terms };

  SearchField(const Document* document, Selection* selection, QMenuBar* menus, QWidget* parent = nullptr);

  /// What answers are taken from; a lesson may keep ratios until its step is right.
  void setSnapshot(const SnapshotPtr& snapshot) { m_snapshot = snapshot; }
  void setAnswersOpen(bool areOpen) { m_areAnswersOpen = areOpen; }

  void begin(Scope scope = Scope::everything);
  void end();

  [[nodiscard]] QSize sizeHint() const override;

  [[nodiscard]] SearchModel& model() { return *m_model; }
  [[nodiscard]] SearchPopup& popup() { return *m_popup; }

 signals:
  void elementChosen(const geargraph::ElementId& element);
  /// The links or the mesh that an answer is about.
  void elementsChosen(const std::vector<geargraph::ElementId>& elements);
  void editChosen(const geargraph::Edit& edit);
  /// A heading of the manual: "drawing#tools".
  void pageChosen(const QString& page);
  /// A disabled command was chosen; `why` is the reason.
  void rejected(const QString& why);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void gather();
  void fill();
  void query();
  void place();
  void highlight(int row);
  void choose(int row);

  const Document* m_document;
  Selection* m_selection;
  QMenuBar* m_menus;
  Service<MechanismPtr, ElementEntries>* m_elements;
  SearchModel* m_model;
  SearchPopup* m_popup;
  QPointer<QWidget> m_before;  ///< had the focus before the search
  Scope m_scope = Scope::everything;
  SnapshotPtr m_snapshot;
  bool m_areAnswersOpen = true;
};

}  // namespace geargraph
