#include "ui/learning/lesson_service.h"

#include "core/teaching/lessons/course.h"

namespace geargraph {
namespace {

void work(const LessonRequest& request, const LessonService::Responder& respond) {
  auto answer = std::make_shared<LessonAnswer>();
  const LessonStep& step = request.lesson->steps[request.step];
  if (request.drawing) {
    answer->drawing = checkDrawing(std::get<DrawTask>(step.task), request.drawing, respond.stop()).verdict;
  } else {
    auto prepared = prepareStep(*request.lesson, request.step, bundledExample, respond.stop());
    if (prepared) {
      answer->prepared = std::move(prepared).value();
    } else {
      answer->faults = prepared.error();
    }
  }
  if (!respond.stop().stop_requested()) respond(std::move(answer));
}

}  // namespace

LessonService::LessonService(QObject* parent) : Service(&work, parent) {}

}  // namespace geargraph
