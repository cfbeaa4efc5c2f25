#pragma once

#include <QDialog>

class QListView;

namespace geargraph {
class Document;
class HistoryModel;
}  // namespace geargraph

namespace geargraph {

/// The history of a document as a list: a click on a step, or Return, goes to it. Follows the document. Not
/// modal.
class HistoryDialog final : public QDialog {
  Q_OBJECT

 public:
  HistoryDialog(Document* document, QWidget* parent);

 private:
  void showStep();

  Document* m_document;
  HistoryModel* m_model;
  QListView* m_list;
};

}  // namespace geargraph
