#include "ui/teeth_panel/teeth_service.h"

#include "core/mechanism/model/difference.h"

namespace geargraph {
namespace {

void tellRatiosNow(TeethResult& result) {
  std::vector<int> teeth;
  for (const SearchedWheel& wheel : result.problem->wheels) teeth.push_back(wheel.drawn);
  for (std::size_t ratio = 0; ratio < result.problem->ratios.size(); ++ratio)
    result.ratiosNow.push_back(solvedRatio(*result.problem, ratio, teeth));
}

/// Nothing of a search that was stopped: its choices need not be those with the fewest wheels.
Diagnostics answerMeant(const TeethRequest& request, const TeethWish& wish, TeethResult& result,
                        const std::stop_token& stop) {
  auto found = meantTeeth(request.drawn, wish, *request.meant, stop);
  if (!found) return found.error();
  MeantTeeth meant = *std::move(found);
  if (stop.stop_requested()) meant.choices.clear();
  result.problem = meant.problem;
  result.answer = meantAnswer(meant, kMaxShown, stop);
  result.meant = std::move(meant);
  return {};
}

void searchOne(const TeethRequest& request, const TeethService::Responder& respond) {
  std::stop_source halt = request.halt;
  const std::stop_callback superseded(respond.stop(), [&halt] { halt.request_stop(); });
  auto result = std::make_shared<TeethResult>();
  result->drawn = request.drawn.pointer();
  result->wish = request.wish;
  const auto wish = readTeethWish(request.wish, request.drawn);
  if (!wish) {
    result->problems = wish.error();
    return respond(std::move(result));
  }
  if (!request.isWhole) {
    auto problem = teethProblemOf(request.drawn, *wish);
    if (!problem) {
      result->problems = problem.error();
      return respond(std::move(result));
    }
    result->problem = std::make_shared<const TeethProblem>(*std::move(problem));
  } else if (request.meant) {
    result->problems = answerMeant(request, *wish, *result, halt.get_token());
    if (!result->problems.empty()) return respond(std::move(result));
  } else {
    TeethSearchOptions options;
    options.most = kMaxShown;
    options.progress = [&request](double share, std::int64_t found) {
      request.share->store(share);
      request.found->store(found);
    };
    auto answer = teethFor(request.drawn, *wish, options, halt.get_token());
    if (!answer) {
      result->problems = answer.error();
      return respond(std::move(result));
    }
    result->problem = answer->problem;
    result->answer = *std::move(answer);
  }
  tellRatiosNow(*result);
  respond(std::move(result));
}

bool isSameSearch(const TeethRequest& before, const TeethRequest& now) {
  return before.wish == now.wish && before.isWhole == now.isWhole && before.meant == now.meant &&
         !before.halt.stop_requested() &&
         (before.drawn.pointer() == now.drawn.pointer() || isSameButForView(before.drawn, now.drawn));
}

}  // namespace

TeethService::TeethService(QObject* parent) : Service(&searchOne, parent, {.same = &isSameSearch}) {}

void TeethService::search(const PlacedMechanism& drawn, std::string wish, bool isWhole,
                          const std::optional<MeantTeethOptions>& meant) {
  TeethRequest asked{drawn, std::move(wish), isWhole, meant};
  if (request(asked)) m_running = std::move(asked);
}

void TeethService::halt() {
  if (m_running) m_running->halt.request_stop();
}

void TeethService::forget() {
  if (!isComplete()) cancel();
  forgetRequest();
  m_running.reset();
  if (answer()) setAnswer(nullptr);
}

}  // namespace geargraph
