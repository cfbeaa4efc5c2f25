#pragma once

#include <QWidget>
#include <functional>

#include "core/presentation/scene/camera.h"

class QMenu;
class QToolButton;

namespace geargraph {

/// The row of buttons over the 3D view: fit, the standard views, the section, and a menu of all else.
class ViewButtons : public QWidget {
  Q_OBJECT

 public:
  explicit ViewButtons(QWidget* parent = nullptr);

  /// Checks the button of the section.
  void setSection(bool isCut);
  /// As if the button of the section were clicked.
  void toggleSection();

 signals:
  void fitWanted();
  void viewWanted(geargraph::StandardView view);
  void sectionToggled();
  void menuOpening(QMenu& menu);  ///< it is empty

 private:
  QToolButton* add(const char* name, const QString& text, const QString& tip,
                   const std::function<void()>& act);
  void addMore();

  QToolButton* m_section;
};

}  // namespace geargraph
