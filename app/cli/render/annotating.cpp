#include "app/cli/render/annotating.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <string_view>

#include "render/scene/not_shown.h"
#include "render/smooth/non_local_means.h"
#include "ui/annotation/annotation_text.h"
#include "ui/text/series_text.h"

namespace pdr::app {

namespace {

/// Draws a letter, to detect a missing font: without one, all letters are the same box or nothing.
QImage picture(const QString& letter) {
    QImage image(32, 32, QImage::Format_Grayscale8);
    image.fill(Qt::black);
    QPainter painter(&image);
    QFont font;
    font.setPixelSize(20);
    painter.setFont(font);
    painter.setPen(Qt::white);
    painter.drawText(image.rect(), Qt::AlignCenter, letter);
    return image;
}

}  // namespace

bool mayWriteLetters(int argc, const char* const* argv) {
    const std::string_view command(argc < 2 ? "" : argv[1]);
    const bool images =
        command == "render" || command == "merge" || command == "slice" ||
        (command == "plan" && std::find(argv + 2, argv + argc, std::string_view("--render")) != argv + argc);
    if (!images)
        return false;
    for (int i = 2; i < argc; ++i) {
        const std::string_view argument(argv[i]);
        if (argument == "--annotations=none" ||
            (argument == "none" && argv[i - 1] == std::string_view("--annotations")))
            return false;
    }
    return true;
}

Result<void> checkFonts(ui::Annotate wanted) {
    if (wanted == ui::Annotate::none || picture("R") != picture("L"))
        return {};
    return Error{"this machine has no font to write the patient's sides with", "--annotations",
                 "Install one (fonts-dejavu-core), or add --annotations none."};
}

Error noPatientKnown() {
    return {"a raw file knows no patient", "--annotations", "Say sides instead of patient."};
}

Result<std::optional<ui::Annotations>> annotationsOf(const LoadedScene& loaded, ui::Annotate wanted) {
    if (wanted == ui::Annotate::none)
        return std::optional<ui::Annotations>();
    if (wanted == ui::Annotate::patient && !loaded.series)
        return noPatientKnown();
    const Scene& scene = loaded.scene;
    const QString hidden = QString::fromStdString(notShown(scene));
    const QStringList texts = ui::annotationTexts({QString::fromStdString(scene.lookName), scene.maskAwaited, hidden,
                                                   scene.clip, loaded.uncut, isCtDenoised(*scene.volume)});
    const QStringList patient = wanted == ui::Annotate::patient ? ui::patientLines(*loaded.series) : QStringList();
    return std::optional(ui::Annotations{scene.camera, patient, texts});
}

}  // namespace pdr::app
