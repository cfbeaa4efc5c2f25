#pragma once

#include <QLayout>
#include <QList>

namespace geargraph {

/// Lines of widgets at their natural widths: what does not fit into a line begins the next one, so that a
/// panel need not be wider than the widest of them. Hidden widgets take no room.
class FlowLayout : public QLayout {
  Q_OBJECT

 public:
  explicit FlowLayout(QWidget* parent);
  ~FlowLayout() override;
  FlowLayout(const FlowLayout&) = delete;
  FlowLayout& operator=(const FlowLayout&) = delete;

  void addItem(QLayoutItem* item) override;
  [[nodiscard]] int count() const override { return static_cast<int>(m_items.size()); }
  [[nodiscard]] QLayoutItem* itemAt(int index) const override { return m_items.value(index); }
  QLayoutItem* takeAt(int index) override;

  [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSize() const override;
  void setGeometry(const QRect& area) override;

 private:
  /// Places the widgets unless `isTrial`. Returns the height of all lines with the margins.
  int place(const QRect& area, bool isTrial) const;
  void placeLine(const QList<QLayoutItem*>& line, const QRect& area, int top, int height) const;

  QList<QLayoutItem*> m_items;
};

}  // namespace geargraph
