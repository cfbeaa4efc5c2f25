#include "ui/designer/designer_services.h"

#include <QThread>
#include <algorithm>
#include <chrono>

#include "core/presentation/diagrams/lever_drawing.h"
#include "core/presentation/export_api/levers_json.h"
#include "core/presentation/schematic/schematic.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {
namespace {

/// Blocks without a hit are not worth more answers than people can read.
constexpr std::chrono::milliseconds kBetweenAnswers{60};

void searchGearboxes(const DesignRequest& request, const DesignService::Responder& respond) {
  using Clock = std::chrono::steady_clock;
  const GearboxWish& wish = *request.wish;
  DesignProgress next{.done = request.from, .total = 0, .found = {}};
  auto answered = Clock::now();
  GearboxRunOptions options;
  options.from = request.from;
  options.threads = std::max(1, QThread::idealThreadCount() - 1);
  options.onBlock = [&](const GearboxSearch& block, std::int64_t done, std::int64_t total) {
    next.done = done;
    next.total = total;
    next.judged += block.judged;
    for (Gearbox each : block.found) {
      if (checkByDocument(wish, each, true, respond.stop()) != GearboxCheck::right) continue;
      next.found.push_back(std::make_shared<const Gearbox>(std::move(each)));
    }
    if (respond.stop().stop_requested()) return false;
    if (next.found.empty() && Clock::now() - answered < kBetweenAnswers) return true;
    respond.partly(std::exchange(next, DesignProgress{.done = done, .total = total, .found = {}}));
    answered = Clock::now();
    return true;
  };
  const auto search = findGearboxes(wish, options, respond.stop());
  if (!search) return;  // paused
  next.done = next.total = search->layouts;
  next.isProof = search->isComplete;
  respond(std::move(next));
}

/// Null if a stop was requested.
HitDetailPtr detailOf(const GearboxWish& wish, const GearboxPtr& asked, const std::stop_token& stop) {
  auto detail = std::make_shared<HitDetail>();
  detail->asked = asked;
  Gearbox gearbox = *asked;
  if (!gearbox.losses && checkByDocument(wish, gearbox, true, stop) == GearboxCheck::stopped) return nullptr;
  detail->document = gearboxDocument(wish, gearbox);
  detail->gearbox = std::make_shared<const Gearbox>(std::move(gearbox));
  const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(detail->document));
  const auto levers = leverPictureOf(*snapshot, stop);
  if (!levers) return nullptr;
  detail->levers = leverSheet(detail->document, *levers, leverLayout(detail->document, levers->plan), {},
                              {.speeds = false, .torques = false})
                       .drawing;
  detail->schematic = schematicDrawing(schematicGeometry(detail->document, stop), {});
  return stop.stop_requested() ? nullptr : detail;
}

void detailsOf(const HitRequest& request, const HitService::Responder& respond) {
  for (std::size_t i = 0; i < request.gearboxes.size(); ++i) {
    HitDetailPtr detail = detailOf(*request.wish, request.gearboxes[i], respond.stop());
    if (!detail) return;
    i + 1 < request.gearboxes.size() ? respond.partly(std::move(detail)) : respond(std::move(detail));
  }
}

}  // namespace

DesignService::DesignService(QObject* parent) : Service(&searchGearboxes, parent) {}

HitService::HitService(QObject* parent) : Service(&detailsOf, parent) {}

}  // namespace geargraph
