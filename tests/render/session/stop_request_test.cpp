/// Rendering stops when it is paused or when its rule is met, unless more was requested.

#include <QTest>

#include "render/session/stop_request.h"

using namespace pdr;

namespace {

constexpr StopRule kRule{.levels = 4, .seconds = 100};
constexpr ImageProgress kGood{3, 10, 1000}, kPoor{5, 10, 1000}, kUnknown{{}, 200, 1000};

}  // namespace

class StopRequestTest : public QObject {
    Q_OBJECT

  private slots:
    void itStopsAtAnImageThatMeetsTheRule() {
        const StopRequest request{.rule = kRule};
        QVERIFY(request.isMet(kGood) && request.stopsAt(kGood));
        QVERIFY(!request.isMet(kPoor) && !request.stopsAt(kPoor));
    }

    void withoutAFullImageNoLimitCounts() {
        QVERIFY(!StopRequest{.rule = kRule}.stopsAt(kUnknown));
        QVERIFY(!StopRequest{.rule = kRule}.stopsAt({}));
    }

    void theRuleDoesNotCountWhenMoreWasRequested() {
        const StopRequest request{.rule = kRule, .isSuspended = true};
        QVERIFY(!request.isMet(kGood) && !request.stopsAt(kGood));
    }

    void aPauseStopsEverythingWithoutMeetingTheRule() {
        const StopRequest request{.rule = kRule, .isSuspended = true, .isPaused = true};
        for (const ImageProgress& progress : {kGood, kPoor, kUnknown})
            QVERIFY(request.stopsAt(progress) && !request.isMet(progress));
    }
};

QTEST_GUILESS_MAIN(StopRequestTest)
#include "stop_request_test.moc"
