#include "ui/mainwindow/shapes_dialog.h"

#include <QBoxLayout>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QToolButton>

#include "core/mechanism/model/quantity.h"
#include "core/mechanism/model/shapes.h"

namespace geargraph {
namespace {

constexpr int kFile = 0, kPosition = 1, kOrientation = 4, kScale = 7, kColumns = 8;

QString textOf(const std::optional<NumberTriple>& triple, int axis) {
  return triple ? QString::fromStdString((*triple)[static_cast<std::size_t>(axis)].text())
                : QStringLiteral("0");
}

/// One coordinate changed; all zeros are nothing, which the file leaves out.
std::optional<NumberTriple> with(const std::optional<NumberTriple>& triple, int axis, const Number& number) {
  NumberTriple changed = triple.value_or(NumberTriple{});
  changed[static_cast<std::size_t>(axis)] = number;
  return isZero(changed) ? std::nullopt : std::optional(changed);
}

}  // namespace

ShapesDialog::ShapesDialog(Document* document, LinkId link, QWidget* parent)
    : QDialog(parent),
      m_document(document),
      m_link(link),
      m_table(new QTableWidget(0, kColumns, this)),
      m_remove(new QToolButton(this)) {
  setObjectName(QStringLiteral("shapes"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(780, 240);
  m_table->setHorizontalHeaderLabels({tr("File"), tr("x"), tr("y"), tr("z"), tr("about x, °"),
                                      tr("about y, °"), tr("about z, °"), tr("Scale")});
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  m_table->horizontalHeader()->setSectionResizeMode(kFile, QHeaderView::Stretch);
  m_table->horizontalHeader()->setDefaultSectionSize(80);
  m_table->verticalHeader()->hide();
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  auto* add = new QToolButton(this);
  add->setText(tr("Add…"));
  add->setToolTip(tr("Another STL, OBJ, PLY or GLB file"));
  m_remove->setText(tr("Remove"));
  auto* hint = new QLabel(tr("Lengths in the document's unit. A file is turned about x, then y, then z, and "
                             "moved, in the drawn pose; "
                             "it then moves with its link."),
                          this);
  hint->setWordWrap(true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(add);
  buttons->addWidget(m_remove);
  buttons->addStretch(1);
  auto* whole = new QVBoxLayout(this);
  whole->addWidget(m_table, 1);
  whole->addWidget(hint);
  whole->addLayout(buttons);
  connect(add, &QToolButton::clicked, this, &ShapesDialog::chooseAndAdd);
  connect(m_remove, &QToolButton::clicked, this, &ShapesDialog::removeChosen);
  connect(m_table, &QTableWidget::cellChanged, this, &ShapesDialog::onCell);
  connect(document, &Document::changed, this, &ShapesDialog::renew);
  connect(document, &Document::replaced, this, &QDialog::close);
  renew();
}

std::vector<LinkShape> ShapesDialog::shapes() const {
  const Link* link = m_document->mechanism()->find(m_link);
  return link != nullptr ? link->shapes : std::vector<LinkShape>();
}

void ShapesDialog::renew() {
  const auto label = labelOf(*m_document->mechanism(), m_link);
  if (!label) return void(close());
  setWindowTitle(tr("3D files of link %1").arg(QString::fromStdString(*label)));
  const QSignalBlocker quiet(m_table);
  const std::vector<LinkShape> attached = shapes();
  m_table->setRowCount(static_cast<int>(attached.size()));
  for (int row = 0; const LinkShape& shape : attached) {
    const auto put = [&](int column, const QString& text) {
      auto* item = new QTableWidgetItem(text);
      if (column == kFile) item->setToolTip(text);
      m_table->setItem(row, column, item);
    };
    put(kFile, QString::fromStdString(shape.file));
    for (int axis = 0; axis < 3; ++axis) {
      put(kPosition + axis, textOf(shape.position, axis));
      put(kOrientation + axis, textOf(shape.orientation, axis));
    }
    put(kScale, shape.scale ? QString::fromStdString(shape.scale->text()) : QStringLiteral("1"));
    ++row;
  }
  m_remove->setEnabled(!attached.empty());
}

bool ShapesDialog::apply(const QString& text, const std::vector<LinkShape>& changed) {
  return m_document->apply(
      {text, [link = m_link, changed](const Mechanism& now) { return withShapes(now, link, changed); }, 0});
}

void ShapesDialog::onCell(int row, int column) {
  std::vector<LinkShape> changed = shapes();
  LinkShape& shape = changed[static_cast<std::size_t>(row)];
  const std::string text = m_table->item(row, column)->text().trimmed().toStdString();
  const auto number = typedNumber(text);
  if (column == kFile) {
    shape.file = text;
  } else if (!number) {
    return renew();  // back to what holds
  } else if (column == kScale) {
    shape.scale = number->exact() == Rational(1) ? std::nullopt : number;
  } else if (column >= kOrientation) {
    shape.orientation = with(shape.orientation, column - kOrientation, *number);
  } else {
    shape.position = with(shape.position, column - kPosition, *number);
  }
  if (!apply(tr("Place a 3D file"), changed)) renew();
}

void ShapesDialog::chooseAndAdd() {
  const QString folder = QFileInfo(m_document->filePath()).path();
  const QString path = QFileDialog::getOpenFileName(this, tr("3D file"), folder,
                                                    tr("3D files (*.stl *.obj *.ply *.glb);;All files (*)"));
  if (!path.isEmpty()) add(path);
}

// Without a file of its own, a document has no place that a path could lead from: the edit rejects what is
// left.
bool ShapesDialog::add(const QString& path) {
  QString relative = path;
  if (!m_document->filePath().isEmpty())
    relative = QFileInfo(m_document->filePath()).absoluteDir().relativeFilePath(path);
  std::vector<LinkShape> changed = shapes();
  LinkShape& shape = changed.emplace_back();
  shape.file = relative.toStdString();
  return apply(tr("Wear a 3D file"), changed);
}

void ShapesDialog::removeChosen() {
  std::vector<LinkShape> changed = shapes();
  const int row = m_table->currentRow() < 0 ? static_cast<int>(changed.size()) - 1 : m_table->currentRow();
  changed.erase(changed.begin() + row);
  apply(tr("Take off a 3D file"), changed);
}

}  // namespace geargraph

#include "moc_shapes_dialog.cpp"
