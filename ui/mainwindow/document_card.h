#pragma once

#include <QStyledItemDelegate>

namespace geargraph {

/// Roles of a list of documents; the name is its display text.
enum DocumentRole {
  kPathRole = Qt::UserRole + 1,
  kNoteRole,     ///< one line of description
  kPictureRole,  ///< QImage
};

/// Paints a document of a list as a card: the picture above name and note, or beside them.
class DocumentCard : public QStyledItemDelegate {
  Q_OBJECT

 public:
  enum class Form { upright, row };

  DocumentCard(Form form, QObject* parent) : QStyledItemDelegate(parent), m_form(form) {}

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  Form m_form;
};

}  // namespace geargraph
