#pragma once

#include <QWidget>

class QToolButton;

namespace geargraph {

/// A part of a page below a title that shows or hides it.
class FoldingSection : public QWidget {
  Q_OBJECT

 public:
  /// Takes the content. `name`: the object name of the title.
  FoldingSection(const QString& name, const QString& title, const QString& tip, QWidget* content,
                 QWidget* parent = nullptr);

  void setOpen(bool isOpen);
  [[nodiscard]] bool isOpen() const;

 private:
  void fold();

  QToolButton* m_title;
  QString m_text;
  QWidget* m_content;
};

}  // namespace geargraph
