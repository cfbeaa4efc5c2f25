#pragma once

#include <QByteArray>
#include <QProcess>
#include <QStringList>
#include <string>

namespace geargraph::test {

/// What one call of the built program printed, and its exit status; -1 where it crashed or did not end.
struct Run {
  int status = -1;
  std::string output;
  std::string errors;
};

/// Runs geargraph-cli with these words, as a user would.
inline Run run(const QStringList& words, const QByteArray& input = {}) {
  constexpr int kLongestRun = 120'000;  // ms
  QProcess process;
  process.start(QStringLiteral(GEARGRAPH_CLI), words);
  process.write(input);
  process.closeWriteChannel();
  if (!process.waitForFinished(kLongestRun)) {
    process.kill();
    process.waitForFinished();
    return {-1, {}, "The program did not end."};
  }
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
          process.readAllStandardOutput().toStdString(), process.readAllStandardError().toStdString()};
}

}  // namespace geargraph::test
