#pragma once

#include <QDialog>
#include <functional>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace geargraph {

class SetForm;
class SetPreview;

/// A kind of gear set that can be inserted.
struct InsertableSet {
  const char* id = "";  ///< "planetary": never changed, never translated
  QString name = {};
  SetForm* (*makeForm)() = nullptr;
  std::function<Expected<Mechanism>()> usual = {};  ///< a set of this kind, for its picture
};
/// All kinds, the most common first. Texts are in the language in use.
[[nodiscard]] std::vector<InsertableSet> insertableSets();

/// Inserts a complete gear set: choose a kind, enter the requirements, see the preview, insert. Not modal.
class InsertSetDialog : public QDialog {
  Q_OBJECT

 public:
  explicit InsertSetDialog(QWidget* parent = nullptr);

  /// Shows the form of this kind (InsertableSet::id).
  void choose(const QString& kind);

 signals:
  void insertWanted(const geargraph::Mechanism& set);
  /// A whole gearbox is wanted instead: the gearbox designer.
  void designWanted();

 private:
 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void addKind(const InsertableSet& kind);
  void paintKinds();
  void renew();
  [[nodiscard]] const SetForm& form() const;

  std::vector<InsertableSet> m_known;
  QListWidget* m_kinds;
  QStackedWidget* m_forms;
  SetPreview* m_preview;
  QLabel* m_summary;
  QPushButton* m_insert;
};

}  // namespace geargraph
