/// The size and accuracy of an image to be saved.

#include <QTest>
#include <algorithm>

#include "ui/output/image_size_box.h"

namespace pdr::ui {

class TestImageSizeBox : public QObject {
    Q_OBJECT

  private slots:
    void atFirstItIsWhatIsOnTheScreen();
    void theViewsOwnSizeComesFirst();
    void aTypedSizeIsAnotherOne();
    void aChosenSizeReplacesWhatWasTyped();
    void noSideIsAbsurdlyLong();
    void eachFieldHasANameAndItsUnit();
    void itSaysHowLongItTakes();
    void whoItIsIsOfferedOnlyWhereThatIsKnown();

  private:
    static QSpinBox* side(ImageSizeBox& box, const QString& name) {
        for (QSpinBox* field : box.findChildren<QSpinBox*>())
            if (field->accessibleName().startsWith(name))
                return field;
        return nullptr;
    }
};

void TestImageSizeBox::atFirstItIsWhatIsOnTheScreen() {
    ImageSizeBox box({.view = {765, 818}});
    QVERIFY(!box.chosenSize());
    QVERIFY(box.findChild<QComboBox*>()->currentText().contains(QString::fromUtf8("765 × 818")));
    QVERIFY(!side(box, "Width")->isEnabled() && !box.findChild<StopRow*>()->isEnabled());
    QCOMPARE(box.stop().levels, 8.0);
    QVERIFY(box.annotate() == Annotate::sides);
}

void TestImageSizeBox::theViewsOwnSizeComesFirst() {
    ImageSizeBox box({.view = {765, 818}});
    auto* sizes = box.findChild<QComboBox*>();
    QList<QSize> offered;
    for (int i = 1; i < sizes->count() - 1; ++i) {
        sizes->setCurrentIndex(i);
        offered << box.chosenSize().value_or(QSize());
    }
    QCOMPARE(offered, QList<QSize>({{765, 818}, {2000, 2000}, {3840, 2160}}));
    QVERIFY(side(box, "Width")->isEnabled() && box.findChild<StopRow*>()->isEnabled());
}

void TestImageSizeBox::aTypedSizeIsAnotherOne() {
    ImageSizeBox box({.view = {765, 818}});
    auto* sizes = box.findChild<QComboBox*>();
    sizes->setCurrentIndex(2);
    side(box, "Height")->setValue(100);
    QVERIFY(box.chosenSize() == QSize(2000, 100));
    QCOMPARE(sizes->currentIndex(), sizes->count() - 1);
}

void TestImageSizeBox::aChosenSizeReplacesWhatWasTyped() {
    ImageSizeBox box({.view = {765, 818}});
    auto* sizes = box.findChild<QComboBox*>();
    sizes->setCurrentIndex(sizes->count() - 1);
    QVERIFY(box.chosenSize() == QSize(765, 818));
    side(box, "Width")->setValue(33);
    sizes->setCurrentIndex(3);
    QVERIFY(box.chosenSize() == QSize(3840, 2160));
    sizes->setCurrentIndex(0);
    QVERIFY(!box.chosenSize());
}

void TestImageSizeBox::noSideIsAbsurdlyLong() {
    ImageSizeBox box({.view = {765, 818}});
    QCOMPARE(side(box, "Width")->maximum(), 8192);
    QCOMPARE(side(box, "Height")->minimum(), 1);
}

void TestImageSizeBox::eachFieldHasANameAndItsUnit() {
    ImageSizeBox box({.view = {765, 818}});
    QVERIFY(side(box, "Width")->toolTip().contains("[pixels]"));
    QVERIFY(!box.findChild<QComboBox*>()->accessibleName().isEmpty());
}

/// Four times as many pixels take four times as long, and so does half the error.
void TestImageSizeBox::itSaysHowLongItTakes() {
    ImageSizeBox box({.view = {1000, 1000}, .cost = ImageCost{64 * 600e-6}});
    const auto said = [&] {
        QStringList texts;
        for (const QLabel* label : box.findChildren<QLabel*>())
            texts << label->text();
        return texts.join('\n');
    };
    QVERIFY(!said().contains(QString::fromUtf8("to ±")));
    box.findChild<QComboBox*>()->setCurrentIndex(1);
    QVERIFY2(said().contains(QString::fromUtf8("about 10 min to ±8")), qPrintable(said()));
    box.findChild<QComboBox*>()->setCurrentIndex(2);
    QVERIFY2(said().contains(QString::fromUtf8("about 40 min to ±8")), qPrintable(said()));
    box.findChild<QDoubleSpinBox*>()->setValue(4);
    QVERIFY2(said().contains(QString::fromUtf8("about 2.7 h to ±4")), qPrintable(said()));
    ImageSizeBox unknown({.view = {1000, 1000}});
    unknown.findChild<QComboBox*>()->setCurrentIndex(1);
    QVERIFY(std::ranges::any_of(unknown.findChildren<QLabel*>(),
                                [](const QLabel* label) { return label->text().contains("not known yet"); }));
}

void TestImageSizeBox::whoItIsIsOfferedOnlyWhereThatIsKnown() {
    const auto offered = [](bool known) {
        const ImageSizeBox box({.view = {100, 100}, .patientKnown = known});
        return box.findChildren<QComboBox*>().back()->findText("Sides and patient") >= 0;
    };
    QVERIFY(offered(true) && !offered(false));
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestImageSizeBox)
#include "image_size_box_test.moc"
