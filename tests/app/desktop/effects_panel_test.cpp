/// The effects' costs in the window: measured while the panel is open, and one step to leave out what nobody would see.

#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <algorithm>

#include "app/presenters/effect_cost_rows.h"
#include "app/presenters/effects_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/the.h"
#include "tests/support/desktop/told_document.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/scenes/scenes.h"
#include "ui/accuracy/effect_costs.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// Returns a cost table of the document's scene: the effects in `nothing` change nothing, all others change much.
static EffectCosts effectCostsOf(const Document& document, const QStringList& nothing) {
    EffectCosts effectCosts;
    effectCosts.complete = true;
    effectCosts.film = {96, 70};
    for (Effect& effect : needs(document.scene())) {
        TriedEffect row{std::move(effect), std::nullopt};
        if (row.canBeTried())
            row.trial = EffectTrial{};
        if (row.trial && !nothing.contains(QString::fromStdString(row.effect.name)))
            row.trial->change = {{9, 8, 10}, {30, 29, 31}};
        effectCosts.effects.push_back(std::move(row));
    }
    return effectCosts;
}

class TestEffectsPanel : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void whatNobodySeesIsLeftOutInOneStepThatCanBeUndone();
    void whatIsSeenStays();
    void whatIsKnownOfTheViewBeforeDecidesNothing();
    void everyEffectThatASetupSaysCanBeLeftOut();
    void theTableSaysWhatIsMeasuredAndWhatIsOff();
    void nothingIsMeasuredWhileThePanelIsClosed();

  private:
    QTemporaryDir folder_;
    QString series_;
};

void TestEffectsPanel::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

void TestEffectsPanel::whatNobodySeesIsLeftOutInOneStepThatCanBeUndone() {
    Told told;
    const LeanSetup lean = leanSetup(told.document, effectCostsOf(told.document, {"light from all around"}));
    QCOMPARE(lean.leftOut.size(), 1);
    QVERIFY(lean.leftOut[0].startsWith("light from all around (the image changes by 0.00 levels"));
    told.document.setSetup(lean.setup);
    QCOMPARE(told.scenes.size(), std::size_t(2));
    QVERIFY(told.scenes[1].environment.isBlack() && !told.scenes[0].environment.isBlack());
    QVERIFY(told.scenes[1].lights == told.scenes[0].lights);
    QVERIFY(told.document.setup().lookChanged);
    told.document.undo();
    QCOMPARE(told.document.look(), 0);
    Scene back = told.scenes.back();
    back.revision = told.scenes[0].revision;
    QVERIFY(back == told.scenes[0] && !told.document.canUndo());
}

/// No setup is without shadows.
void TestEffectsPanel::whatIsSeenStays() {
    Told told;
    QVERIFY(leanSetup(told.document, effectCostsOf(told.document, {})).leftOut.isEmpty());
    const LeanSetup lean = leanSetup(told.document, effectCostsOf(told.document, {"shadows"}));
    QVERIFY(lean.leftOut.isEmpty() && lean.setup == told.document.setup());
    told.document.setSetup(lean.setup);
    QVERIFY(!told.document.canUndo());
}

void TestEffectsPanel::whatIsKnownOfTheViewBeforeDecidesNothing() {
    Told told;
    EffectCosts effectCosts = effectCostsOf(told.document, {"light from all around"});
    for (TriedEffect& row : effectCosts.effects)
        row.ofViewBefore = true;
    QVERIFY(leanSetup(told.document, effectCosts).leftOut.isEmpty());
}

void TestEffectsPanel::everyEffectThatASetupSaysCanBeLeftOut() {
    Told told;
    told.document.open(test::bumpyVolume({6, 6, 6}, dvec3(10), 1));
    ImageSetup setup = told.document.setup();
    setup.model = Model::multipleScattering;
    setup.look.phaseG = 0.5f;
    setup.look.gradientFactor = 5;
    setup.look.transferFunction.nodes = {{.hu = 0, .opacity = 1, .emission = vec3(0.1f), .specular = vec3(0.2f)}};
    setup.look.environment = {vec3(0.1f), true};
    setup.camera.apertureMm = 1;
    setup.clip.planes = {{.pointMm = {30, 30, 30}, .normal = {1, 0, 0}}};
    told.document.setSetup(setup);
    QStringList names;
    for (const Effect& effect : needs(told.document.scene()))
        if (effect.needed && effect.leaveOut != nullptr)
            names << QString::fromStdString(effect.name);
    names.removeAll("shadows");
    QVERIFY(names.size() >= 10);
    for (const QString& name : names) {
        const LeanSetup lean = leanSetup(told.document, effectCostsOf(told.document, {name}));
        QVERIFY2(lean.leftOut.size() == 1, qPrintable(name));
        const Scene scene = sceneOf(lean.setup, told.document.scene().volume, {4, 4});
        QVERIFY2(std::ranges::none_of(needs(scene),
                                      [&](const Effect& effect) {
                                          return effect.needed && QString::fromStdString(effect.name) == name;
                                      }),
                 qPrintable(name));
    }
    QCOMPARE(leanSetup(told.document, effectCostsOf(told.document, names)).leftOut.size(), names.size());
}

void TestEffectsPanel::theTableSaysWhatIsMeasuredAndWhatIsOff() {
    Told told;
    EffectCosts effectCosts = effectCostsOf(told.document, {"shadows"});
    effectCosts.effects[0].trial->share = {0.36, 0.38, 0.4};
    const ui::EffectRows rows = effectRows(effectCosts, {"a phrase"});
    QCOMPARE(rows.needed[0].name, "shadows");
    QCOMPARE(rows.needed[0].share, "38 % (36 to 40)");
    QCOMPARE(rows.needed[0].meanLevels, "0");
    QVERIFY(rows.complete && rows.leftOut.size() == 1);
    QVERIFY(rows.off.contains("depth of field: the aperture is 0"));
    QVERIFY2(rows.how.contains(QString::fromUtf8("96 × 70 pixels")), qPrintable(rows.how));
    effectCosts.complete = false;
    effectCosts.effects[0].trial.reset();
    QCOMPARE(effectRows(effectCosts, {}).needed[0].milliseconds, QString::fromUtf8("…"));
    effectCosts.effects[1].ofViewBefore = true;
    QVERIFY(effectRows(effectCosts, {}).how.contains("previous view"));
    QVERIFY(effectRows({}, {}).needed.isEmpty() && effectRows({}, {}).how.isEmpty());
}

void TestEffectsPanel::nothingIsMeasuredWhileThePanelIsClosed() {
    Trial trial;
    ui::MainWindow& window = trial.desktop.window();
    EffectsWatch& watch = trial.desktop.presenter<EffectsPresenter>().watch();
    int changes = 0;
    connect(&watch, &EffectsWatch::changed, [&] { ++changes; });
    trial.openAndWait(series_);
    trial.desktop.document().setViewSize({24, 16});
    trial.waitForNewest();
    QVERIFY(!test::the<ui::EffectCosts>(window).isVisible());
    QCOMPARE(changes, 0);
    QTest::keyClick(&window.viewport(), Qt::Key_Space);  // while rendering holds, measuring has all the time
    QTest::keyClick(&window, Qt::Key_F6);
    QTRY_VERIFY_WITH_TIMEOUT(watch.table() && watch.table()->complete, test::kPatience);
    QVERIFY(test::the<ui::EffectCosts>(window).isVisible());
    const auto says = [&](const QString& words) {
        const auto labels = test::the<ui::EffectCosts>(window).findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](QLabel* label) { return label->text().contains(words); });
    };
    QVERIFY(says("shadows") && says("Measured on an image of"));
    QTest::keyClick(&window, Qt::Key_F6);
    QTRY_VERIFY_WITH_TIMEOUT(!watch.table(), test::kPatience);
    changes = 0;
    trial.desktop.document().setView(StandardView::left);
    trial.waitForNewest();
    QTest::qWait(100);
    QVERIFY(changes == 0 && !watch.table());
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestEffectsPanel)
#include "effects_panel_test.moc"
