#include "ui/mainwindow/history_dialog.h"

#include <QBoxLayout>
#include <QLabel>
#include <QListView>

#include "ui/document/document.h"
#include "ui/document/history_model.h"

namespace geargraph {

HistoryDialog::HistoryDialog(Document* document, QWidget* parent)
    : QDialog(parent),
      m_document(document),
      m_model(new HistoryModel(&document->undoStack(), this)),
      m_list(new QListView(this)) {
  setObjectName(QStringLiteral("historyDialog"));
  setWindowTitle(tr("History"));
  setAttribute(Qt::WA_DeleteOnClose);
  m_list->setObjectName(QStringLiteral("historyList"));
  m_list->setAccessibleName(tr("Steps of the history"));
  m_list->setModel(m_model);
  m_list->setUniformItemSizes(true);
  m_list->setFrameShape(QFrame::NoFrame);
  m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
  auto* hint = new QLabel(tr("A click on a step, or Return, goes there. Steps below it can be repeated until "
                             "something else is drawn."),
                          this);
  hint->setProperty("look", "hint");
  hint->setWordWrap(true);
  hint->setMargin(8);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_list, 1);
  layout->addWidget(hint);
  resize(300, 420);
  const auto go = [this](const QModelIndex& step) { m_document->goToStep(step.row()); };
  connect(m_list, &QListView::clicked, this, go);
  connect(m_list, &QListView::activated, this, go);
  connect(m_model, &HistoryModel::dataChanged, this, &HistoryDialog::showStep);
  showStep();
}

void HistoryDialog::showStep() {
  const QModelIndex now = m_model->index(m_document->undoStack().index());
  m_list->setCurrentIndex(now);
  m_list->scrollTo(now);
}

}  // namespace geargraph

#include "moc_history_dialog.cpp"
