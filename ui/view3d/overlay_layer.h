#pragma once

#include <QObject>
#include <functional>
#include <set>

#include "core/presentation/scene/image.h"
#include "core/presentation/scene3d/label_anchors.h"
#include "core/presentation/scene3d/scene_view.h"
#include "ui/view3d/overlay.h"

class QPainter;

namespace geargraph {

class Viewer;

/// Where more is painted over a picture of the solids.
struct OverlayPlace {
  const LabelGround& ground;  ///< logical pixels of the painter
  const SceneView& view;
  double top;  ///< below what stands at the upper left already
  bool isDark;
  std::set<ElementId> highlighted;  ///< elements that are selected or pointed at
};

/// Paints on any one thread at a time.
using PaintOver = std::function<void(QPainter& painter, const OverlayPlace& place)>;

/// What others lay over a 3D view, above labels and forces. It is a child of the view: findChild() gives the
/// first layer, which pictures in files have, too; later ones are for the screen alone.
class OverlayLayer : public QObject {
  Q_OBJECT

 public:
  /// `sharesLabels`: what is painted has labels of its own (Viewer::setLabelsShared()).
  explicit OverlayLayer(Viewer* viewer, bool sharesLabels = true);

  /// Empty: nothing. The view is painted anew.
  void setPainting(PaintOver painting);
  [[nodiscard]] const PaintOver& painting() const { return m_painting; }

 private:
  Viewer* m_viewer;
  bool m_sharesLabels;
  PaintOver m_painting;
};

/// Paints the layers of a viewer's view; nothing where it has none.
void paintLayer(QPainter& painter, const LabelGround& ground, const Viewer& viewer, bool isDark);
/// Paints it over a picture of its own; nothing without a painting.
void paintLayer(Image& image, const LabelGround& ground, const SceneView& view, const PaintOver& painting,
                bool isDark, const ShownForces& forces);

}  // namespace geargraph
