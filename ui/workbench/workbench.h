#pragma once

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/workbench/analysis_service.h"
#include "ui/workbench/forces_service.h"
#include "ui/workbench/measuring.h"
#include "ui/workbench/motion_check_service.h"
#include "ui/workbench/scene_service.h"

namespace geargraph {

/// The objects that the views of a window share: the document, the selection, and the services that follow
/// the document. An edit changes the document, the document is analysed, and each snapshot is passed to the
/// stage, to the statics and, once complete, to the motion check; the views receive the answers.
class Workbench final : public QObject {
  Q_OBJECT

 public:
  explicit Workbench(QObject* parent = nullptr);
  /// Takes over the document with its undo history and the selection from the workbench of a window that is
  /// being rebuilt; derived data is computed again. `former` no longer follows the document, and must be
  /// destroyed before this object.
  Workbench(Workbench& former, QObject* parent);
  ~Workbench() override;

  [[nodiscard]] Document& document() { return *m_document; }
  [[nodiscard]] Selection& selection() { return *m_selection; }
  [[nodiscard]] Measuring& measuring() { return *m_measuring; }
  [[nodiscard]] AnalysisService& analysis() { return *m_analysis; }
  [[nodiscard]] SceneService& stages() { return *m_stages; }
  [[nodiscard]] ForcesService& forces() { return *m_forces; }
  [[nodiscard]] MotionCheckService& motionCheck() { return *m_motionCheck; }

  /// Requests all answers for the current document; happens automatically with every change of the document.
  void request();
  /// Have all requests been answered?
  [[nodiscard]] bool isUpToDate() const;

 private:
  Workbench(Document* document, Selection* selection, QObject* parent);

  Document* m_document;
  Selection* m_selection;
  Measuring* m_measuring;
  AnalysisService* m_analysis;
  SceneService* m_stages;
  ForcesService* m_forces;
  MotionCheckService* m_motionCheck;
};

}  // namespace geargraph
