#pragma once

#include <QAbstractListModel>
#include <QImage>
#include <QListView>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/presentation/drawing/palette.h"
#include "ui/atlas_panel/chain_catalogue.h"

namespace geargraph {

/// Some chains of an atlas as a list. The pictures of chains are drawn by the thread pool when they are asked
/// for, and kept.
class ChainListModel final : public QAbstractListModel {
  Q_OBJECT

 public:
  using QAbstractListModel::QAbstractListModel;

  /// px of a picture, without the scale of the screen.
  static constexpr QSize kPicture{84, 76};

  /// @param chains of an atlas that outlives the model
  void setChains(std::vector<const AtlasChain*> chains);
  [[nodiscard]] const std::vector<const AtlasChain*>& chains() const { return m_chains; }
  [[nodiscard]] const AtlasChain* chainAt(const QModelIndex& index) const;
  /// Invalid if it is not in the list.
  [[nodiscard]] QModelIndex indexOf(const AtlasChain* chain) const;
  /// Those that the train is made of.
  void setOwn(std::set<const AtlasChain*> own);
  [[nodiscard]] bool isOwn(const AtlasChain* chain) const { return m_own.count(chain) > 0; }

  /// The picture of a chain; null until it is drawn, when dataChanged() is emitted.
  [[nodiscard]] QImage picture(const AtlasChain* chain, Theme theme, qreal devicePixelRatio);
  /// Pictures that are being drawn.
  [[nodiscard]] bool isDrawing() const { return !m_waiting.empty(); }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 signals:
  /// Every picture that was asked for has been drawn.
  void drawn();

 private:
  struct Look {
    Theme theme = Theme::light;
    qreal ratio = 1;
    friend bool operator==(const Look&, const Look&) = default;
  };
  void take(const AtlasChain* chain, const Look& look, const QImage& image);

  std::vector<const AtlasChain*> m_chains;
  std::set<const AtlasChain*> m_own;
  Look m_look;  ///< of the pictures
  std::map<const AtlasChain*, QImage> m_pictures;
  std::set<const AtlasChain*> m_waiting;
};

/// The chains as cells with picture and number. Arrow keys walk, Return opens.
class ChainGrid final : public QListView {
  Q_OBJECT

 public:
  explicit ChainGrid(ChainListModel* model, QWidget* parent = nullptr);

  [[nodiscard]] const AtlasChain* current() const;
  /// Selects a chain and scrolls to it; does nothing if it is not in the list.
  void setCurrent(const AtlasChain* chain);

 signals:
  void chosen(const geargraph::AtlasChain* chain);
  /// Return, or a double click.
  void openWanted(const geargraph::AtlasChain* chain);
  /// The key / was pressed.
  void findWanted();

 protected:
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  ChainListModel* m_chains;
};

}  // namespace geargraph
