#include "app/jobs/slice_job.h"

#include <bit>
#include <utility>

#include "render/slice/halved_plane.h"

namespace pdr::app {
namespace {

/// Hatches the pixels of what has not arrived: nothing that a scan shows looks like that.
void hatch(const SliceImage& slice, QImage& image) {
    constexpr QRgb kLine = 0xff3a4256, kGround = 0xff181c26;
    constexpr int kPeriod = 12, kWidth = 2;
    for (int y = 0; y < image.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x)
            if (slice.at({x, y}) == kNotArrived)
                row[x] = (x + y) % kPeriod < kWidth ? kLine : kGround;
    }
}

/// Returns the pixels in the format that the window's thread paints without conversion.
QImage greyImage(const SliceImage& slice, const GreyWindow& window) {
    // What lies outside the scan is clearly no tissue, which is grey. In memory, blue comes first in this format.
    constexpr std::uint8_t kRed = 24, kGreen = 28, kBlue = 38;
    static_assert(std::endian::native == std::endian::little);
    QImage image(slice.plane.size.x, slice.plane.size.y, QImage::Format_RGB32);
    paintGrey(window, slice.hu, {kBlue, kGreen, kRed}, {image.bits(), std::size_t(image.sizeInBytes())});
    return image;
}

/// Returns the plane whose pixels are computed.
SlicePlane planeOf(const SliceJob::Request& request) {
    return request.coarse ? halved(request.plane) : request.plane;
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

/// Returns whether the newest request has the same slice as its answer, or a better one.
bool SliceJob::isAnswered(const Request& request) const {
    Request inFull = request;
    inFull.coarse = false;
    return newest_ == request || newest_ == inFull;
}

void SliceJob::make(Request request) {
    if (isAnswered(request))
        return;
    newest_ = std::move(request);
    waits_ = waits_ || isRunning();
    if (!waits_)
        begin(*newest_);
}

QImage SliceJob::madeNow(const Request& request) {
    QImage image = greyImage(*reslice(request.scan, planeOf(request)), request.window);
    tint(request.tint, planeOf(request), image);
    return image;
}

void SliceJob::drop() {
    newest_.reset();
    waits_ = false;
    cancel();
}

void SliceJob::begin(Request request) {
    start([this, request = std::move(request), memory = memory_](const Progress&,
                                                                 const std::stop_token& stop) -> std::function<void()> {
        auto slice = reslice(request.scan, planeOf(request), stop, std::move(*memory));
        if (!slice)
            return [] {};
        QImage grey = greyImage(*slice, request.window);
        if (request.scan.arriving())
            hatch(*slice, grey);
        tint(request.tint, slice->plane, grey);
        *memory = std::move(slice->hu);
        return [this, grey, plane = request.plane, window = request.window] { emit made(grey, plane, window); };
    });
}

}  // namespace pdr::app
