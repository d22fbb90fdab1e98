/// The rendering panel: what it shows, what it emits, and what it keeps folded away.

#include <QSignalSpy>
#include <QTest>

#include "ui/rendering/render_panel.h"

namespace pdr::ui {

/// Returns the control with that accessible name.
template <class Control>
Control* named(const QWidget& panel, const char* name) {
    for (Control* control : panel.findChildren<Control*>())
        if (control->accessibleName() == name)
            return control;
    qFatal("there is no control %s", name);
}

/// Chooses an entry as a user does: by the keyboard, so that Qt treats it as a choice.
static void choose(QComboBox* box, int index) {
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < index; ++i)
        QTest::keyClick(box, Qt::Key_Down);
}

class TestRenderPanel : public QObject {
    Q_OBJECT

  private slots:
    void choosingADeviceAsksForItsName();
    void thePaceIsEmittedWhole();
    void onlyWhatCountsCanBeChanged();
    void theComparisonIsFoldedAway();
    void comparisonsAreExplained();
    void comparisonsAreEmitted();
    void settersAreSilent();
    void numbersOutOfRangeStayAtTheEnds();
};

void TestRenderPanel::choosingADeviceAsksForItsName() {
    RenderPanel panel;
    panel.show();
    panel.setDevices({"cpu", "cuda", "cuda:1"}, {"CPU (2 threads)", "a GPU", "another GPU"});
    QSignalSpy chosen(&panel, &RenderPanel::deviceChosen);
    choose(named<QComboBox>(panel, "Device"), 2);
    QCOMPARE(chosen.last().first().toString(), "cuda:1");
    QCOMPARE(named<QComboBox>(panel, "Device")->currentText(), "another GPU");
}

void TestRenderPanel::thePaceIsEmittedWhole() {
    RenderPanel panel;
    QList<FrameBudget> chosen;
    connect(&panel, &RenderPanel::paceChosen, [&](const FrameBudget& pace) { chosen << pace; });
    QVERIFY((panel.pace() == FrameBudget{true, 1, 10}));
    named<QDoubleSpinBox>(panel, "Frame rate")->setValue(25);
    named<QCheckBox>(panel, "Automatic")->click();
    named<QSpinBox>(panel, "Iterations per frame")->setValue(100);
    QCOMPARE(chosen.size(), 3);
    QVERIFY((chosen[0] == FrameBudget{true, 1, 25}));
    QVERIFY((chosen[1] == FrameBudget{false, 1, 25}));
    QVERIFY((chosen[2] == FrameBudget{false, 100, 25}));
}

void TestRenderPanel::onlyWhatCountsCanBeChanged() {
    RenderPanel panel;
    const auto* rate = named<QDoubleSpinBox>(panel, "Frame rate");
    const auto* iterations = named<QSpinBox>(panel, "Iterations per frame");
    const auto* filter = named<QCheckBox>(panel, "Blur each iteration");
    QVERIFY(rate->isEnabled() && !iterations->isEnabled() && !filter->isEnabled());
    panel.setPace({false, 5, 10});
    panel.setSchedule({.kind = Schedule::Kind::kroes});
    QVERIFY(!rate->isEnabled() && iterations->isEnabled() && filter->isEnabled());
}

void TestRenderPanel::theComparisonIsFoldedAway() {
    RenderPanel panel;
    panel.show();
    const auto* schedule = named<QComboBox>(panel, "Schedule");
    QVERIFY(!schedule->isVisible());
    auto* expert = named<QToolButton>(panel, "Comparison with Exposure Render");
    expert->click();
    QVERIFY(schedule->isVisible());
    expert->click();
    QVERIFY(!schedule->isVisible());
}

void TestRenderPanel::comparisonsAreExplained() {
    RenderPanel panel;
    for (const QWidget* control :
         std::initializer_list<QWidget*>{named<QComboBox>(panel, "Schedule"), named<QComboBox>(panel, "Estimator"),
                                         named<QCheckBox>(panel, "Blur each iteration")}) {
        QVERIFY(control->toolTip().contains("For comparison only"));
    }
}

void TestRenderPanel::comparisonsAreEmitted() {
    RenderPanel panel;
    QList<Schedule> schedules;
    connect(&panel, &RenderPanel::scheduleChosen, [&](const Schedule& choice) { schedules << choice; });
    QList<Estimator> estimators;
    connect(&panel, &RenderPanel::estimatorChosen, [&](Estimator estimator) { estimators << estimator; });
    named<QComboBox>(panel, "Schedule")->setCurrentIndex(1);
    named<QComboBox>(panel, "Schedule")->setCurrentIndex(2);
    named<QCheckBox>(panel, "Blur each iteration")->click();
    named<QComboBox>(panel, "Estimator")->setCurrentIndex(1);
    QCOMPARE(schedules.size(), 3);
    QVERIFY((schedules[0] == Schedule{.kind = Schedule::Kind::kroes, .redundant = true}));
    QVERIFY((schedules[1] == Schedule{.kind = Schedule::Kind::kroes}));
    QVERIFY((schedules[2] == Schedule{.kind = Schedule::Kind::kroes, .filter = false}));
    QVERIFY(estimators == QList<Estimator>{Estimator::kroesMarch});
}

void TestRenderPanel::settersAreSilent() {
    RenderPanel panel;
    QSignalSpy device(&panel, &RenderPanel::deviceChosen), pace(&panel, &RenderPanel::paceChosen);
    QSignalSpy schedule(&panel, &RenderPanel::scheduleChosen), estimator(&panel, &RenderPanel::estimatorChosen);
    panel.setDevices({"cpu", "cuda"}, {"CPU", "a GPU"});
    panel.setDevice("cuda");
    panel.setPace({false, 77, 0.5});
    const Schedule k0{.kind = Schedule::Kind::kroes, .redundant = true, .filter = false};
    panel.setSchedule(k0);
    panel.setEstimator(Estimator::kroesMarch);
    QCOMPARE(named<QComboBox>(panel, "Device")->currentData().toString(), "cuda");
    QVERIFY((panel.pace() == FrameBudget{false, 77, 0.5}));
    QVERIFY(panel.schedule() == k0);
    QCOMPARE(named<QComboBox>(panel, "Estimator")->currentIndex(), 1);
    QCOMPARE(device.count() + pace.count() + schedule.count() + estimator.count(), 0);
}

void TestRenderPanel::numbersOutOfRangeStayAtTheEnds() {
    RenderPanel panel;
    panel.setPace({true, 0, 1e9});
    QVERIFY((panel.pace() == FrameBudget{true, 1, 60}));
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestRenderPanel)
#include "render_panel_test.moc"
