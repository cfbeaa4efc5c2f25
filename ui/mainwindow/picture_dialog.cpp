#include "ui/mainwindow/picture_dialog.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardItemModel>

#include "core/presentation/mechanism_scene/scene_picture.h"

namespace geargraph {
namespace {

/// By row of the choice; the last two are of the 3D view only.
constexpr PictureForm kForms[] = {PictureForm::svg, PictureForm::pdf, PictureForm::png};
constexpr int kPngRow = 2, kPicturesRow = 3, kGlbRow = 4;

QSpinBox* pixels(int value, QWidget* parent) {
  auto* box = new QSpinBox(parent);
  box->setRange(kLeastPictureSide, kMaxPictureSide);
  box->setValue(value);
  box->setSuffix(QStringLiteral(" px"));
  return box;
}

}  // namespace

PictureDialog::PictureDialog(const std::vector<std::pair<QString, QString>>& views, const QString& inFront,
                             bool dark, QWidget* parent)
    : QDialog(parent),
      m_view(new QComboBox(this)),
      m_form(new QComboBox(this)),
      m_sized(new QCheckBox(tr("Of this size:"), this)),
      m_width(pixels(1600, this)),
      m_height(pixels(1000, this)),
      m_transparent(new QCheckBox(tr("Transparent background"), this)),
      m_dark(new QCheckBox(tr("Light on dark"), this)),
      m_animation(new QComboBox(this)),
      m_frames(new QSpinBox(this)),
      m_rate(new QDoubleSpinBox(this)),
      m_fitted(new QCheckBox(tr("Fit everything into the picture"), this)) {
  setWindowTitle(tr("Export picture"));
  setObjectName(QStringLiteral("pictureDialog"));
  for (const auto& [name, title] : views) {
    m_view->addItem(title, name);
    if (name == inFront) m_view->setCurrentIndex(m_view->count() - 1);
  }
  m_form->addItems({tr("SVG, lines and text"), tr("PDF, lines and text"), tr("PNG, pixels"),
                    tr("PNG, a folder of pictures"), tr("GLB, the solids in their present pose")});
  m_sized->setToolTip(tr("Without it the picture is as large as the drawing."));
  m_dark->setChecked(dark);

  auto* size = new QHBoxLayout;
  size->addWidget(m_sized);
  size->addWidget(m_width);
  size->addWidget(new QLabel(QStringLiteral("×"), this));
  size->addWidget(m_height);
  size->addStretch(1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* go = buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole);
  go->setDefault(true);
  auto* form = new QFormLayout(this);
  form->addRow(tr("View"), m_view);
  form->addRow(tr("File"), m_form);
  form->addRow(tr("Size"), size);
  form->addRow(tr("Animation"), makeAnimationRow());
  form->addRow(tr("Camera"), m_fitted);
  form->addRow(tr("Background"), m_transparent);
  form->addRow(QString(), m_dark);
  form->addRow(buttons);

  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    emit wanted(options());
    accept();
  });
  connect(m_view, &QComboBox::currentIndexChanged, this, &PictureDialog::renew);
  connect(m_sized, &QCheckBox::toggled, this, &PictureDialog::renew);
  renew();
}

QWidget* PictureDialog::makeAnimationRow() {
  m_animation->setObjectName(QStringLiteral("film"));
  m_animation->addItems({tr("None: one picture"), tr("Turntable: once round"), tr("Motion: one period")});
  m_animation->setItemData(2, tr("A minute where the motion has no period"), Qt::ToolTipRole);
  m_frames->setRange(2, kMaxAnimationFrames);
  m_frames->setValue(Animation{}.frames);
  m_frames->setSuffix(tr(" pictures"));
  m_rate->setRange(1, 100);
  m_rate->setDecimals(0);
  m_rate->setValue(Animation{}.framesPerSecond);
  m_rate->setSuffix(tr(" a second"));
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  for (QWidget* part :
       {static_cast<QWidget*>(m_animation), static_cast<QWidget*>(m_frames), static_cast<QWidget*>(m_rate)}) {
    row->addWidget(part);
  }
  connect(m_animation, &QComboBox::currentIndexChanged, this, &PictureDialog::renew);
  connect(m_form, &QComboBox::currentIndexChanged, this, &PictureDialog::renew);
  return box;
}

bool PictureDialog::isSolid() const {
  return m_view->currentData().toString() == QLatin1String("3d");
}

void PictureDialog::renew() {
  const bool solid = isSolid();
  auto* forms = qobject_cast<QStandardItemModel*>(m_form->model());
  for (int i = 0; i < m_form->count(); ++i) {
    const bool possible = solid ? i >= kPngRow : i <= kPngRow;
    forms->item(i)->setEnabled(possible);
    forms->item(i)->setToolTip(possible ? QString()
                               : solid  ? tr("The 3D view is made of pixels.")
                                        : tr("Only the 3D view has it."));
  }
  if (!forms->item(m_form->currentIndex())->isEnabled()) m_form->setCurrentIndex(kPngRow);
  const bool pixels = m_form->currentIndex() != kGlbRow;
  m_animation->setEnabled(solid && pixels);
  if (m_form->currentIndex() == kPicturesRow && m_animation->currentIndex() == 0)
    m_animation->setCurrentIndex(1);
  const bool isAnimation = m_animation->isEnabled() && m_animation->currentIndex() > 0;
  m_frames->setEnabled(isAnimation);
  m_rate->setEnabled(isAnimation && m_form->currentIndex() == kPngRow);
  m_fitted->setEnabled(solid && pixels);
  m_transparent->setEnabled(pixels);
  m_dark->setEnabled(pixels);
  if (solid) m_sized->setChecked(true);  // it has no size of its own
  m_sized->setEnabled(!solid);
  m_width->setEnabled(m_sized->isChecked() && pixels);
  m_height->setEnabled(m_sized->isChecked() && pixels);
}

PictureOptions PictureDialog::options() const {
  PictureOptions options;
  options.view = m_view->currentData().toString();
  const int row = m_form->currentIndex();
  options.picture.form = kForms[qMin(row, kPngRow)];
  options.solid = row == kGlbRow        ? SolidForm::glb
                  : row == kPicturesRow ? SolidForm::pictures
                                        : SolidForm::png;
  options.isFitted = m_fitted->isChecked();
  if (m_frames->isEnabled()) {
    options.animation =
        Animation{m_animation->currentIndex() == 1 ? AnimationKind::turntable : AnimationKind::motion,
                  m_frames->value(), m_rate->value(), 0};
  }
  options.picture.style.theme = m_dark->isChecked() ? Theme::dark : Theme::light;
  options.picture.style.transparent = m_transparent->isChecked();
  if (m_sized->isChecked())
    options.picture.style.size = SheetStyle::Size{m_width->value(), m_height->value()};
  return options;
}

}  // namespace geargraph

#include "moc_picture_dialog.cpp"
