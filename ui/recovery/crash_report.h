#pragma once

#include <QDateTime>
#include <QString>
#include <QStringList>

namespace geargraph {

/// A crash report of an earlier run.
struct CrashReport {
  QString path;
  QDateTime time;
  QString text;  ///< readable, with demangled function names
};

/// The unseen reports in a folder, the newest first.
[[nodiscard]] QList<CrashReport> newCrashReports(const QString& folder);

/// Marks the report as seen; it is kept in its folder with at most kKeptReports - 1 others.
void keepCrashReport(const CrashReport& report);
constexpr int kKeptReports = 5;

/// The text of a report with demangled function names.
[[nodiscard]] QString readableReport(const QByteArray& written);

}  // namespace geargraph
