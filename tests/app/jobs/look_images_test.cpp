/// The small images of looks: made beside the session, of this volume, again when it is seen from elsewhere.

#include <QSignalSpy>
#include <QTest>

#include "app/jobs/look_images.h"
#include "app/looks/looks.h"
#include "app/looks/small_image.h"
#include "render/volume/phantom.h"
#include "tests/support/patience.h"

namespace pdr::app {

class TestLookImages : public QObject {
    Q_OBJECT

  private slots:
    void eachLookGetsItsImage();
    void theSameAgainIsNothingNew();
    void anotherViewIsAnotherImage();
    void partsAreShownWhereTheyAre();
    void theVolumeIsLetGoOf();
    void theLargeImageComesFirst();

  private:
    static std::vector<LookTask> tasks(StandardView view, const Volume& volume) {
        std::vector<LookTask> tasks;
        ImageSetup setup;
        setup.camera = standardView(view, volume.geometry().centreMm(), volume.geometry().radiusMm(), 1);
        const auto looks = *bundledLooks();
        for (const int look : {14, 0})  // in the order that is asked for
            tasks.push_back({look, withNamedLook(setup, looks[std::size_t(look)], volume.geometry()), {}});
        return tasks;
    }
    std::shared_ptr<const Volume> head_ = std::make_shared<const Volume>(headPhantom({64, 57, 64}, {3.9, 4.9, 3.9}));
    std::shared_ptr<const segment::BodyParts> parts_ = std::make_shared<const segment::BodyParts>(head_);
};

void TestLookImages::eachLookGetsItsImage() {
    LookImages images;
    QSignalSpy made(&images, &LookImages::made);
    images.make(head_, parts_, head_->geometry(), tasks(StandardView::anterior, *head_));
    QTRY_COMPARE_WITH_TIMEOUT(made.count(), 2, test::kPatience);
    QCOMPARE(made[0][0].toInt(), 14);
    QCOMPARE(made[1][0].toInt(), 0);
    for (const auto& one : made) {
        const auto image = one[1].value<QImage>();
        QCOMPARE(image.size(), QSize(kSmallImagePixels, kSmallImagePixels));
        int seen = 0;
        for (int i = 0; i < kSmallImagePixels; ++i)
            seen += qGray(image.pixel(kSmallImagePixels / 2, i)) > 20;
        QVERIFY2(seen > 40, qPrintable(QString::number(seen)));  // the head fills it
        QVERIFY(std::abs(one[2].toDouble()) <= 4);
    }
    QVERIFY(made[0][1].value<QImage>() != made[1][1].value<QImage>());
}

void TestLookImages::theSameAgainIsNothingNew() {
    LookImages images;
    QSignalSpy made(&images, &LookImages::made);
    images.make(head_, parts_, head_->geometry(), tasks(StandardView::anterior, *head_));
    QTRY_COMPARE_WITH_TIMEOUT(made.count(), 2, test::kPatience);
    images.make(head_, parts_, head_->geometry(), tasks(StandardView::anterior, *head_));
    QVERIFY(!images.isRunning());
}

void TestLookImages::anotherViewIsAnotherImage() {
    LookImages images;
    QSignalSpy made(&images, &LookImages::made);
    images.make(head_, parts_, head_->geometry(), tasks(StandardView::anterior, *head_));
    QTRY_COMPARE_WITH_TIMEOUT(made.count(), 2, test::kPatience);
    images.make(head_, parts_, head_->geometry(), tasks(StandardView::left, *head_));
    QTRY_COMPARE_WITH_TIMEOUT(made.count(), 4, test::kPatience);
    QVERIFY(made[0][1].value<QImage>() != made[2][1].value<QImage>());
    images.make(head_, parts_, head_->geometry(), tasks(StandardView::anterior, *head_));
    QTRY_COMPARE_WITH_TIMEOUT(made.count(), 6, test::kPatience);
    QVERIFY(made[0][1].value<QImage>() == made[4][1].value<QImage>());  // to the bit
}

/// Looks that show no parts keep their images when parts are found.
void TestLookImages::partsAreShownWhereTheyAre() {
    LookImages images;
    QSignalSpy made(&images, &LookImages::made);
    std::vector<LookTask> all = tasks(StandardView::anterior, *head_);
    all[1].setup.look.parts.rest = PartState::hidden;
    images.make(head_, parts_, head_->geometry(), all);
    QTRY_COMPARE_WITH_TIMEOUT(made.count(), 2, test::kPatience);
    auto upper = std::make_shared<LabelMap>();
    upper->geometry = head_->geometry();
    upper->labels.assign(upper->geometry.voxelCount(), 0);
    std::fill(upper->labels.begin() + upper->labels.size() / 2, upper->labels.end(), std::uint8_t(1));
    upper->parts = {{"upper", {200, 40, 40}}};
    all[1].parts = upper;
    images.make(head_, parts_, head_->geometry(), all);
    QTRY_VERIFY_WITH_TIMEOUT(!images.isRunning(), test::kPatience);
    QCOMPARE(made.count(), 3);
    QCOMPARE(made[2][0].toInt(), 0);
    const auto whole = made[1][1].value<QImage>(), half = made[2][1].value<QImage>();
    const int column = kSmallImagePixels / 2, foot = kSmallImagePixels * 3 / 4;
    QVERIFY(qGray(half.pixel(column, kSmallImagePixels / 4)) > 20 && qGray(whole.pixel(column, foot)) > 20);
    QVERIFY2(qGray(half.pixel(column, foot)) < 3, qPrintable(QString::number(qGray(half.pixel(column, foot)))));
    all[1].parts.reset();
    images.make(head_, parts_, head_->geometry(), all);
    QTRY_COMPARE_WITH_TIMEOUT(made.count(), 4, test::kPatience);
    QVERIFY(made[3][1].value<QImage>() == whole);
}

/// A series waits for the one before to leave the memory.
void TestLookImages::theVolumeIsLetGoOf() {
    LookImages images;
    auto head = std::make_shared<const Volume>(headPhantom({64, 57, 64}, {3.9, 4.9, 3.9}));
    const std::weak_ptr<const Volume> kept = head;
    images.make(head, std::make_shared<const segment::BodyParts>(head), head->geometry(),
                tasks(StandardView::anterior, *head));
    head.reset();
    images.forget();
    QTRY_VERIFY_WITH_TIMEOUT(kept.expired(), test::kPatience);
}

/// The brightness of the look that is shown is waited for, the other images are not.
void TestLookImages::theLargeImageComesFirst() {
    LookImages images;
    QSignalSpy made(&images, &LookImages::made);
    images.setImageStands(false);
    std::vector<LookTask> all = tasks(StandardView::anterior, *head_);
    images.make(head_, parts_, head_->geometry(), all);
    QTRY_COMPARE_WITH_TIMEOUT(made.count(), 1, test::kPatience);
    QVERIFY(!made.wait(100));
    std::swap(all[0], all[1]);
    images.make(head_, parts_, head_->geometry(), all);  // nothing new
    images.setImageStands(true);
    QTRY_COMPARE_WITH_TIMEOUT(made.count(), 2, test::kPatience);
    QCOMPARE(made[1][0].toInt(), 0);
}

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::TestLookImages)
#include "look_images_test.moc"
