#pragma once

#include <QLayout>
#include <QMainWindow>
#include <QPointer>

namespace geargraph {

/// Lays a window out once when it goes. Qt does so for each bar and dock that is shown: with ten of them a
/// command took 30 to 60 ms.
class LayoutPause {
 public:
  explicit LayoutPause(QMainWindow* window) : m_layout(window->layout()) { m_layout->setEnabled(false); }
  ~LayoutPause() {
    if (m_layout == nullptr) return;
    m_layout->setEnabled(true);
    m_layout->invalidate();
    m_layout->activate();
  }
  LayoutPause(const LayoutPause&) = delete;
  LayoutPause& operator=(const LayoutPause&) = delete;

 private:
  QPointer<QLayout> m_layout;
};

}  // namespace geargraph
