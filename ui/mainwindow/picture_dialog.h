#pragma once

#include <QDialog>

#include "core/presentation/picture/picture.h"
#include "core/presentation/stage/film.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace geargraph::inline mainwindow {

/// What the 3D view is written as: a PNG (animated where it is a film), a folder of them, or its solids.
enum class SolidForm { png, pictures, glb };

/// A picture that somebody wants: of which view, and how.
struct PictureWish {
  QString view;            ///< a drawing's name, or "3d"
  DrawingPicture picture;  ///< of the 3D view: theme, ground and size
  SolidForm solid = SolidForm::png;
  std::optional<Film> film = {};  ///< of the 3D view
  bool isFitted = false;          ///< the camera goes where all is in view; else it stays where it is
};

/// Asks what picture to export; the file is asked for afterwards. It does not lock the window.
class PictureDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `views`: names and titles, the one in front first to be chosen. "3d" is pixels only.
  PictureDialog(const std::vector<std::pair<QString, QString>>& views, const QString& inFront, bool dark,
                QWidget* parent = nullptr);

  [[nodiscard]] PictureWish wish() const;

 signals:
  void wanted(const geargraph::PictureWish& wish);

 private:
  void renew();
  QWidget* makeFilm();
  [[nodiscard]] bool isSolid() const;

  QComboBox* m_view;
  QComboBox* m_form;
  QCheckBox* m_sized;
  QSpinBox* m_width;
  QSpinBox* m_height;
  QCheckBox* m_transparent;
  QCheckBox* m_dark;
  QComboBox* m_film;
  QSpinBox* m_frames;
  QDoubleSpinBox* m_rate;
  QCheckBox* m_fitted;
};

}  // namespace geargraph::inline mainwindow
