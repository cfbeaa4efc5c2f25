#include "ui/workbench/workbench.h"

#include <QFile>
#include <QFileInfo>

namespace geargraph {
namespace {

/// Where the document's own files are; empty while it has no file.
std::filesystem::path folderOf(const Document& document) {
  if (document.filePath().isEmpty()) return {};
  return QFile::encodeName(QFileInfo(document.filePath()).absolutePath()).toStdString();
}

}  // namespace

Workbench::Workbench(QObject* parent) : Workbench(new Document, new Selection, parent) {}

Workbench::Workbench(Workbench& former, QObject* parent)
    : Workbench(former.m_document, former.m_selection, parent) {
  disconnect(m_document, nullptr, &former, nullptr);
}

Workbench::Workbench(Document* document, Selection* selection, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_selection(selection),
      m_measuring(new Measuring(document, this)),
      m_analysis(new AnalysisService(
          this, [this](const SnapshotPtr& snapshot) { m_stages->requestScene(snapshot); })),
      m_stages(new SceneService(this)),
      m_forces(new ForcesService(this)),
      m_motionCheck(new MotionCheckService(this)) {
  m_document->setParent(this);
  m_selection->setParent(this);
  m_selection->setExists(
      [document](const ElementId& element) { return document->elements().contains(element); });
  connect(m_document, &Document::changed, this, &Workbench::request);  // before the views hear of it
  m_analysis->onAnswer(this, [this](const SnapshotPtr& snapshot) {
    m_forces->follow(snapshot);
    if (snapshot->isComplete) m_motionCheck->requestCheck(snapshot);
  });
}

/// The analysis calls the stages from its own thread, through this object: it ends while both are whole.
Workbench::~Workbench() {
  delete m_analysis;
}

void Workbench::request() {
  m_stages->setFolder(folderOf(*m_document));
  m_analysis->request({m_document->geometry(), m_document->mechanicsRevision()});
}

bool Workbench::isUpToDate() const {
  return m_analysis->isComplete() && m_stages->isUpToDate() && m_forces->isComplete() &&
         m_motionCheck->isUpToDate();
}

}  // namespace geargraph

#include "moc_workbench.cpp"
