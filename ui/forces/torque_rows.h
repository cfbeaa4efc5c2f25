#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/statics/forces_service.h"

class QGridLayout;
class QLabel;

namespace geargraph::inline forces {

/// Between the inputs and the results of a document with loads, a row each: the torque of a load (a number to
/// type or spin, and a button that removes it), the torques that were found, and the links that brakes and
/// clutches hold. What the document itself holds (a balance of its own, an engaged coupling) has a button
/// that lets it go. A click on a row's name selects what it is about.
class TorqueRows : public QWidget {
  Q_OBJECT

 public:
  TorqueRows(Document* document, Selection* selection, ForcesService* service, QWidget* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Kind { load, found, held };
  /// What a row says.
  struct Content {
    Kind kind = Kind::found;
    int load = -1;  ///< its position in the document
    ElementId element;
    int link = -1;  ///< label, for its colour
    QString name;
    QString tip;
    std::optional<Number> torque;  ///< of a load
    QString value;                 ///< else
    QString exact;                 ///< the value as a fraction; empty: it is one already, or none
    bool isOwn = false;            ///< the document holds it, and can let it go
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

}  // namespace geargraph::inline forces
