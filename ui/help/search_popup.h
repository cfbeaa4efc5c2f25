#pragma once

#include <QFrame>

#include "ui/help/search_model.h"

class QLabel;
class QListView;
class QStackedWidget;

namespace geargraph {

/// The results of a search, as a card over the window: a list, with a description of the current entry below
/// it; after a term was chosen, its definition.
class SearchPopup : public QFrame {
  Q_OBJECT

 public:
  SearchPopup(SearchModel* model, QWidget* window);

  [[nodiscard]] int currentRow() const;
  void moveCurrent(int rows);
  void setCurrent(int row);
  [[nodiscard]] QListView& list() { return *m_list; }

  void showList(const QString& whyEmpty);
  void showDefinition(Term term);
  /// The preferred height of the results in pixels: at most `most`, at least a few lines.
  [[nodiscard]] int heightForResults(int most) const;
  [[nodiscard]] bool isDefinition() const;

 signals:
  void currentChanged(int row);  ///< -1: none
  void chosen(int row);

 private:
  void updateDetail();

  SearchModel* m_model;
  QListView* m_list;
  QStackedWidget* m_pages;
  QLabel* m_empty;
  QLabel* m_definition;
  QLabel* m_detail;
};

}  // namespace geargraph
