#pragma once

#include <QWidget>
#include <set>

#include "ui/atlas_panel/chain_preview.h"
#include "ui/atlas_panel/train_identification.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace geargraph {

class ChainPicture;
class TrainDetails;

/// What a train is made of, as sentences in which chains are links "chain:6-1.5.1".
[[nodiscard]] QString trainText(const TrainAnswer& answer);

/// Beside the grid: what the train is, and one chain with its picture and its relatives.
class ChainCard final : public QWidget {
  Q_OBJECT

 public:
  explicit ChainCard(QWidget* parent = nullptr);

  /// Null while the first answer is awaited.
  void setTrain(const TrainAnswerPtr& train);
  /// Null: no chain is chosen, or its relatives are awaited.
  void setChain(const AtlasChain* chain, const ChainDetailsPtr& details);
  [[nodiscard]] const AtlasChain* chain() const { return m_chain; }
  void setOpening(bool isOpening);
  /// What previewWanted() asked for; others are ignored.
  void setPreview(const ChainPreviewPtr& preview);
  [[nodiscard]] TrainDetails& trainDetails() { return *m_trainDetails; }

 signals:
  void previewWanted(const geargraph::ChainPreviewRequest& request);
  void chainWanted(const geargraph::ChainNumber& number);
  void openWanted();
  /// Links and gear pairs of the train that are the chosen chain.
  void showWanted(const std::set<geargraph::ElementId>& elements);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] QWidget* makeViews();
  void setView(ChainView view);
  [[nodiscard]] ChainPreviewRequest preview() const;
  void renew();
  void showPicture();
  void showDigraph();
  void follow(const QString& link);
  [[nodiscard]] const IdentifiedChain* ownPart() const;
  void showOwn();

  TrainAnswerPtr m_train;
  const AtlasChain* m_chain = nullptr;
  ChainDetailsPtr m_details;
  ChainPreviewPtr m_preview;
  ChainView m_view = ChainView::digraph;
  QLabel* m_trainText;
  QLabel* m_title;
  QLabel* m_facts;
  QWidget* m_views;
  ChainPicture* m_picture;
  QLabel* m_reason;
  QLabel* m_relatives;
  QPushButton* m_open;
  QPushButton* m_show;
  QPushButton* m_copy;
  TrainDetails* m_trainDetails;
};

}  // namespace geargraph
