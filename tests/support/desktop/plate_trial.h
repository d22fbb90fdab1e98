#pragma once
/// The desktop with a plate that is made from a formula, for tests that measure it: what is clicked and dragged on its
/// axial slice, and what the window then knows.

#include <cmath>

#include "app/presenters/marks_presenter.h"
#include "app/presenters/slices_presenter.h"
#include "dicom/write/export.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/mouse.h"
#include "tests/support/scenes/scenes.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// The HU of a plate of 20 mm across x, 1000 in 40, whose edges are blurred by 1 mm as a scanner would.
inline int plateHu(double x) {
    return int(std::lround(40 + 480 * (std::erf((x + 10) / std::sqrt(2.0)) - std::erf((x - 10) / std::sqrt(2.0)))));
}

class PlateTrial {
  protected:
    /// Opens the plate, and waits until an axial slice of it is shown.
    void begin() {
        series_ = folder_.filePath("series");
        const auto plate =
            test::makeVolume({80, 64, 24}, dvec3(1, 1, 2), [](int i, int, int) { return plateHu(i - 39.5); });
        const dicom::ExportFacts facts{"Phantom^Plate", "PLATE", "Test", "Plate", "Made from a formula."};
        const auto written = dicom::writeSeries(*plate, facts, ui::fromQt(series_), noProgress);
        QVERIFY2(written, written ? "" : written.error().text().c_str());
        trial_ = std::make_unique<Trial>();
        trial_->desktop.window().resize(1300, 800);
        open();
        centre_ = document().seen()->geometry().centreMm();
        trial_->desktop.presenter<SlicesPresenter>().showSlices();
        showAxialAt(document().plan().navigation.crosshairMm);
    }

    /// Opens the plate, and waits until the image shows it.
    void open() {
        trial_->frames.clear();
        trial_->desktop.open(series_);
        QTRY_VERIFY_WITH_TIMEOUT(!trial_->frames.empty(), test::kPatience);
    }
    /// Waits until the image shows the document's newest scene, if only coarsely.
    void waitForImage() {
        QTRY_VERIFY_WITH_TIMEOUT(trial_->frames.back()->revision == document().scene().revision, test::kPatience);
    }

    ui::MainWindow& window() { return trial_->desktop.window(); }
    Document& document() { return trial_->desktop.document(); }
    const std::vector<Measurement>& measurements() { return document().plan().measurements; }
    MarksPresenter& presenter() { return trial_->desktop.presenter<MarksPresenter>(); }
    ui::MarksPanel& panel() { return presenter().panel(); }
    ui::SliceView& view(AnatomicalPlane plane) { return trial_->desktop.presenter<SlicesPresenter>().view(plane); }
    ui::SliceView& axial() { return view(AnatomicalPlane::axial); }
    ui::Viewport& viewport() { return window().viewport(); }
    QTreeWidget& list() { return *panel().findChild<QTreeWidget*>(); }
    QString shown(int row, int column) { return list().topLevelItem(row)->text(column); }
    const std::vector<ui::ShownMark>& marks() { return presenter().inImage().marks(); }

    /// Presses a key that begins to measure.
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&window(), key, modifiers); }
    /// Returns where `placeMm` is seen on a slice [px].
    static QPoint pointOn(ui::SliceView& slice, dvec3 placeMm) {
        const dvec2 pixel = (slice.slice()->plane.pixelAt(placeMm) + 0.5) / slice.devicePixelRatioF();
        return QPointF(pixel.x, pixel.y).toPoint();
    }
    /// Clicks on the axial slice where `placeMm` is seen.
    void click(dvec3 placeMm, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(&axial(), Qt::LeftButton, modifiers, pointOn(axial(), placeMm));
    }
    /// Drags on the axial slice.
    void drag(dvec3 fromMm, dvec3 toMm) {
        QTest::mousePress(&axial(), Qt::LeftButton, {}, pointOn(axial(), fromMm));
        for (const double share : {0.5, 1.0})
            test::dragOn(axial(), pointOn(axial(), glm::mix(fromMm, toMm, share)));
        QTest::mouseRelease(&axial(), Qt::LeftButton, {}, pointOn(axial(), toMm));
    }
    /// Moves the crosshair, and waits for the axial slice there, in the size of its view.
    void showAxialAt(dvec3 placeMm) {
        document().moveCrosshair(placeMm);
        const auto isShown = [&] {
            const auto& slice = axial().slice();
            return slice && slice->plane.size == axial().sizeInPixels() &&
                   std::abs(slice->plane.depthMm(placeMm)) < 0.1;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isShown(), test::kPatience);
    }

    QTemporaryDir folder_;
    QString series_;
    std::unique_ptr<Trial> trial_;
    dvec3 centre_{0};
};

}  // namespace pdr::app
