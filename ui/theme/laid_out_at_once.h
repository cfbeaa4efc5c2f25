#pragma once

#include <QWidget>

namespace geargraph::inline theme {

/// While it lives, widgets can be added to the layout of a panel; at its end they are shown and laid out
/// together. Qt alone shows each in an event of its own and lays out the whole panel for each: 30 rows of
/// six widgets took 100 ms.
class LaidOutAtOnce {
 public:
  explicit LaidOutAtOnce(QWidget* panel);
  ~LaidOutAtOnce();
  LaidOutAtOnce(const LaidOutAtOnce&) = delete;
  LaidOutAtOnce& operator=(const LaidOutAtOnce&) = delete;

 private:
  QWidget* m_panel;
};

}  // namespace geargraph::inline theme
