#include "app/presenters/image_presenter.h"

#include "app/presenters/annotating.h"
#include "app/presenters/image_text.h"
#include "ui/text/accuracy_text.h"
#include "ui/text/status_text.h"
#include "ui/view/error_colours.h"

namespace pdr::app {
namespace {

/// Returns an image that refers to `bytes` and keeps the frame alive that holds them.
QImage imageOf(const std::shared_ptr<const Frame>& frame, const std::vector<std::uint8_t>& bytes, ivec2 size,
               QImage::Format format) {
    auto* kept = new std::shared_ptr<const Frame>(frame);
    const auto release = [](void* pointer) { delete static_cast<std::shared_ptr<const Frame>*>(pointer); };
    const qsizetype stride = qsizetype(bytes.size()) / size.y;
    return QImage(bytes.data(), size.x, size.y, stride, format, release, kept);
}

/// Returns the error map in colours; null if the frame has none.
QImage errorMapOf(const std::shared_ptr<const Frame>& frame) {
    if (!frame->errorMap)
        return {};
    QImage map = imageOf(frame, frame->errorMap->bins, frame->errorMap->size, QImage::Format_Indexed8);
    map.setColorTable(ui::errorColours());
    return map;
}

/// Returns the lines that denoising has removed from the image; the film itself has them.
QList<QLineF> lostLinesOf(const Frame& frame) {
    QList<QLineF> lines;
    if (!frame.denoised)
        return lines;
    for (const denoise::LostLine& line : frame.lostLines)
        lines << QLineF(double(line.begin.x), double(line.begin.y), double(line.end.x), double(line.end.y));
    return lines;
}

/// Replaces the pixel's error by the level of its colour in the error map of the image that is shown.
LevelErrorsAt asMapped(LevelErrorsAt errors, const LevelErrorMap& map, QPointF place) {
    const ivec2 pixel =
        glm::clamp(ivec2(int(place.x() * map.size.x), int(place.y() * map.size.y)), ivec2(0), map.size - 1);
    const std::uint8_t bin = map.bins[std::size_t(pixel.y) * std::size_t(map.size.x) + std::size_t(pixel.x)];
    if (bin >= kFirstBin && bin <= kLastBin)
        errors.here = float(levelsOfBin(bin));
    return errors;
}

}  // namespace

ImagePresenter::ImagePresenter(const Workspace& workspace) : Presenter(workspace) {
    connect(window().menuActions().errorMap, &QAction::triggered, &bridge(), &RenderBridge::setErrorMap);
    connect(&window().viewport(), &ui::Viewport::rested, &bridge(), &RenderBridge::askErrorAt);
    connect(&bridge(), &RenderBridge::errorFound, this, &ImagePresenter::showErrorAt);
}

void ImagePresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series))
        window().menuActions().errorMap->setEnabled(document().hasVolume());
}

void ImagePresenter::showFrame(const std::shared_ptr<const Frame>& frame) {
    window().viewport().setImage({imageOf(frame, frame->rgba, frame->size, QImage::Format_RGBX8888), frame->camera,
                                  annotationsOf(workspace(), *frame).texts.join('\n'), denoisedTexts(*frame).join('\n'),
                                  lostLinesOf(*frame), ui::previewText(shownOf(*frame), frame->stop.levels),
                                  errorMapOf(frame), shownOf(*frame).of == ErrorOf::beforeDenoising});
}

void ImagePresenter::clearImage() {
    window().viewport().clearImage();
}

void ImagePresenter::showErrorAt(QPointF place, const LevelErrorsAt& errors) {
    const auto& frame = bridge().lastFrame();
    if (!frame)
        return;
    const ErrorOf of = shownOf(*frame).of;
    if (frame->errorMap)
        return window().viewport().showTip(place, ui::hereText(asMapped(errors, *frame->errorMap, place), of));
    window().viewport().showTip(place, ui::hereText(errors, of == ErrorOf::denoised ? ErrorOf::beforeDenoising : of));
}

}  // namespace pdr::app
