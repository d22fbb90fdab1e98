/// A right click offers what can be done with the place under the pointer; a right drag still zooms, or windows.

#include <QClipboard>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>

#include "app/presenters/slices_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

class ContextMenusTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        const QString series = folder_.filePath("series");
        const Result<void> written = writePhantomSeries(ui::fromQt(series), "Head of a phantom");
        QVERIFY2(written, written ? "" : written.error().text().c_str());
        trial_ = std::make_unique<Trial>();
        trial_->openAndWait(series);
    }
    void cleanupTestCase() { trial_.reset(); }
    void cleanup() {
        while (QWidget* menu = QApplication::activePopupWidget())
            menu->close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

    void theImageSaysWhatLiesUnderThePointer() {
        const std::uint64_t revision = document().scene().revision;
        const QMenu& menu = imageMenu();
        const QAction* here = menu.findChild<QAction*>("placeHere");
        QVERIFY(here && !here->isEnabled() && menu.actions().first() == here);
        QTRY_VERIFY_WITH_TIMEOUT(here->text().contains(" HU at "), test::kPatience);
        QVERIFY2(here->text().contains(QRegularExpression("[LR] [0-9.]+ .*[AP] [0-9.]+ .*[HF] [0-9.]+ mm$")),
                 qPrintable(here->text()));
        for (const char* tool : {"distance", "angle", "copy", "save"})
            QVERIFY2(menu.actions().contains(window().findChild<QAction*>(tool)), tool);
        QCOMPARE(document().scene().revision, revision);
    }

    void theCrosshairIsSetThere() {
        const dvec3 before = crosshair();
        entry(imageMenu(), "Set the crosshair here").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(crosshair() != before, test::kPatience);
        QVERIFY(window().views().showsSlices());
    }

    void theCameraFocusesThere() {
        const Camera before = document().setup().camera;
        entry(imageMenu(), "Focus here").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(document().setup().camera != before, test::kPatience);
        document().undo();
    }

    void theTissueThereIsShown() {
        const TransferFunction before = document().setup().look.transferFunction;
        entry(imageMenu(), "Show this tissue").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(document().setup().look.transferFunction != before, test::kPatience);
        document().undo();
    }

    /// A hand that trembles during a click costs no sample.
    void aDragOpensNoMenuAndATremblingClickEditsNothing() {
        const Camera before = document().setup().camera;
        drag(window().viewport(), {2, -1});
        QVERIFY(window().findChild<QMenu*>("imageMenu"));
        QVERIFY(document().setup().camera == before);
        cleanup();
        drag(window().viewport(), {4, -60});
        QVERIFY(!window().findChild<QMenu*>("imageMenu"));
        QVERIFY(document().setup().camera != before);
        document().undo();
    }

    void aSliceOffersItsWindow() {
        showAxial();
        const GreyWindow before = document().plan().navigation.window;
        drag(axial(), {2, 2});
        QVERIFY(document().plan().navigation.window == before);
        const auto* menu = axial().findChild<QMenu*>("sliceMenu");
        QVERIFY(menu && menu->isVisible());
        const QMenu& windows = *entry(*menu, "Window of the slices").menu();
        entry(windows, "4  Bone").trigger();
        QCOMPARE(document().plan().navigation.window, (GreyWindow{400, 1000}));
        entry(windows, "0  Whole range").trigger();
        QVERIFY(document().plan().navigation.window.width > 100);
        cleanup();
        drag(axial(), {40, 0});
        QVERIFY(!axial().findChild<QMenu*>("sliceMenu"));
    }

    void aSliceIsFittedAndCopied() {
        showAxial();
        Navigation navigation = document().plan().navigation;
        navigation.framings[std::size_t(AnatomicalPlane::axial)] = {3, {10, 5}};
        document().navigate(navigation);
        drag(axial(), {});
        entry(*axial().findChild<QMenu*>("sliceMenu"), "Fit the slice to its view").trigger();
        QVERIFY(document().plan().navigation.framings[std::size_t(AnatomicalPlane::axial)] == SliceFraming());
        QGuiApplication::clipboard()->clear();
        entry(*axial().findChild<QMenu*>("sliceMenu"), "Copy slice").trigger();
        QCOMPARE(QGuiApplication::clipboard()->image().size(), axial().grab().toImage().size());
    }

    /// One key offers the windows, whose digits are those of the slices.
    void aKeyOffersTheWindows() {
        QTest::keyClick(&window(), Qt::Key_W);
        QWidget* menu = QApplication::activePopupWidget();
        QVERIFY(menu);
        QTest::keyClick(menu, Qt::Key_5);
        QCOMPARE(document().plan().navigation.window, (GreyWindow{-600, 1500}));
    }

    /// With the tool, the next click sets the crosshair, also where the image is alone.
    void theToolSetsTheCrosshairOnce() {
        window().views().setLayout(ViewLayout::image);
        const dvec3 before = crosshair();
        QAction& tool = *window().findChild<QAction*>("crosshair");
        tool.trigger();
        const QPoint place = window().viewport().rect().center() + QPoint(0, -20);
        QTest::mouseClick(&window().viewport(), Qt::LeftButton, {}, place);
        QVERIFY(!tool.isChecked());
        QTRY_VERIFY_WITH_TIMEOUT(crosshair() != before, test::kPatience);
        QVERIFY(window().views().showsSlices());
    }

    void withoutAScanThereIsNoPlace() {
        document().close();
        QVERIFY(!imageMenu().findChild<QAction*>("placeHere"));
        drag(axial(), {});
        QVERIFY(!axial().findChild<QMenu*>("sliceMenu"));
        QVERIFY(!window().findChild<QAction*>("crosshair")->isEnabled());
    }

  private:
    Document& document() { return trial_->desktop.document(); }
    ui::MainWindow& window() { return trial_->desktop.window(); }
    ui::SliceView& axial() { return trial_->desktop.presenter<SlicesPresenter>().view(AnatomicalPlane::axial); }
    dvec3 crosshair() { return document().plan().navigation.crosshairMm; }

    const QMenu& imageMenu() {
        QTest::mouseClick(&window().viewport(), Qt::RightButton, {}, window().viewport().rect().center());
        return *window().findChild<QMenu*>("imageMenu");
    }

    void showAxial() {
        trial_->desktop.presenter<SlicesPresenter>().showSlices();
        [&] { QTRY_VERIFY_WITH_TIMEOUT(axial().slice(), test::kPatience); }();
    }

    static QAction& entry(const QMenu& menu, const QString& text) {
        for (QAction* action : menu.actions())
            if (QString(action->text()).remove('&').startsWith(text))
                return *action;
        qFatal("no entry %s", qPrintable(text));
    }

    /// Presses the right button in the middle, moves by `way` and lets go.
    static void drag(QWidget& view, QPoint way) {
        const QPoint start = view.rect().center();
        QTest::mousePress(&view, Qt::RightButton, {}, start);
        QMouseEvent move(QEvent::MouseMove, start + way, view.mapToGlobal(start + way), Qt::NoButton, Qt::RightButton,
                         {});
        QCoreApplication::sendEvent(&view, &move);
        QTest::mouseRelease(&view, Qt::RightButton, {}, start + way);
    }

    QTemporaryDir folder_;
    std::unique_ptr<Trial> trial_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::ContextMenusTest)
#include "context_menus_test.moc"
