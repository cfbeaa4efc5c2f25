#include "ui/recovery/crash_report.h"

#include <cxxabi.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <cstdlib>
#include <memory>

namespace geargraph {
namespace {

const QString kSeenSuffix = QStringLiteral(".seen");

QString demangled(const QString& name) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
      abi::__cxa_demangle(name.toLatin1().constData(), nullptr, nullptr, &status), &std::free);
  return status == 0 ? QString::fromUtf8(text.get()) : name;
}

}  // namespace

QString readableReport(const QByteArray& written) {
  static const QRegularExpression kFrame(QStringLiteral("^(  #\\d+ )(_Z\\w+)(.*)$"));
  static const QRegularExpression kException(QStringLiteral("^(Uncaught exception: )(\\w+)()$"));
  QStringList lines = QString::fromUtf8(written).split(QLatin1Char('\n'));
  for (QString& line : lines) {
    for (const QRegularExpression& form : {kFrame, kException}) {
      const auto match = form.match(line);
      if (match.hasMatch()) line = match.captured(1) + demangled(match.captured(2)) + match.captured(3);
    }
  }
  return lines.join(QLatin1Char('\n'));
}

QList<CrashReport> newCrashReports(const QString& folder) {
  QList<CrashReport> reports;
  for (const QFileInfo& each :
       QDir(folder).entryInfoList({QStringLiteral("crash-*.txt")}, QDir::Files, QDir::Time)) {
    QFile file(each.filePath());
    if (!file.open(QIODevice::ReadOnly)) continue;
    reports.append({each.filePath(), each.lastModified(), readableReport(file.readAll())});
  }
  return reports;
}

void keepCrashReport(const CrashReport& report) {
  QFile::rename(report.path, report.path + kSeenSuffix);
  QDir folder = QFileInfo(report.path).dir();
  const auto seen = folder.entryList({QStringLiteral("crash-*.txt") + kSeenSuffix}, QDir::Files, QDir::Time);
  for (const QString& old : seen.mid(kKeptReports)) folder.remove(old);
}

}  // namespace geargraph
