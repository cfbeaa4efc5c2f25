#pragma once

#include <QDialog>

#include "core/presentation/cairo_output/picture.h"
#include "core/presentation/scene3d/animation.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace geargraph {

/// The form of a 3D export: a PNG (animated for an animation), a folder of PNGs, or the solids.
enum class SolidForm { png, pictures, glb };

/// The options of a picture export.
struct PictureOptions {
  QString view;            ///< a drawing's name, or "3d"
  DrawingPicture picture;  ///< for the 3D view: theme, background and size
  SolidForm solid = SolidForm::png;
  std::optional<Animation> animation = {};  ///< of the 3D view
  bool isFitted = false;  ///< the camera is moved so that everything is in view; else it stays
};

/// Asks for the options of a picture export; the file is chosen afterwards. Not modal.
class PictureDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `views`: names and titles; `inFront` is preselected. "3d" is pixels only.
  PictureDialog(const std::vector<std::pair<QString, QString>>& views, const QString& inFront, bool dark,
                QWidget* parent = nullptr);

  [[nodiscard]] PictureOptions options() const;

 signals:
  void wanted(const geargraph::PictureOptions& options);

 private:
  void renew();
  QWidget* makeAnimationRow();
  [[nodiscard]] bool isSolid() const;

  QComboBox* m_view;
  QComboBox* m_form;
  QCheckBox* m_sized;
  QSpinBox* m_width;
  QSpinBox* m_height;
  QCheckBox* m_transparent;
  QCheckBox* m_dark;
  QComboBox* m_animation;
  QSpinBox* m_frames;
  QDoubleSpinBox* m_rate;
  QCheckBox* m_fitted;
};

}  // namespace geargraph
