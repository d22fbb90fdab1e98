/// How large a picture is to be that is saved.

#include <QTest>

#include "ui/picture_size_box.h"

namespace pdr::ui {

class TestPictureSizeBox : public QObject {
    Q_OBJECT

  private slots:
    void atFirstItIsWhatIsOnTheScreen();
    void theViewsOwnSizeComesFirst();
    void aTypedSizeIsAnotherOne();
    void aChosenSizeReplacesWhatWasTyped();
    void noSideIsLongerThanAFilm();
    void eachFieldHasANameAndItsUnit();

  private:
    static QSpinBox* side(PictureSizeBox& box, const QString& name) {
        for (QSpinBox* field : box.findChildren<QSpinBox*>())
            if (field->accessibleName().startsWith(name))
                return field;
        return nullptr;
    }
};

void TestPictureSizeBox::atFirstItIsWhatIsOnTheScreen() {
    PictureSizeBox box({765, 818}, {.levels = 4});
    QVERIFY(!box.chosenSize());
    QVERIFY(box.findChild<QComboBox*>()->currentText().contains(QString::fromUtf8("765 × 818")));
    QVERIFY(!side(box, "Width")->isEnabled() && !box.findChild<StopRow*>()->isEnabled());
    QCOMPARE(box.stop().levels, 4.0);
}

void TestPictureSizeBox::theViewsOwnSizeComesFirst() {
    PictureSizeBox box({765, 818}, {});
    auto* sizes = box.findChild<QComboBox*>();
    QList<QSize> offered;
    for (int i = 1; i < sizes->count() - 1; ++i) {
        sizes->setCurrentIndex(i);
        offered << box.chosenSize().value_or(QSize());
    }
    QCOMPARE(offered, QList<QSize>({{765, 818}, {2000, 2000}, {3840, 2160}}));
    QVERIFY(side(box, "Width")->isEnabled() && box.findChild<StopRow*>()->isEnabled());
}

void TestPictureSizeBox::aTypedSizeIsAnotherOne() {
    PictureSizeBox box({765, 818}, {});
    auto* sizes = box.findChild<QComboBox*>();
    sizes->setCurrentIndex(2);
    side(box, "Height")->setValue(100);
    QVERIFY(box.chosenSize() == QSize(2000, 100));
    QCOMPARE(sizes->currentIndex(), sizes->count() - 1);
}

void TestPictureSizeBox::aChosenSizeReplacesWhatWasTyped() {
    PictureSizeBox box({765, 818}, {});
    auto* sizes = box.findChild<QComboBox*>();
    sizes->setCurrentIndex(sizes->count() - 1);
    QVERIFY(box.chosenSize() == QSize(765, 818));
    side(box, "Width")->setValue(33);
    sizes->setCurrentIndex(3);
    QVERIFY(box.chosenSize() == QSize(3840, 2160));
    sizes->setCurrentIndex(0);
    QVERIFY(!box.chosenSize());
}

void TestPictureSizeBox::noSideIsLongerThanAFilm() {
    PictureSizeBox box({765, 818}, {});
    QCOMPARE(side(box, "Width")->maximum(), 16384);
    QCOMPARE(side(box, "Height")->minimum(), 1);
}

void TestPictureSizeBox::eachFieldHasANameAndItsUnit() {
    PictureSizeBox box({765, 818}, {});
    QVERIFY(side(box, "Width")->toolTip().contains("[pixels]"));
    QVERIFY(!box.findChild<QComboBox*>()->accessibleName().isEmpty());
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestPictureSizeBox)
#include "picture_size_box_test.moc"
