#pragma once
/// The desktop in a test: with settings of its own, and the frames that it has shown.

#include <QImage>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <vector>

#include "app/desktop/desktop.h"
#include "app/looks/looks.h"
#include "tests/support/patience.h"

namespace pdr::app {

struct Trial {
    explicit Trial(std::unique_ptr<Device> device = makeCpuDevice(1))
        : desktop(*bundledLooks(), std::move(device), folder.filePath("settings.ini"), 1) {
        QObject::connect(&desktop.parts().bridge, &RenderBridge::frameReady,
                         [this](const std::shared_ptr<const Frame>& frame) { frames.push_back(frame); });
        desktop.parts().bridge.setTarget(kFinestStep);  // goes on as long as a test looks
        desktop.window().resize(900, 500);
        desktop.window().show();
    }

    void openAndWait(const QString& series) {
        desktop.open(series);
        QTRY_VERIFY_WITH_TIMEOUT(!frames.empty() && !frames.back()->coarse, test::kPatience);
    }

    /// Waits for a full picture of the document's newest scene.
    void waitForNewest() {
        const Document& document = desktop.parts().document;
        QTRY_VERIFY_WITH_TIMEOUT(frames.back()->revision == document.scene().revision && !frames.back()->coarse,
                                 test::kPatience);
    }

    /// All that the foot of the window says, tool tips included; empty where it says nothing of a picture.
    QString said() {
        QStringList words;
        for (const QLabel* label : desktop.window().foot().findChildren<QLabel*>())
            if (!label->isHidden() && !label->text().isEmpty())
                words << label->text() << label->toolTip();
        return words.join('\n');
    }

    /// After a pause: the samples that the film holds, once they are on the screen. A film is saved between two
    /// launches, so none is on its way any more.
    std::uint64_t heldSamples() {
        const QString file = folder.filePath("held.png");
        QSignalSpy saved(&desktop.parts().bridge, &RenderBridge::saved);
        desktop.parts().bridge.save(file);
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
