#include "ui/reading/print_dialog.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLocale>
#include <QPageSetupDialog>
#include <QPainter>
#include <QPrintDialog>
#include <QPrinterInfo>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>
#include <array>
#include <utility>

#include "ui/reading/page_preview.h"

namespace geargraph {
namespace {

/// The paper of a country: Letter in those for which CLDR names it, else A4.
QPageSize usualPaper(const QLocale& locale) {
  constexpr std::array kOfLetter = {QLocale::Belize,       QLocale::Canada,      QLocale::Chile,
                                    QLocale::Colombia,     QLocale::CostaRica,   QLocale::ElSalvador,
                                    QLocale::Guatemala,    QLocale::Mexico,      QLocale::Nicaragua,
                                    QLocale::Panama,       QLocale::Philippines, QLocale::PuertoRico,
                                    QLocale::UnitedStates, QLocale::Venezuela};
  const bool isLetter = std::find(kOfLetter.begin(), kOfLetter.end(), locale.territory()) != kOfLetter.end();
  return QPageSize(isLetter ? QPageSize::Letter : QPageSize::A4);
}

/// The derivation of a snapshot, worked out and set when it is first wanted. Used by one thread.
class LazyReport {
 public:
  using Set = std::shared_ptr<const SetReport>;

  explicit LazyReport(SnapshotPtr snapshot) : m_snapshot(std::move(snapshot)) {}

  Set operator()(const std::stop_token& stop) {
    if (m_report) return m_report;
    Report report = derivationReport(m_snapshot, stop);
    if (stop.stop_requested()) return nullptr;
    auto set = std::make_shared<const SetReport>(std::move(report), stop);
    if (stop.stop_requested()) return nullptr;
    return m_report = std::move(set);
  }

 private:
  SnapshotPtr m_snapshot;
  Set m_report;
};

}  // namespace

PrintDialog::PrintDialog(PrintSource source, QWidget* parent)
    : QDialog(parent),
      m_source(std::move(source)),
      m_printer(std::make_shared<QPrinter>(QPrinter::HighResolution)),
      m_pages(new Pages(
          [report = std::make_shared<LazyReport>(m_source.snapshot), title = m_source.title](
              const Request& request, const Pages::Responder& respond) {
            const auto derivation = request.withDerivation ? (*report)(respond.stop()) : nullptr;
            respond(std::make_shared<const PrintedPages>(title, request.drawings, derivation, request.paper,
                                                         request.font, respond.stop()));
          },
          this)),
      m_preview(new PagePreview(this)) {
  setObjectName(QStringLiteral("printDialog"));
  setWindowTitle(tr("Print"));
  setAttribute(Qt::WA_DeleteOnClose);
  m_printer->setDocName(m_source.title);
  if (QPrinterInfo::defaultPrinter().isNull())
    m_printer->setPageSize(usualPaper(QLocale()));  // a printer has its own
  auto* right = new QVBoxLayout;
  right->addWidget(m_preview, 1);
  right->addWidget(makePageField());
  auto* all = new QHBoxLayout(this);
  all->addWidget(makeChoices());
  all->addLayout(right, 1);
  m_pages->onAnswer(this, [this](const PrintedPagesPtr& pages) { showPages(pages); });
  request();
}

QWidget* PrintDialog::makeChoices() {
  auto* side = new QWidget(this);
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* group = new QGroupBox(tr("What"), side);
  auto* list = new QVBoxLayout(group);
  for (std::size_t i = 0; i < m_source.drawings.size(); ++i) {
    auto* box = new QCheckBox(m_source.drawings[i].title, group);
    box->setObjectName(QStringLiteral("print%1").arg(i));
    box->setToolTip(tr("The drawing on a page of its own"));
    box->setChecked(i == m_source.inFront);
    connect(box, &QCheckBox::toggled, this, &PrintDialog::request);
    list->addWidget(box);
    m_drawings.push_back(box);
  }
  m_derivation = new QCheckBox(tr("Derivation with its matrices"), group);
  m_derivation->setObjectName(QStringLiteral("printDerivation"));
  m_derivation->setEnabled(m_source.snapshot != nullptr);
  m_derivation->setToolTip(m_source.snapshot ? tr("Both methods worked out step by step")
                                             : m_source.whyNoDerivation);
  connect(m_derivation, &QCheckBox::toggled, this, &PrintDialog::request);
  list->addWidget(m_derivation);
  layout->addWidget(group);
  layout->addStretch(1);
  auto* setUp = new QPushButton(tr("Page setup…"), side);
  setUp->setToolTip(tr("Size and orientation of the paper"));
  connect(setUp, &QPushButton::clicked, this, &PrintDialog::setUpPage);
  m_print = new QPushButton(tr("Print…"), side);
  m_print->setObjectName(QStringLiteral("printNow"));
  m_print->setToolTip(tr("Choose a printer, or a PDF file"));
  m_print->setDefault(true);
  connect(m_print, &QPushButton::clicked, this, &PrintDialog::choosePrinter);
  auto* close = new QPushButton(tr("Close"), side);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  for (QPushButton* button : {setUp, m_print, close}) layout->addWidget(button);
  return side;
}

QWidget* PrintDialog::makePageField() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(tr("Page"), row);
  m_page = new QSpinBox(row);
  m_page->setObjectName(QStringLiteral("printPage"));
  m_page->setAccessibleName(tr("Page"));
  m_page->setToolTip(tr("The page that is shown"));
  label->setBuddy(m_page);
  layout->addStretch(1);
  layout->addWidget(label);
  layout->addWidget(m_page);
  layout->addStretch(1);
  connect(m_page, &QSpinBox::valueChanged, m_preview, [this](int page) { m_preview->setPage(page - 1); });
  connect(m_preview, &PagePreview::pageChanged, m_page, [this](int page) { m_page->setValue(page + 1); });
  return row;
}

void PrintDialog::request() {
  Request wanted;
  for (std::size_t i = 0; i < m_drawings.size(); ++i) {
    if (m_drawings[i]->isChecked()) wanted.drawings.push_back(m_source.drawings[i]);
  }
  wanted.withDerivation = m_derivation->isChecked();
  wanted.paper = m_printer->pageLayout().fullRectPoints().size();
  wanted.font = font();
  m_print->setEnabled(false);
  m_pages->request(std::move(wanted));
}

void PrintDialog::showPages(const PrintedPagesPtr& pages) {
  m_page->setRange(1, std::max(1, pages->count()));
  m_page->setSuffix(tr(" of %1").arg(pages->count()));
  m_preview->setPages(pages, tr("Nothing is chosen."));
  m_print->setEnabled(pages->count() > 0);
}

void PrintDialog::setUpPage() {
  // Qt's dialog is for printers only: without one, and for a PDF file, it does not open.
  if (m_printer->outputFormat() != QPrinter::NativeFormat) return choosePaper();
  auto* dialog = new QPageSetupDialog(m_printer.get(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, &PrintDialog::request);
  dialog->open();
}

void PrintDialog::choosePaper() {
  auto* dialog = new QDialog(this);
  dialog->setObjectName(QStringLiteral("paperDialog"));
  dialog->setWindowTitle(tr("Page setup"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  const QPageLayout now = m_printer->pageLayout();
  auto* paper = new QComboBox(dialog);
  paper->setObjectName(QStringLiteral("paper"));
  for (const auto size :
       {QPageSize::A3, QPageSize::A4, QPageSize::A5, QPageSize::Letter, QPageSize::Legal, QPageSize::Tabloid})
    paper->addItem(QPageSize::name(size), size);
  paper->setCurrentIndex(std::max(0, paper->findData(now.pageSize().id())));
  auto* orientation = new QComboBox(dialog);
  orientation->setObjectName(QStringLiteral("orientation"));
  orientation->addItem(tr("Portrait"), QPageLayout::Portrait);
  orientation->addItem(tr("Landscape"), QPageLayout::Landscape);
  orientation->setCurrentIndex(orientation->findData(now.orientation()));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, dialog);
  connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* form = new QFormLayout(dialog);
  form->addRow(tr("Paper:"), paper);
  form->addRow(tr("Orientation:"), orientation);
  form->addRow(buttons);
  connect(dialog, &QDialog::accepted, this, [this, paper, orientation] {
    m_printer->setPageSize(QPageSize(paper->currentData().value<QPageSize::PageSizeId>()));
    m_printer->setPageOrientation(orientation->currentData().value<QPageLayout::Orientation>());
    request();
  });
  dialog->open();
}

void PrintDialog::choosePrinter() {
  auto* dialog = new QPrintDialog(m_printer.get(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setMinMax(1, pages()->count());
  dialog->setFromTo(1, pages()->count());
  connect(dialog, &QDialog::accepted, this, [this] {
    emit printWanted(pages(), m_printer);
    close();
  });
  dialog->open();
}

QString PrintDialog::print(const PrintedPages& pages, QPrinter& printer, const std::stop_token& stop) {
  printer.setFullPage(true);
  const int first = printer.fromPage() > 0 ? printer.fromPage() - 1 : 0;
  const int end = printer.toPage() > 0 ? std::min(printer.toPage(), pages.count()) : pages.count();
  QPainter painter;
  if (first >= end) return tr("There is no such page to print.");
  if (!painter.begin(&printer)) return tr("The printer could not be opened.");
  FlowPainter flow;
  const double scale = printer.resolution() / 72.0;
  for (int page = first; page < end && !stop.stop_requested(); ++page) {
    if (page > first && !printer.newPage()) return tr("The printer stopped at page %1.").arg(page + 1);
    pages.paint(painter, page, scale, flow);
  }
  if (stop.stop_requested()) {
    printer.abort();
    return tr("Printing was stopped.");
  }
  return painter.end() ? QString() : tr("The printer reported an error.");
}

}  // namespace geargraph

#include "moc_print_dialog.cpp"
