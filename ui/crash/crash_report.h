#pragma once

#include <QDateTime>
#include <QString>
#include <QStringList>

namespace geargraph::inline crash {

/// A report that an earlier run wrote when it crashed.
struct CrashReport {
  QString path;
  QDateTime time;
  QString text;  ///< for people: names of functions as in the source
};

/// The reports in a folder that have not been seen yet, the newest first.
[[nodiscard]] QList<CrashReport> newCrashReports(const QString& folder);

/// From now on the report is not among the new ones; it stays in its folder beside at most kKeptReports - 1
/// others.
void keepCrashReport(const CrashReport& report);
constexpr int kKeptReports = 5;

/// The text of a report with the mangled names of functions spelled out. Lines that hold none stay.
[[nodiscard]] QString readableReport(const QByteArray& written);

}  // namespace geargraph::inline crash
