#pragma once

#include <QByteArray>
#include <QProcess>
#include <QStringList>
#include <nlohmann/json.hpp>
#include <string>

namespace geargraph::test {

inline const QString kRobot = QStringLiteral(SOURCE "/resources/examples/robot.geargraph");

/// What one call of the built program printed, and its exit status; -1 where it crashed or did not end.
struct Run {
  int status = -1;
  std::string output;
  std::string errors;
};

/// Runs geargraph-cli with these words, as a user would who has no display.
inline Run run(const QStringList& words, const QByteArray& input = {}) {
  constexpr int kMaxRun = 120'000;  // ms
  QProcess process;
  QProcessEnvironment bare = QProcessEnvironment::systemEnvironment();
  bare.remove(QStringLiteral("DISPLAY"));
  process.setProcessEnvironment(bare);
  process.start(QStringLiteral(GEARGRAPH_CLI), words);
  process.write(input);
  process.closeWriteChannel();
  if (!process.waitForFinished(kMaxRun)) {
    process.kill();
    process.waitForFinished();
    return {-1, {}, "The program did not end."};
  }
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
          process.readAllStandardOutput().toStdString(), process.readAllStandardError().toStdString()};
}

/// The JSON that a call printed.
inline nlohmann::json parsed(const Run& call) {
  const auto read = nlohmann::json::parse(call.output, nullptr, false);
  if (read.is_discarded()) qFatal("no JSON: %s %s", call.output.c_str(), call.errors.c_str());
  return read;
}

}  // namespace geargraph::test
