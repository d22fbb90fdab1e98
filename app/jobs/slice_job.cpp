#include "app/jobs/slice_job.h"

#include <utility>

namespace pdr::app {
namespace {

/// Colour of what lies outside the scan: clearly no tissue, which is grey.
constexpr Ground kOutside{24, 28, 38};

QImage greyImage(const SliceImage& slice, const GreyWindow& window) {
    const std::vector<std::uint8_t> pixels = greyPixels(window, slice.hu, kOutside);
    return QImage(pixels.data(), slice.plane.size.x, slice.plane.size.y, QImage::Format_RGBX8888).copy();
}

}  // namespace

SliceJob::SliceJob() {
    connect(
        this, &BackgroundJob::finished, this,
        [this] {
            if (std::exchange(waits_, false))
                begin(*newest_);
        },
        Qt::QueuedConnection);  // after the signal with the result
    connect(this, &BackgroundJob::failed, this, [this] {
        if (!waits_)
            newest_.reset();
    });
}

void SliceJob::make(Request request) {
    if (request == newest_)
        return;
    newest_ = std::move(request);
    waits_ = waits_ || isRunning();
    if (!waits_)
        begin(*newest_);
}

void SliceJob::drop() {
    newest_.reset();
    waits_ = false;
    cancel();
}

void SliceJob::begin(Request request) {
    start([this, request = std::move(request)](const Progress&, const std::stop_token& stop) -> std::function<void()> {
        const auto slice = reslice(*request.volume, request.plane, {}, stop);
        if (!slice)
            return [] {};
        return [this, grey = greyImage(*slice, request.window), plane = slice->plane, window = request.window] {
            emit made(grey, plane, window);
        };
    });
}

}  // namespace pdr::app
