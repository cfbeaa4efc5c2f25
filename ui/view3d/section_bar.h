#pragma once

#include <QWidget>
#include <array>

class QSlider;
class QToolButton;

namespace geargraph {

class Viewer;

/// Sliders over the 3D view: the position, axis and side of the section, and the amount of the exploded view.
/// Each row is shown while its mode is on.
class SectionBar : public QWidget {
  Q_OBJECT

 public:
  explicit SectionBar(Viewer* viewer, QWidget* parent = nullptr);

 private:
  QWidget* makeSectionRow();
  QWidget* makeExplodedRow();
  void refresh();

  Viewer* m_viewer;
  QWidget* m_section = nullptr;
  QWidget* m_exploded = nullptr;
  std::array<QToolButton*, 3> m_axes{};
  QSlider* m_place = nullptr;
  QSlider* m_apart = nullptr;
};

}  // namespace geargraph
