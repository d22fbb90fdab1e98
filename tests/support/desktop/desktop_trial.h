#pragma once
/// The desktop in a test, with settings of its own and a record of the frames that it has shown.

#include <QImage>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <vector>

#include "app/desktop/desktop.h"
#include "app/looks/looks.h"
#include "app/presenters/saving_presenter.h"
#include "tests/support/patience.h"

namespace pdr::app {

/// Returns the looks that scans open with, and the last one, Skin. A small image of each look is rendered for every
/// scan that is opened, and for eighteen looks they take as long as the image itself.
inline std::vector<NamedLook> fewLooks() {
    std::vector<NamedLook> looks = *bundledLooks();
    looks.erase(looks.begin() + 3, looks.end() - 1);
    return looks;
}

struct Trial {
    explicit Trial(std::unique_ptr<Device> device = makeCpuDevice(1), std::vector<NamedLook> looks = fewLooks())
        : desktop(std::move(looks), std::move(device), folder.filePath("settings.ini"), 1) {
        QObject::connect(&desktop.bridge(), &RenderBridge::frameReady,
                         [this](const std::shared_ptr<const Frame>& frame) { frames.push_back(frame); });
        desktop.bridge().setTarget(kFinestStep);  // keeps rendering as long as a test runs
        desktop.window().resize(kWindowSize);
        desktop.window().show();
    }

    static constexpr QSize kWindowSize{700, 420};  ///< small, since each pixel is rendered

    /// Opens a series and waits for a full image of it, with the mask that its look wants, since a mask begins an image
    /// of its own. Frames of the one before may still arrive meanwhile.
    void openAndWait(const QString& series) {
        const Document& document = desktop.document();
        const std::uint64_t before = document.scene().revision;
        desktop.open(series);
        QTRY_VERIFY_WITH_TIMEOUT(document.hasVolume() && document.scene().revision > before, test::kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(document.setup().look.visible.all() || document.scene().mask, test::kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!frames.empty(), test::kPatience);
        waitForNewest();
    }

    /// Waits for a full image of the document's newest scene.
    void waitForNewest() {
        const Document& document = desktop.document();
        QTRY_VERIFY_WITH_TIMEOUT(frames.back()->revision == document.scene().revision && !frames.back()->coarse,
                                 test::kPatience);
    }

    /// Returns all texts of the status bar with their tool tips; empty if it shows nothing about an image.
    QString said() {
        QStringList words;
        for (const QLabel* label : desktop.window().accuracyStatus().findChildren<QLabel*>())
            if (!label->isHidden() && !label->text().isEmpty())
                words << label->text() << label->toolTip();
        return words.join('\n');
    }

    /// Returns the samples per pixel of the film after a pause, once they are on the screen. A film is saved between
    /// two launches, so that no samples are in flight.
    std::uint64_t heldSamples() {
        const QString file = folder.filePath("held.png");
        QSignalSpy saved(&desktop.presenter<SavingPresenter>().saver(), &ImageSaver::saved);
        desktop.presenter<SavingPresenter>().saver().save(file);
        const auto held = [&] {
            return saved.isEmpty() ? 0 : QImage(file).text("pdrender/samplesPerPixel").toULongLong();
        };
        [&] {
            QTRY_VERIFY_WITH_TIMEOUT(!saved.isEmpty(), test::kPatience);
            QTRY_COMPARE_WITH_TIMEOUT(frames.back()->status.samplesPerPixel, held(), test::kPatience);
        }();
        return held();
    }

    QTemporaryDir folder;
    Desktop desktop;
    std::vector<std::shared_ptr<const Frame>> frames;
};

}  // namespace pdr::app
