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

#include "core/scene/stage_picture.h"

namespace geargraph {
namespace {

constexpr PictureForm kForms[] = {PictureForm::svg, PictureForm::pdf, PictureForm::png};

QSpinBox* pixels(int value, QWidget* parent) {
  auto* box = new QSpinBox(parent);
  box->setRange(kLeastPictureSide, kMostPictureSide);
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
      m_transparent(new QCheckBox(tr("Transparent ground"), this)),
      m_dark(new QCheckBox(tr("Light on dark"), this)) {
  setWindowTitle(tr("Export picture"));
  for (const auto& [name, title] : views) {
    m_view->addItem(title, name);
    if (name == inFront) m_view->setCurrentIndex(m_view->count() - 1);
  }
  m_form->addItems({tr("SVG, lines and text"), tr("PDF, lines and text"), tr("PNG, pixels")});
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
  form->addRow(tr("Ground"), m_transparent);
  form->addRow(QString(), m_dark);
  form->addRow(buttons);

  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    emit wanted(wish());
    accept();
  });
  connect(m_view, &QComboBox::currentIndexChanged, this, &PictureDialog::renew);
  connect(m_sized, &QCheckBox::toggled, this, &PictureDialog::renew);
  renew();
}

void PictureDialog::renew() {
  const bool solid = m_view->currentData().toString() == QLatin1String("3d");
  auto* forms = qobject_cast<QStandardItemModel*>(m_form->model());
  for (int i = 0; i < m_form->count(); ++i) {
    const bool possible = !solid || kForms[i] == PictureForm::png;
    forms->item(i)->setEnabled(possible);
    forms->item(i)->setToolTip(possible ? QString() : tr("The 3D view is made of pixels."));
    if (possible && !forms->item(m_form->currentIndex())->isEnabled()) m_form->setCurrentIndex(i);
  }
  if (solid) m_sized->setChecked(true);  // it has no size of its own
  m_sized->setEnabled(!solid);
  m_width->setEnabled(m_sized->isChecked());
  m_height->setEnabled(m_sized->isChecked());
}

PictureWish PictureDialog::wish() const {
  PictureWish wish;
  wish.view = m_view->currentData().toString();
  wish.picture.form = kForms[m_form->currentIndex()];
  wish.picture.look.theme = m_dark->isChecked() ? Theme::dark : Theme::light;
  wish.picture.look.transparent = m_transparent->isChecked();
  if (m_sized->isChecked()) wish.picture.look.size = SheetLook::Size{m_width->value(), m_height->value()};
  return wish;
}

}  // namespace geargraph
