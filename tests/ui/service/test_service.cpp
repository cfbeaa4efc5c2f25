#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <future>
#include <memory>
#include <stdexcept>
#include <vector>

#include "ui/service/service.h"

namespace geargraph {
namespace {

using Toy = Service<int, int>;

/// Work on request 0 waits to be stopped; every other one is answered by ten times its number.
struct Slow {
  std::promise<void> begun;
  std::atomic<int> stopped = 0;

  Toy::Work work() {
    return [this](int request, const Toy::Responder& respond) {
      if (request != 0) return respond(10 * request);
      begun.set_value();
      while (!respond.stop().stop_requested()) std::this_thread::yield();
      ++stopped;
      respond(-1);
    };
  }
};

}  // namespace

class ServiceTest : public QObject {
  Q_OBJECT

 private slots:
  void theNewestRequestStopsTheOneUnderWayAndWins() {
    Slow slow;
    Toy service(slow.work());
    std::vector<int> answers;
    service.onAnswer(this, [&](int answer) {
      QCOMPARE(QThread::currentThread(), thread());
      answers.push_back(answer);
    });
    QVERIFY(service.isComplete());
    service.request(0);
    slow.begun.get_future().wait();
    QVERIFY(!service.isUpToDate());
    for (int request = 1; request <= 39; ++request) service.request(request);
    QTRY_VERIFY(service.isComplete());
    QCOMPARE(slow.stopped.load(), 1);
    QCOMPARE(answers, std::vector<int>{390});
    QCOMPARE(service.answer(), 390);
  }

  void answersThatArriveTogetherAreShownOneATurn() {
    std::vector<std::unique_ptr<Toy>> services;
    int thisTurn = 0, most = 0, all = 0;
    for (int i = 0; i < 5; ++i) {
      services.push_back(
          std::make_unique<Toy>([](int request, const Toy::Responder& respond) { respond(request); }));
      services.back()->onAnswer(this, [&](int) {
        ++all;
        most = std::max(most, ++thisTurn);
      });
    }
    for (const auto& service : services) service->request(1);
    QTimer turns;
    turns.setInterval(0);
    connect(&turns, &QTimer::timeout, [&] { thisTurn = 0; });
    turns.start();
    QTRY_COMPARE(all, 5);
    QCOMPARE(most, 1);
  }

  void aPieceForALaterTurnIsDroppedWithItsContext() {
    int run = 0;
    auto context = std::make_unique<QObject>();
    GuiTaskQueue::instance().later(context.get(), [&] { ++run; });
    GuiTaskQueue::instance().later(this, [&] { run += 10; });
    QCOMPARE(run, 0);
    context.reset();
    QTRY_COMPARE(run, 10);
  }

  void aTurnIsTakenOnceForAllThatAskForIt() {
    int run = 0;
    std::function<void()> piece = [&] { ++run; };
    CoalescedTask turn(this, [&] { piece(); });
    turn.request();
    turn.request();
    QCOMPARE(run, 0);
    GuiTaskQueue::instance().later(this, [&] { run += 10; });
    QTRY_COMPARE(run, 11);
    piece = [&] {  // it may ask for the next one
      if (++run < 15) turn.request();
    };
    turn.request();
    QTRY_COMPARE(run, 15);
  }

  void whatIsWaitingComesBeforeTheNextPiece() {
    QStringList order;
    const auto input = [&] {  // comes while a piece is under way
      QMetaObject::invokeMethod(
          this, [&] { order << QStringLiteral("input"); }, Qt::QueuedConnection);
    };
    for (const char* const name : {"first", "second", "third"}) {
      GuiTaskQueue::instance().later(this, [&order, input, name] {
        order << QLatin1String(name);
        input();
      });
    }
    QTRY_COMPARE(order.size(), 6);
    QCOMPARE(order.join(QLatin1Char(' ')), QStringLiteral("first input second input third input"));
  }

  void aSupersededAnswerOnItsWayIsDropped() {
    std::promise<void> queued;
    Toy service(
        [](int request, const Toy::Responder& respond) {
          respond.partly(request);
          respond(request);
        },
        nullptr, {.ahead = [&, told = 0](int) mutable {
          if (++told == 2) queued.set_value();  // the first part is in the queue of events by now
        }});
    std::vector<int> answers;
    service.onAnswer(this, [&](int answer) { answers.push_back(answer); });
    service.request(1);
    queued.get_future().wait();
    service.request(2);
    QTRY_VERIFY(service.isComplete());
    QCOMPARE(answers, (std::vector<int>{2, 2}));
  }

  void supersededAnswersArriveInOrderWhereTheyAreWanted() {
    std::promise<void> begun;
    std::promise<void> go;
    Toy service(
        [&](int request, const Toy::Responder& respond) {
          if (request == 1) {
            begun.set_value();
            go.get_future().wait();
          }
          respond(request);
        },
        nullptr, {.superseded = Superseded::delivered});
    std::vector<int> answers;
    service.onAnswer(this, [&](int answer) { answers.push_back(answer); });
    service.request(1);
    begun.get_future().wait();
    service.request(2);
    go.set_value();
    QTRY_VERIFY(service.isComplete());
    QCOMPARE(answers, (std::vector<int>{1, 2}));
  }

  void partsArriveBeforeTheWhole() {
    std::promise<void> go;
    Toy service([&](int, const Toy::Responder& respond) {
      respond.partly(1);
      respond.partly(2);
      go.get_future().wait();
      respond(3);
    });
    std::vector<int> answers;
    service.onAnswer(this, [&](int answer) { answers.push_back(answer); });
    service.request(0);
    QTRY_COMPARE(answers, (std::vector<int>{1, 2}));
    QVERIFY(service.isUpToDate());
    QVERIFY(!service.isComplete());
    go.set_value();
    QTRY_VERIFY(service.isComplete());
    QCOMPARE(answers, (std::vector<int>{1, 2, 3}));
  }

  void aRequestForTheSameAnswerIsNotWorkedOn() {
    std::atomic<int> worked = 0;
    Toy service(
        [&](int request, const Toy::Responder& respond) {
          ++worked;
          respond(request);
        },
        nullptr, {.same = [](int before, int now) { return before % 10 == now % 10; }});
    QVERIFY(service.request(7));
    QVERIFY(!service.request(17));
    QTRY_VERIFY(service.isComplete());
    QVERIFY(!service.request(27));
    QVERIFY(service.isComplete());
    QVERIFY(service.request(8));
    QTRY_VERIFY(service.isComplete());
    QCOMPARE(worked.load(), 2);
    QCOMPARE(service.answer(), 8);
  }

  /// Requests that fail are answered: nothing waits for them, and asking again tries again.
  void anExceptionIsToldAndTheServiceGoesOn() {
    std::atomic<bool> fails = false;
    Toy service(
        [&](int request, const Toy::Responder& respond) {
          if (fails) throw std::runtime_error("no room");
          respond(request);
        },
        nullptr, {.same = [](int before, int now) { return before == now; }});
    QSignalSpy failed(&service, &ServiceSignals::failed);
    service.request(1);
    QTRY_VERIFY(service.isComplete());
    fails = true;
    service.request(2);
    QTRY_VERIFY(service.isComplete());
    QCOMPARE(failed.size(), 1);
    QCOMPARE(failed.front().front().toString(), QStringLiteral("no room"));
    QCOMPARE(service.answer(), 1);
    fails = false;
    QVERIFY(service.request(2));
    QTRY_COMPARE(service.answer(), 2);
    QCOMPARE(failed.size(), 1);
  }

  void awaitTellsAtOnceAndOnlyOnce() {
    Toy service([](int request, const Toy::Responder& respond) { respond(request); });
    int answers = 0;
    service.onAnswer(this, [&](int) { ++answers; });
    service.request(5);
    service.await(std::chrono::seconds(10));
    QCOMPARE(answers, 1);
    QVERIFY(service.isComplete());
    QCoreApplication::processEvents();
    QCOMPARE(answers, 1);
  }

  void awaitGivesUpAfterTheTimeItIsGiven() {
    Slow slow;
    Toy service(slow.work());
    service.request(0);
    service.await(std::chrono::milliseconds(1));
    QVERIFY(!service.isUpToDate());
  }

  void aCancelledRequestIsStoppedAndNeverAnswered() {
    Slow slow;
    Toy service(slow.work());
    QSignalSpy answered(&service, &ServiceSignals::answered);
    service.request(0);
    slow.begun.get_future().wait();
    service.cancel();
    QVERIFY(service.isComplete());
    service.request(3);
    QTRY_COMPARE(service.answer(), 30);
    QCOMPARE(slow.stopped.load(), 1);
    QCOMPARE(answered.size(), 1);
  }

  void aheadHearsOfEveryAnswerFirst() {
    std::vector<int> ahead;
    bool elsewhere = true;
    Toy service(
        [](int request, const Toy::Responder& respond) {
          respond.partly(request);
          respond(request + 1);
        },
        nullptr, {.ahead = [&](int answer) {
          elsewhere = elsewhere && QThread::currentThread() != thread();
          ahead.push_back(answer);
        }});
    service.request(1);
    service.await(std::chrono::seconds(10));  // the answers' own way is not open yet
    QCOMPARE(ahead, (std::vector<int>{1, 2}));
    QVERIFY(elsewhere);
  }

  /// Work that looks at its token ends at once; nothing arrives afterwards.
  void destructionStopsTheWorkUnderWay() {
    Slow slow;
    int answers = 0;
    {
      Toy service(slow.work());
      service.onAnswer(this, [&](int) { ++answers; });
      service.request(0);
      slow.begun.get_future().wait();
    }
    QCOMPARE(slow.stopped.load(), 1);
    QCoreApplication::processEvents();
    QCOMPARE(answers, 0);
  }

  void destroyedWhileItWorksIsHarmless() {
    for (int round = 0; round < 50; ++round) {
      Toy service([](int request, const Toy::Responder& respond) { respond(request); });
      for (int request = 0; request < round; ++request) service.request(request);
    }
    QCoreApplication::processEvents();
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::ServiceTest)
#include "test_service.moc"
