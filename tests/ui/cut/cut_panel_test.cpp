/// The cut in numbers: what is typed is what is cut, and setters are silent.

#include "ui/cut/cut_panel.h"

#include <QSignalSpy>
#include <QTest>

#include "ui/text/cut_text.h"

namespace pdr::ui {

static const Uncut kBody{{-100, -80, -120}, {100, 80, 120}};

/// A panel that receives its own choices back, as from the document.
struct LivePanel {
    LivePanel() {
        QObject::connect(&panel, &CutPanel::clipChosen, [this](const Clip& chosen) {
            ++count;
            clip = chosen;
            panel.setCuts(clip, kBody);
        });
        panel.setCuts(clip, kBody);
    }
    QDoubleSpinBox* side(int face) {
        for (auto* box : panel.findChildren<QDoubleSpinBox*>())
            if (box->accessibleName().endsWith(faceName(face)))
                return box;
        return nullptr;
    }
    QPushButton* button(const QString& text) {
        for (auto* one : panel.findChildren<QPushButton*>())
            if (one->text() == text)
                return one;
        return nullptr;
    }

    Clip clip;
    int count = 0;
    CutPanel panel;
};

class TestCutPanel : public QObject {
    Q_OBJECT

  private slots:
    void aTypedSideIsCutOffExactly() {
        LivePanel live;
        for (int face = 0; face < 6; ++face)
            live.side(face)->setValue(10.5 + face);
        for (int face = 0; face < 6; ++face)
            QCOMPARE(cutOffMm(live.clip, kBody, face), 10.5 + face);
        QCOMPARE(live.count, 6);
        live.side(0)->setValue(5000);
        QCOMPARE(live.side(0)->value(), 200 - 1 - 11.5);
        live.button("Remove all c&uts")->click();
        QVERIFY(live.clip.empty());
        QCOMPARE(live.side(3)->value(), 0.0);
        QVERIFY(!live.button("Remove all c&uts")->isEnabled());
    }

    void planesAreTypedFlippedAndRemoved() {
        LivePanel live;
        live.clip.planes = {{{0, 0, 0}, {0, -1, 0}}, {{0, 0, 10}, {0, 0, 1}}};
        live.panel.setCuts(live.clip, kBody);
        QCOMPARE(live.count, 0);
        auto rows = live.panel.findChildren<PlaneRow*>();
        QCOMPARE(rows.size(), 2);
        rows[0]->findChild<QDoubleSpinBox*>()->setValue(12.5);
        QCOMPARE(planeOffsetMm(live.clip.planes[0], kBody), 12.5);
        QCOMPARE(live.clip.planes[0].normal, dvec3(0, -1, 0));
        const auto buttons = rows[1]->findChildren<QToolButton*>();
        buttons[0]->click();
        QCOMPARE(live.clip.planes[1].normal, dvec3(0, 0, -1));
        QCOMPARE(live.clip.planes[1].pointMm.z, 10.0);
        rows[0]->findChildren<QToolButton*>()[1]->click();
        QCOMPARE(live.clip.planes.size(), std::size_t(1));
        QCOMPARE(live.clip.planes[0].normal, dvec3(0, 0, -1));
    }

    void moreThanEightPlanesAreNotOffered() {
        LivePanel live;
        QSignalSpy wanted(&live.panel, &CutPanel::planeWanted);
        live.button("Coronal")->click();
        QCOMPARE(wanted.front().front().toInt(), 1);
        live.clip.planes.assign(kMostPlanes, ClipPlane{});
        live.panel.setCuts(live.clip, kBody);
        QVERIFY(!live.button("Coronal")->isEnabled() && !live.button("Facing")->isEnabled());
    }

    void theLastLineIsRemoved() {
        LivePanel live;
        QToolButton* remove = nullptr;
        for (auto* button : live.panel.findChildren<QToolButton*>())
            if (button->accessibleName() == "Remove the last one")
                remove = button;
        QVERIFY(remove->isHidden());
        live.clip.freehand = {{{}, {{0, 0}, {1, 0}, {0, 1}}, true}, {{}, {{0, 0}, {1, 0}, {0, 1}}, false}};
        live.panel.setCuts(live.clip, kBody);
        QVERIFY(!remove->isHidden());
        remove->click();
        QCOMPARE(live.clip.freehand.size(), std::size_t(1));
        QVERIFY(live.clip.freehand[0].keepInside);
    }

    void shadowsAreChosen() {
        LivePanel live;
        live.panel.findChild<QCheckBox*>()->click();
        QVERIFY(live.clip.shadows);
    }

    void planesHaveNames() {
        QCOMPARE(planeName({{}, {0, 0, -3}}), QString("Axial"));
        QCOMPARE(planeName({{}, {1, -0.9, 0}}), QString("Sagittal, tilted by 42°"));
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestCutPanel)
#include "cut_panel_test.moc"
