#pragma once

#include <QStringList>
#include <QWidget>
#include <functional>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

class QComboBox;
class QFormLayout;
class QTableWidget;

namespace geargraph {

class NumberField;

/// A form for one kind of gear set: the user's parameters, and the set that they give.
class SetForm : public QWidget {
  Q_OBJECT

 public:
  explicit SetForm(QWidget* parent = nullptr);

  /// The set, or why the parameters give none.
  [[nodiscard]] virtual Expected<Mechanism> set() const = 0;

 signals:
  void changed();

 protected:
  NumberField* addWhole(const QString& label, const char* name, int value, int least, int most);
  [[nodiscard]] static int wholeOf(const NumberField* field);
  [[nodiscard]] QFormLayout& form() { return *m_form; }

 private:
  QFormLayout* m_form;
};

/// A form for sets with given numbers of teeth.
class TeethForm : public SetForm {
  Q_OBJECT

 public:
  struct Count {
    QString label;
    const char* name;
    int value;
    int least = 4;
    int most = 400;
  };
  using Make = std::function<Expected<Mechanism>(const std::vector<int>&)>;

  TeethForm(const std::vector<Count>& counts, Make make, QWidget* parent = nullptr);
  [[nodiscard]] Expected<Mechanism> set() const override;

 private:
  std::vector<NumberField*> m_fields;
  Make m_make;
};

/// A form for drives that are given by lengths, and by a hand where they have one.
class LengthsForm : public SetForm {
  Q_OBJECT

 public:
  struct Length {
    QString label;
    const char* name;
    Number value;
  };
  using Make = std::function<Expected<Mechanism>(const std::vector<Number>&, Hand)>;

  LengthsForm(const std::vector<Length>& lengths, bool hasHand, Make make, QWidget* parent = nullptr);
  [[nodiscard]] Expected<Mechanism> set() const override;

 private:
  std::vector<NumberField*> m_fields;
  QComboBox* m_hand = nullptr;
  Make m_make;
};

/// A form for sets with a required ratio: lists the best numbers of teeth, of which the user chooses one.
class ChoiceForm : public SetForm {
  Q_OBJECT

 public:
  [[nodiscard]] Expected<Mechanism> set() const override;

 protected:
  struct Choice {
    QStringList teeth;
    Rational ratio;
    double error = 0;
    std::function<Mechanism()> make;
  };

  ChoiceForm(const QStringList& teethHeads, const Rational& ratio, QWidget* parent);
  [[nodiscard]] virtual std::vector<Choice> choices(const Rational& ratio) const = 0;
  /// Lists the choices again. To be called once the form is complete, and when a requirement changes.
  void renew();
  void addTable();

 private:
  NumberField* m_ratio;
  QTableWidget* m_table;
  std::vector<Choice> m_choices;
};

class PlanetaryForm : public ChoiceForm {
  Q_OBJECT

 public:
  explicit PlanetaryForm(QWidget* parent = nullptr);

 protected:
  [[nodiscard]] std::vector<Choice> choices(const Rational& ratio) const override;

 private:
  QComboBox* m_use;
  QComboBox* m_held;
  NumberField* m_planets;
  NumberField* m_fewest;
  NumberField* m_most;
};

class RevertedForm : public ChoiceForm {
  Q_OBJECT

 public:
  explicit RevertedForm(QWidget* parent = nullptr);

 protected:
  [[nodiscard]] std::vector<Choice> choices(const Rational& ratio) const override;

 private:
  NumberField* m_fewest;
  NumberField* m_most;
};

}  // namespace geargraph
