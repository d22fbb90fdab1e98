#pragma once
/// The desktop in a test: with settings of its own, and the frames that it has shown.

#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <vector>

#include "app/desktop.h"
#include "app/presets.h"
#include "tests/support/processor_time.h"

namespace pdr::app {

struct Trial {
    explicit Trial(std::unique_ptr<Device> device = makeCpuDevice(1))
        : desktop(*bundledPresets(), std::move(device), folder.filePath("settings.ini"), 1) {
        QObject::connect(&desktop.parts().bridge, &RenderBridge::frameReady,
                         [this](const std::shared_ptr<const Frame>& frame) { frames.push_back(frame); });
        desktop.window().resize(900, 500);
        desktop.window().show();
    }

    void openAndWait(const QString& series) {
        desktop.open(series);
        QTRY_VERIFY_WITH_TIMEOUT(!frames.empty() && !frames.back()->coarse, 240000);
    }

    /// Waits for a full picture of the document's newest scene.
    void waitForNewest() {
        const Document& document = desktop.parts().document;
        QTRY_VERIFY_WITH_TIMEOUT(frames.back()->revision == document.scene().revision && !frames.back()->coarse, 240000);
    }

    /// After a pause: until the launch that was on its way has been shown, and nobody computes any more.
    void waitUntilStill() {
        for (double spent = 1; spent > 0.02;) {
            const test::ProcessorTime time;
            QTest::qWait(500);
            spent = time.seconds();
        }
    }

    QTemporaryDir folder;
    Desktop desktop;
    std::vector<std::shared_ptr<const Frame>> frames;
};

}  // namespace pdr::app
