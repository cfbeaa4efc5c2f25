#include "ui/analysis/analysis_service.h"

namespace geargraph::inline ui_analysis {

AnalysisService::AnalysisService(QObject* parent, Ahead ahead)
    : QObject(parent), m_worker([this, ahead = std::move(ahead)](SnapshotPtr snapshot) {
        ahead(snapshot);
        QMetaObject::invokeMethod(
            this, [this, snapshot = std::move(snapshot)] { arrived(snapshot); }, Qt::QueuedConnection);
      }) {}

void AnalysisService::request(const MechanismPtr& mechanism, quint64 revision) {
  if (m_wanted == revision) return;
  m_wanted = revision;
  m_worker.request(mechanism, revision);
}

void AnalysisService::arrived(const SnapshotPtr& snapshot) {
  if (snapshot->revision != m_wanted) return;
  m_snapshot = snapshot;
  emit snapshotReady(snapshot);
}

}  // namespace geargraph::inline ui_analysis
