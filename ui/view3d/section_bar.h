#pragma once

#include <QWidget>
#include <array>

class QSlider;
class QToolButton;

namespace geargraph::inline view3d {

class Viewer;

/// Sliders over the picture: where the section cuts, across which axis and from which side; and how far the
/// train is pulled apart. Each row is there while its mode is on.
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

}  // namespace geargraph::inline view3d
