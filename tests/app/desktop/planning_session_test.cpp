/// An evening before an operation, from the folder to the saved image, with the hand alone: each gesture changes the
/// image, is one step, and undo leads back to the very bits of the first one.

#include <QDropEvent>
#include <QImage>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "app/presenters/saving_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/hand_on_window.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/dicom/shared_data.h"
#include "ui/cut/cut_tools.h"
#include "ui/light/light_panel.h"
#include "ui/looks/look_panel.h"
#include "ui/text/to_qt.h"
#include "ui/tissue/tissue_panel.h"

namespace pdr::app {

/// The user's part of the session.
struct Session : Trial {
    Session() { desktop.window().resize(1100, 700); }

    void drop(const QString& path) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &enter);
        QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &event);
    }
    void chooseAnotherLook() {
        for (auto* button : test::the<ui::LookPanel>(window).findChildren<QAbstractButton*>())
            if (button->accessibleName().startsWith("Look ") && !button->isChecked())
                return button->click();
        QFAIL("there is no other look");
    }
    void dragANode() {
        ui::CurveEditor& editor = test::the<ui::TissuePanel>(window).editor();
        editor.resize(400, 200);
        const CurvePoint point = editor.points()[editor.points().size() / 2];
        const QPoint place = editor.view().at(double(point.hu), double(point.value)).toPoint();
        drag(editor, place, place + QPoint(15, 30));
    }
    void shiftTheCurve() {
        const QPoint middle = window.viewport().rect().center();
        drag(window.viewport(), middle, middle + QPoint(window.viewport().height() / 8, 0), Qt::ControlModifier);
    }
    void turnALight() {
        ui::LightSphere& sphere = test::the<ui::LightPanel>(window).sphere();
        sphere.resize(180, 180);
        const QPoint lamp = sphere.handleOf(sphere.lamp().from).toPoint();
        drag(sphere, lamp, lamp + QPoint(40, 20));
    }
    void cutOffTheTop() {
        test::the<ui::CutTools>(window).showHandles();
        const auto handle = test::the<ui::CutTools>(window).layer().marks().placeOf({CutHandle::Kind::face, 5});
        QVERIFY(handle);
        drag(window.viewport(), handle->toPoint(), handle->toPoint() + QPoint(0, window.viewport().height() / 6));
        test::the<ui::CutTools>(window).hideHandles();
    }

    ui::MainWindow& window = desktop.window();
    Document& document = desktop.document();
};

class TestPlanningSession : public QObject {
    Q_OBJECT

  private slots:
    void fromTheFolderToTheSavedImage_data();
    void fromTheFolderToTheSavedImage();
};

void TestPlanningSession::fromTheFolderToTheSavedImage_data() {
    QTest::addColumn<bool>("real");
    QTest::newRow("a made-up head") << false;
    if (std::filesystem::is_directory(test::sharedCt()))
        QTest::newRow("a chest with contrast, on its table") << true;
}

void TestPlanningSession::fromTheFolderToTheSavedImage() {
    QFETCH(bool, real);
    Session session;
    const QString made = session.folder.filePath("series");
    if (!real)
        QVERIFY(writePhantomSeries(ui::fromQt(made)));
    session.drop(real ? ui::toQt(test::sharedCt() / "chest_contrast") : made);
    QTRY_VERIFY_WITH_TIMEOUT(!session.frames.empty() && !session.frames.back()->coarse, test::kPatience);
    Document& document = session.document;
    QCOMPARE(document.hasTable(), real);
    QVERIFY(document.setup().table == Table::hidden);
    QVERIFY(!document.canUndo());

    ImageSetup first = document.setup();
    const Film image = rendered(document);
    const std::initializer_list<void (Session::*)()> gestures{&Session::dragANode, &Session::chooseAnotherLook,
                                                              &Session::shiftTheCurve, &Session::turnALight,
                                                              &Session::cutOffTheTop};
    for (const auto gesture : gestures) {
        const ImageSetup before = document.setup();
        (session.*gesture)();
        QVERIFY(document.setup() != before);
        QVERIFY(document.scene().check());
        QVERIFY(document.undoText() != "Undo");
    }
    QTRY_VERIFY_WITH_TIMEOUT(session.frames.back()->revision == document.scene().revision, test::kPatience);
    QVERIFY(session.frames.back()->error.empty());
    QVERIFY(!test::sameBits(rendered(document), image));

    const QString file = session.folder.filePath("plan.png");
    QSignalSpy saved(&session.desktop.presenter<SavingPresenter>().job(), &ImageJob::saved);
    session.desktop.presenter<SavingPresenter>().render({file, QSize(1000, 1000), {.levels = 0.2, .samples = 1}});
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
    QCOMPARE(QImage(file).size(), QSize(1000, 1000));
    QVERIFY(!QImage(file).text("pdrender/cut").isEmpty());

    while (document.canUndo())
        document.undo();
    first.stops = document.setup().stops;  // which may have come with the small images meanwhile
    QVERIFY(document.setup() == first);
    QVERIFY(test::sameBits(rendered(document), image));
    QVERIFY(session.window.close());
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestPlanningSession)
#include "planning_session_test.moc"
#include "ui/tissue/tissue_panel.h"
