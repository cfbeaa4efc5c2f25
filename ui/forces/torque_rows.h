#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/workbench/forces_service.h"

class QGridLayout;
class QLabel;

namespace geargraph {

/// The torque rows between the inputs and the results of a document with loads: the torque of each load (an
/// editable number and a button for removal), the torques found, and those of brakes and clutches. Balances
/// and engaged couplings stated in the document have a button that releases them. A click on a row's name
/// selects its element.
class TorqueRows : public QWidget {
  Q_OBJECT

 public:
  TorqueRows(Document* document, Selection* selection, ForcesService* service, QWidget* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Kind { load, found, held };
  /// The content of a row.
  struct Content {
    Kind kind = Kind::found;
    int load = -1;  ///< its position in the document
    ElementId element;
    int link = -1;  ///< label
    int color = 0;  ///< the number of its colour
    QString name;
    QString tip;
    std::optional<Number> torque;  ///< of a load
    QString value;                 ///< else
    QString exact;                 ///< the value as a fraction; empty: it is one already, or none
    bool isOwn = false;            ///< stated in the document, so that it can be released
    [[nodiscard]] bool hasSameRow(const Content& other) const {
      return kind == other.kind && load == other.load && element == other.element && name == other.name &&
             link == other.link && tip == other.tip && isOwn == other.isOwn;
    }
  };
  struct Row {
    Content content;
    std::vector<QWidget*> widgets;
    QWidget* field = nullptr;  ///< of a load
    QLabel* value = nullptr;   ///< else
  };

  void renew();
  [[nodiscard]] std::vector<Content> contents() const;
  void addLoads(std::vector<Content>& rows) const;
  void addFound(std::vector<Content>& rows) const;
  [[nodiscard]] Content contentOf(const HeldPart& part, const Real& torque, bool isKnown) const;
  Row makeRow(const Content& content, int line);
  QWidget* makeField(const Content& content);
  QWidget* makeLetGo(const Content& content, int line);
  void showNumber(Row& row, const Content& content);
  void clear();

  Document* m_document;
  Selection* m_selection;
  ForcesService* m_service;
  QGridLayout* m_grid;
  QLabel* m_more;
  std::vector<Row> m_rows;
  quint64 m_gesture = 0;
};

}  // namespace geargraph
