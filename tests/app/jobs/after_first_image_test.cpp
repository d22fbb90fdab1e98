/// What waits for the first image of a series begins when that stands, or after some seconds without one.

#include <QTest>

#include "app/rendering/after_first_image.h"
#include "tests/support/patience.h"

namespace pdr::app {

class TestAfterFirstImage : public QObject {
    Q_OBJECT

  private slots:
    void theNewestWorkIsCalledOnce();
    void withAnImageNothingWaits();
    void withoutAnImageItIsCalledAllTheSame();
    void anotherSeriesDropsWhatWaits();
};

void TestAfterFirstImage::theNewestWorkIsCalledOnce() {
    AfterFirstImage after;
    QString called;
    after.call([&] { called += "a"; });
    after.call([&] { called += "b"; });
    QCOMPARE(called, QString());
    after.imageStands();
    QCOMPARE(called, QString("b"));
    after.imageStands();
    QCOMPARE(called, QString("b"));
}

void TestAfterFirstImage::withAnImageNothingWaits() {
    AfterFirstImage after;
    after.imageStands();
    bool called = false;
    after.call([&] { called = true; });
    QVERIFY(called);
}

/// Rendering may be paused, or fail.
void TestAfterFirstImage::withoutAnImageItIsCalledAllTheSame() {
    AfterFirstImage after;
    bool called = false;
    after.call([&] { called = true; });
    QVERIFY(!called);
    QTRY_VERIFY_WITH_TIMEOUT(called, test::kPatience);
}

void TestAfterFirstImage::anotherSeriesDropsWhatWaits() {
    AfterFirstImage after;
    bool called = false;
    after.call([&] { called = true; });
    after.reset();
    after.imageStands();
    QVERIFY(!called);
    after.reset();
    after.call([&] { called = true; });
    QVERIFY(!called);
}

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::TestAfterFirstImage)
#include "after_first_image_test.moc"
