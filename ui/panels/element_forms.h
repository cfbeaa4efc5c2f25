#pragma once

#include <QLineEdit>

#include <set>

#include "ui/panels/property_forms.h"

namespace geargraph::inline panels {

class TeethSlider;

/// The document's own name.
class DocumentForm : public PropertyForm {
  Q_OBJECT

 public:
  explicit DocumentForm(Document* document);
  void refresh() override;

 private:
  void setDocumentName(const QString& name);

  Document* m_owner;
  QLineEdit* m_name;
  quint64 m_nameGesture = 0;
};

class LinkForm : public PropertyForm {
  Q_OBJECT

 public:
  LinkForm(Document* document, std::vector<ElementId> links);
  void refresh() override;

 private:
  QLabel* addParts(const QString& name, Term term);
  static void showParts(QLabel& parts, const QString& text);

  QLineEdit* m_name = nullptr;  ///< for one link, as what follows
  QLabel* m_joints = nullptr;
  QLabel* m_gears = nullptr;
  QLabel* m_couplings = nullptr;
  QPushButton* m_ground = nullptr;
  QCheckBox* m_pin;
};

class JointForm : public PropertyForm {
  Q_OBJECT

 public:
  JointForm(Document* document, std::vector<ElementId> joints);
  void refresh() override;

 private:
  [[nodiscard]] std::vector<const TurningJoint*> joints() const;
  /// Component `index` of the points, or directions, of the joints' axes.
  void placeAxes(int index, const std::optional<Number>& number, bool ofPoint);
  void chooseAxis(int item);
  void fillAxes();
  void refreshAxes(const std::vector<const TurningJoint*>& joints);
  void addLimits();
  /// Opens a menu of the ways in which the axes may lie.
  [[nodiscard]] QPushButton* makeLayButton();
  /// No value: the joints differ; no number in it: none has a limit.
  static void showLimit(NumberField& field, const std::optional<std::optional<Number>>& limit);

  QComboBox* m_axis;
  TripleField* m_point;
  TripleField* m_direction;
  NumberField* m_offset;
  NumberField* m_low;  ///< limits, degrees
  NumberField* m_high;
  QCheckBox* m_pin;
};

class MeshForm : public PropertyForm {
  Q_OBJECT

 public:
  MeshForm(Document* document, std::vector<ElementId> meshes);
  void refresh() override;

 private:
  [[nodiscard]] std::vector<const GearMesh*> meshes() const;
  void addTeethRow(const QString& name, NumberField* field, TeethSlider* slider);
  void connectTeeth();
  void slideTeeth(bool ofTail, int teeth);
  void refreshGeometry(const std::vector<const GearMesh*>& meshes);

  NumberField* m_tailTeeth;
  NumberField* m_headTeeth;
  TeethSlider* m_tailSlider;
  TeethSlider* m_headSlider;
  std::optional<PlacedMechanism> m_slidFrom;  ///< what the drag of a slider began with
  QComboBox* m_kind;
  NumberField* m_module;
  TripleField* m_pitchPoint;
  QLabel* m_ratio;
  QCheckBox* m_pinTail;
  QCheckBox* m_pinHead;
  QCheckBox* m_pinModule;
  QLabel* m_tooMany;  ///< meshes for the rest of the train to follow
};

/// Elements of several kinds: there is nothing that all of them have.
class MixedForm : public PropertyForm {
  Q_OBJECT

 public:
  MixedForm(Document* document, std::vector<ElementId> elements);
  void refresh() override {}
};

/// The form for what is selected: links, turning joints or meshes; the document where nothing is; a note
/// where it is of several kinds. The caller owns it.
[[nodiscard]] PropertyForm* makePropertyForm(Document* document, const std::set<ElementId>& selected);

}  // namespace geargraph::inline panels
