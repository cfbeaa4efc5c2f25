#include "ui/mainwindow/recent_exports.h"

#include <QFileInfo>
#include <algorithm>

#include "ui/settings/settings.h"

namespace geargraph {
namespace {

const QString kKey = QStringLiteral("recentExports");

// An export as a map of texts: options as "--name=value".

QVariantMap mapOf(const RecentExport& made) {
  QStringList options;
  for (const auto& [name, values] : made.options.options) {
    for (const std::string& value : values)
      options << QString::fromStdString(name) + QLatin1Char('=') + QString::fromStdString(value);
  }
  return {{QStringLiteral("document"), made.document},
          {QStringLiteral("id"), made.id},
          {QStringLiteral("options"), options},
          {QStringLiteral("path"), made.path}};
}

RecentExport fromMap(const QVariantMap& map) {
  RecentExport made;
  made.document = map.value(QStringLiteral("document")).toString();
  made.id = map.value(QStringLiteral("id")).toString();
  made.path = map.value(QStringLiteral("path")).toString();
  for (const QString& each : map.value(QStringLiteral("options")).toStringList()) {
    const std::string name = each.section(QLatin1Char('='), 0, 0).toStdString();
    made.options.options[name].push_back(each.section(QLatin1Char('='), 1).toStdString());
  }
  return made;
}

}  // namespace

RecentExports::RecentExports(QWidget* parent) : QMenu(tr("Export a&gain"), parent) {
  setToolTipsVisible(true);
  connect(this, &QMenu::aboutToShow, this, &RecentExports::fill);
  fill();
}

std::vector<RecentExport> RecentExports::all(const QString* document) {
  std::vector<RecentExport> kept;
  for (const QVariant& each : savedSetting(kKey).toList()) {
    RecentExport made = fromMap(each.toMap());
    if (document != nullptr && made.document != *document) continue;
    if (exporterWithId(made.id.toStdString()) != nullptr && !made.path.isEmpty())
      kept.push_back(std::move(made));
  }
  return kept;
}

void RecentExports::add(const RecentExport& made) {
  std::vector<RecentExport> kept = all();
  std::erase_if(kept, [&](const RecentExport& each) { return each.path == made.path; });
  kept.insert(kept.begin(), made);
  kept.resize(std::min(kept.size(), kMax));
  QVariantList list;
  for (const RecentExport& each : kept) list << mapOf(each);
  saveSetting(kKey, list);
}

void RecentExports::setDocument(const QString& file) {
  m_document = file;
  fill();
}

void RecentExports::fill() {
  clear();
  std::vector<RecentExport> list = all(&m_document);
  list.resize(std::min(list.size(), kShown));
  for (const RecentExport& each : list) {
    const Exporter& exporter = *exporterWithId(each.id.toStdString());
    QString name = QFileInfo(each.path).fileName();
    name.replace(QLatin1Char('&'), QStringLiteral("&&"));
    QAction* action =
        addAction(QStringLiteral("%1 (%2)").arg(name, QString::fromStdString(translated(exporter.title))),
                  this, [this, each] { emit chosen(each); });
    action->setToolTip(tr("Writes %1 again, with the same options").arg(each.path));
  }
  if (!list.empty()) return;
  QAction* none = addAction(tr("This document has not been exported yet"));
  none->setEnabled(false);
  none->setToolTip(tr("Exports of this document by File > Export are listed here"));
}

}  // namespace geargraph

#include "moc_recent_exports.cpp"
