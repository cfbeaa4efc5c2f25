#pragma once

#include <QLayout>
#include <QWidget>

namespace geargraph {

/// While it lives, a list of controls is hidden, so that rows can be added to its layout; at its end all are
/// shown together. A control that is added to a visible list is shown in an event of its own, in which Qt
/// lays out the whole list and asks the display for the place of the mouse: 30 rows of six controls took 100
/// ms. What has the focus in the list loses it.
class LaidOutAtOnce {
 public:
  explicit LaidOutAtOnce(QWidget* list);
  ~LaidOutAtOnce();
  LaidOutAtOnce(const LaidOutAtOnce&) = delete;
  LaidOutAtOnce& operator=(const LaidOutAtOnce&) = delete;

 private:
  QWidget* m_list;
  bool m_wasShown;  ///< or is to be, with its parent
};

/// Takes a control out of a list for good. It is deleted when control returns to the event loop, because the
/// change that it is removed for may come from itself. Being hidden, it commits what has been typed.
void removeFrom(QLayout& list, QWidget* control);

}  // namespace geargraph
