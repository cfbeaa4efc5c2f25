#pragma once

#include <QLineEdit>

#include <set>

#include "ui/panels/property_forms.h"

namespace geargraph {

class TeethSlider;

/// The form for the document: its name.
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
  QLineEdit* m_name = nullptr;  ///< only for a single link, like the following
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
  /// Sets component `index` of the points or directions of the joints' axes.
  void placeAxes(int index, const std::optional<Number>& number, bool ofPoint);
  void addKind();
  void chooseAxis(int item);
  void fillAxes();
  void refreshAxes(const std::vector<const TurningJoint*>& joints);
  void addLimits();
  /// Opens a menu of axisChoices().
  [[nodiscard]] QPushButton* makeLayButton();
  /// Outer std::nullopt: the joints differ; inner: none has a limit.
  static void showLimit(NumberField& field, const std::optional<std::optional<Number>>& limit);

  QComboBox* m_jointKind;
  QComboBox* m_axis;
  TripleField* m_point;
  TripleField* m_direction;
  NumberField* m_offset;
  NumberField* m_low;  ///< limits, degrees or lengths
  NumberField* m_high;
  QWidget* m_limits = nullptr;  ///< both
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
  void addHelixRow();
  void connectHelix();
  /// Shows what only some kinds have where all meshes are of such kinds.
  void refreshHelix(const std::vector<const GearMesh*>& meshes);

  NumberField* m_tailTeeth;
  NumberField* m_headTeeth;
  TeethSlider* m_tailSlider;
  TeethSlider* m_headSlider;
  std::optional<PlacedMechanism> m_slidFrom;  ///< state at the start of a slider drag
  /// Disables the kinds that the joints of the only mesh's links rule out, with the reason.
  void refreshKinds();

  QComboBox* m_kind;
  NumberField* m_module;
  QWidget* m_helixRow;
  NumberField* m_helix;  ///< degrees
  QComboBox* m_hand;
  QCheckBox* m_herringbone;
  QCheckBox* m_crossed;  ///< strands of a belt
  TripleField* m_pitchPoint;
  QLabel* m_ratio;
  QCheckBox* m_pinTail;
  QCheckBox* m_pinHead;
  QCheckBox* m_pinModule;
  QLabel* m_tooMany;  ///< says that there are too many meshes to adapt the rest of the train
};

/// The form for elements that have no property in common: of several kinds, or several axes.
class MixedForm : public PropertyForm {
  Q_OBJECT

 public:
  MixedForm(Document* document, std::vector<ElementId> elements, bool areOfOneKind);
  void refresh() override {}
};

/// Creates the form for the selected elements: links, turning joints, meshes or notes, one axis or coupling;
/// for the document if none is selected; a remark for other selections. The caller owns it.
[[nodiscard]] PropertyForm* makePropertyForm(Document* document, const std::set<ElementId>& selected);

}  // namespace geargraph
