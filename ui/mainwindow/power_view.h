#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <vector>

#include "core/presentation/diagrams/power_picture.h"
#include "ui/canvas/drawing_view.h"
#include "ui/service/service.h"
#include "ui/workbench/workbench.h"

class QMenu;

namespace geargraph {

/// Shows the torques of loads and balances under the drawings and, if switched on, the power flow as bands,
/// seen from the ground or another link. They are made on background threads, and follow loads, motion and
/// drawing.
class PowerView : public QObject {
  Q_OBJECT

 public:
  PowerView(Workbench& workbench, std::vector<DrawingView*> drawings, QObject* parent = nullptr);
  ~PowerView() override;

  void setOn(bool on);
  /// Sets the observer of the power flow; an empty id: the ground.
  void setObserver(LinkId observer);
  [[nodiscard]] LinkId observer() const { return m_observer; }
  /// Adds entries for the ground and all links.
  void fillObservers(QMenu& menu);
  /// Why there is no power to show, as a sentence; empty if there is some.
  [[nodiscard]] QString unavailableReason() const;
  [[nodiscard]] bool isSettled() const;

  /// The power flow as this observer sees it. Takes long for large trains; safe on any thread.
  [[nodiscard]] static PowerPicture pictureOf(const Forces& forces, LinkId observer);

 signals:
  void shown();  ///< the marks under a drawing have changed

 private:
  struct Request {
    ForcesPtr forces;
    bool showsPower;
    LinkId observer;
    DrawingView::PowerDraw draw;
  };
  struct Answer {
    DisplayList list;
    std::map<ElementId, QString> tips;  ///< tooltips of the balances
  };
  using Bands = Service<Request, std::shared_ptr<const Answer>>;
  struct Drawing {
    DrawingView* view;
    Bands* bands;
  };

  static void draw(const Request& request, const Bands::Responder& respond);
  void renew();
  void renew(const Drawing& drawing);

  Workbench& m_workbench;
  std::vector<Drawing> m_drawings;
  LinkId m_observer;
  bool m_isOn = false;
};

}  // namespace geargraph
