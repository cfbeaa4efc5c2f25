#include "ui/atlas_panel/chain_card.h"

#include <QApplication>
#include <QButtonGroup>
#include <QClipboard>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/atlas_panel/chain_picture.h"
#include "ui/atlas_panel/train_details.h"
#include "ui/models/term_tips.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

const QString kChainLink = QStringLiteral("chain:");

QString shownNumber(const ChainNumber& number) {
  return QString::fromStdString(number.toString());
}

QString chainLink(const ChainNumber& number) {
  return QStringLiteral("<a href=\"%1%2\">%2</a>").arg(kChainLink, shownNumber(number));
}

QString chainLinks(const std::vector<ChainNumber>& numbers) {
  if (numbers.empty()) return ChainCard::tr("none");
  QStringList links;
  for (const ChainNumber& number : numbers) links << chainLink(number);
  return links.join(QLatin1Char(' '));
}

QString listedLabels(const std::vector<int>& labels) {
  QStringList list;
  for (const int label : labels) list << QString::number(label);
  return list.join(QStringLiteral(", "));
}

QString partName(const IdentifiedChain& part) {
  QString name = part.displacement
                     ? chainLink(*part.displacement)
                     : ChainCard::tr("one of %1 links that is not in the atlas").arg(part.links.size());
  if (part.isLocked) name += QLatin1Char(' ') + ChainCard::tr("(cannot turn)");
  if (part.turnsByTeeth) name += QLatin1Char(' ') + ChainCard::tr("(turns by these tooth counts only)");
  return name;
}

/// Which links were left out, and why; brakes and clutches are no part of a chain.
QString removalText(const TrainAnswer& answer) {
  std::vector<int> copies, bearers;
  for (const RemovedLink& removed : answer.identity->removed)
    (removed.why == RemovalReason::copy ? copies : bearers)
        .push_back(answer.mechanism->linkLabel(removed.link));
  QStringList out;
  if (!bearers.empty()) out << ChainCard::tr("in no gear pair: %1").arg(listedLabels(bearers));
  if (!copies.empty()) out << ChainCard::tr("planets that repeat another: %1").arg(listedLabels(copies));
  if (!answer.mechanism->couplings.empty()) out << ChainCard::tr("brakes and clutches");
  return out.isEmpty()
             ? QString()
             : QStringLiteral("<br>") + ChainCard::tr("Left out: %1").arg(out.join(QStringLiteral("; ")));
}

QLabel* wrappingLabel(const QString& name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::RichText);
  label->setTextInteractionFlags(Qt::TextBrowserInteraction);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  return label;
}

}  // namespace

QString trainText(const TrainAnswer& answer) {
  if (answer.isTooLarge)
    return ChainCard::tr("Trains of more than %1 links are not identified.").arg(kMaxIdentifiedLinks);
  if (!answer.why.empty())
    return ChainCard::tr("Your train is unfinished: %1")
        .arg(shownText(answer.why.front().message).toHtmlEscaped());
  if (!answer.identity || answer.identity->parts.empty())
    return ChainCard::tr("Your train has no gear pair yet.");
  QStringList parts;
  for (const IdentifiedChain& part : answer.identity->parts) parts << partName(part);
  const QString text = parts.size() == 1 ? ChainCard::tr("Your train is %1").arg(parts.front())
                                         : ChainCard::tr("Your train is %1 chains: %2")
                                               .arg(parts.size())
                                               .arg(parts.join(QStringLiteral(", ")));
  return QStringLiteral("<b>%1</b>").arg(text) + removalText(answer);
}

ChainCard::ChainCard(QWidget* parent)
    : QWidget(parent),
      m_trainText(wrappingLabel(QStringLiteral("train"), this)),
      m_title(new QLabel(this)),
      m_facts(wrappingLabel(QStringLiteral("facts"), this)),
      m_views(makeViews()),
      m_picture(new ChainPicture(this)),
      m_reason(wrappingLabel(QStringLiteral("reason"), this)),
      m_relatives(wrappingLabel(QStringLiteral("relatives"), this)),
      m_open(new QPushButton(tr("Open as document"), this)),
      m_show(new QPushButton(tr("Show in my train"), this)),
      m_copy(new QPushButton(tr("Copy number"), this)),
      m_trainDetails(new TrainDetails(this)) {
  m_title->setObjectName(QStringLiteral("chainTitle"));
  m_title->setProperty("look", "heading");
  m_facts->setProperty("look", "hint");
  m_reason->setProperty("look", "problem");
  m_open->setObjectName(QStringLiteral("openChain"));
  m_show->setObjectName(QStringLiteral("showChain"));
  m_show->setToolTip(tr("Select the links and gear pairs of your train that are this chain"));
  m_copy->setObjectName(QStringLiteral("copyNumber"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(6);
  layout->addWidget(m_trainText);
  layout->addSpacing(4);
  layout->addWidget(m_title);
  layout->addWidget(m_facts);
  layout->addWidget(m_views);
  layout->addWidget(m_picture, 1);
  layout->addWidget(m_reason);
  layout->addWidget(m_relatives);
  for (QPushButton* button : {m_open, m_show, m_copy}) layout->addWidget(button);
  layout->addSpacing(4);
  layout->addWidget(m_trainDetails);

  for (const QLabel* label : {m_trainText, m_relatives})
    connect(label, &QLabel::linkActivated, this, &ChainCard::follow);
  connect(m_open, &QPushButton::clicked, this, &ChainCard::openWanted);
  connect(m_show, &QPushButton::clicked, this, &ChainCard::showOwn);
  connect(m_copy, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(shownNumber(m_chain->number)); });
  connect(m_trainDetails, &TrainDetails::showWanted, this, &ChainCard::showWanted);
  renew();
}

QWidget* ChainCard::makeViews() {
  auto* views = new QWidget(this);
  auto* row = new QHBoxLayout(views);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  auto* group = new QButtonGroup(views);
  const std::tuple<ChainView, QString, QString> all[] = {
      {ChainView::digraph, QStringLiteral("chainDigraph"), tr("Digraph")},
      {ChainView::schematic, QStringLiteral("chainSchematic"), tr("Schematic")},
      {ChainView::space, QStringLiteral("chainInSpace"), tr("3D")}};
  for (const auto& [view, name, text] : all) {
    auto* chip = new QToolButton(views);
    chip->setObjectName(name);
    chip->setText(text);
    chip->setProperty("look", "chip");
    chip->setCheckable(true);
    chip->setChecked(view == m_view);
    group->addButton(chip);
    row->addWidget(chip);
    connect(chip, &QToolButton::clicked, this, [this, which = view] { setView(which); });
  }
  row->addStretch(1);
  return views;
}

void ChainCard::setView(ChainView view) {
  m_view = view;
  if (m_chain != nullptr) showPicture();
}

/// The document of the chain has its own numbers, whose ever it is.
ChainPreviewRequest ChainCard::preview() const {
  return {m_chain, m_view, m_view == ChainView::space ? themeOf(palette()) : Theme::light};
}

void ChainCard::setPreview(const ChainPreviewPtr& preview) {
  m_preview = preview;
  if (m_chain != nullptr && m_view != ChainView::digraph && preview->of == this->preview()) showPicture();
}

void ChainCard::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && m_chain != nullptr && m_view == ChainView::space)
    showPicture();
}

void ChainCard::setTrain(const TrainAnswerPtr& train) {
  m_train = train;
  m_trainDetails->setTrain(train);
  renew();
}

void ChainCard::setChain(const AtlasChain* chain, const ChainDetailsPtr& details) {
  m_chain = chain;
  m_details = details;
  renew();
}

void ChainCard::setOpening(bool isOpening) {
  m_open->setEnabled(m_chain != nullptr && !isOpening);
}

const IdentifiedChain* ChainCard::ownPart() const {
  if (m_chain == nullptr || !m_train || !m_train->identity) return nullptr;
  for (const IdentifiedChain& part : m_train->identity->parts)
    if (part.displacement == m_chain->number) return &part;
  return nullptr;
}

void ChainCard::renew() {
  m_trainText->setText(m_train ? trainText(*m_train) : tr("Your train is being identified…"));
  for (QWidget* each :
       std::initializer_list<QWidget*>{m_title, m_facts, m_views, m_picture, m_relatives, m_show, m_copy})
    each->setVisible(m_chain != nullptr);
  m_open->setEnabled(m_chain != nullptr);
  m_reason->setVisible(m_details && m_details->lockedMeshes);
  if (m_chain == nullptr) return;

  const Chain& chain = m_chain->chain;
  m_title->setText(shownNumber(m_chain->number));
  m_facts->setText(m_chain->number.dof == 0
                       ? tr("links: %1, axes: %2, gear pairs: %3")
                             .arg(chain.links)
                             .arg(chain.axes.size())
                             .arg(chain.meshes.size())
                       : tr("links: %1, axes: %2, gear pairs: %3; freedom %4 with one link held")
                             .arg(chain.links)
                             .arg(chain.axes.size())
                             .arg(chain.meshes.size())
                             .arg(m_chain->number.dof));
  m_show->setEnabled(ownPart() != nullptr);
  showPicture();
  if (!m_details) return m_relatives->clear();
  if (m_details->lockedMeshes) {
    m_reason->setText(
        tr("It cannot turn: %1 gear pairs are as many conditions for the speeds of %2 links, of which one is "
           "held.")
            .arg(m_details->lockedMeshes->size())
            .arg(linksOf(chain, *m_details->lockedMeshes).size()));
  }
  const ChainRelatives& relatives = m_details->relatives;
  m_relatives->setText(
      tr("Same equations, other shafts: %1").arg(chainLinks(relatives.sameEquations)) +
      QStringLiteral("<br>") + tr("One gear pair less: %1").arg(chainLinks(relatives.oneMeshLess)) +
      QStringLiteral("<br>") + tr("One gear pair more: %1").arg(chainLinks(relatives.oneMeshMore)) +
      QStringLiteral("<br>") + tr("Links that differ as the frame: %1").arg(relatives.frames));
}

/// The document of a chain is laid out when it is looked at.
void ChainCard::showPicture() {
  if (m_view == ChainView::digraph) return showDigraph();
  m_picture->setToolTip(tr("Laid out by rule, with teeth that are no special ones"));
  const bool isThere = m_preview && m_preview->of == preview();
  const QString number = shownNumber(m_chain->number);
  if (m_view == ChainView::schematic) {
    m_picture->setDrawing(isThere ? m_preview->schematic : DisplayList(),
                          tr("Schematic of chain %1").arg(number));
  } else {
    m_picture->setImage(isThere ? m_preview->space : QImage(),
                        tr("Chain %1 in three dimensions").arg(number));
    if (isThere && !m_preview->why.isEmpty()) m_picture->setToolTip(m_preview->why);
  }
  if (!isThere) emit previewWanted(preview());
}

/// A chain of the train has the numbers and colours of its links there.
void ChainCard::showDigraph() {
  ChainDrawingStyle style{.namesAxes = true};
  const IdentifiedChain* own = ownPart();
  if (own != nullptr) {
    if (const auto links = isomorphism(m_chain->chain, own->chain, ChainLikeness::displacement)) {
      for (const int link : *links) {
        const int position = own->links[static_cast<std::size_t>(link)];
        style.labels.push_back(m_train->mechanism->linkLabel(position));
        style.colors.push_back(m_train->mechanism->colorNumber(position));
      }
    }
  }
  m_picture->setDrawing(chainDrawing(m_chain->chain, style),
                        tr("Digraph of chain %1").arg(shownNumber(m_chain->number)));
  m_picture->setToolTip(own == nullptr ? QString() : tr("With the numbers and colours of your links"));
}

void ChainCard::follow(const QString& link) {
  if (!link.startsWith(kChainLink)) return;
  if (const auto number = ChainNumber::fromText(link.mid(kChainLink.size()).toStdString()))
    emit chainWanted(*number);
}

void ChainCard::showOwn() {
  const IdentifiedChain* own = ownPart();
  if (own == nullptr) return;
  std::set<ElementId> elements;
  for (const int link : own->links) elements.insert(m_train->mechanism->links[link].id);
  for (const int mesh : own->meshes) elements.insert(m_train->mechanism->gearMeshes[mesh].id);
  emit showWanted(elements);
}

}  // namespace geargraph

#include "moc_chain_card.cpp"
