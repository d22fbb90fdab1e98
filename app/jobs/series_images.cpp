#include "app/jobs/series_images.h"

#include <algorithm>
#include <utility>

#include "dicom/read/pixels.h"

namespace pdr::app {
namespace {

constexpr int kSide = 96;                      ///< [px]
constexpr int kDarkHu = -300, kWhiteHu = 500;  ///< range of the greys [HU]: lungs are black, bone is white

int grey(std::int16_t hu) {
    return std::clamp((int(hu) - kDarkHu) * 255 / (kWhiteHu - kDarkHu), 0, 255);
}

}  // namespace

QImage seriesImage(const dicom::Series& series) {
    if (series.slices.empty())
        return {};
    const dicom::SliceRef& middle = series.slices[series.slices.size() / 2];
    const auto slice = dicom::decodeSlice(*series.source, middle, dicom::Padding::maskAsAir);
    if (!slice)
        return {};
    QImage image(slice->size.x, slice->size.y, QImage::Format_Grayscale8);
    for (int y = 0; y < slice->size.y; ++y)
        std::transform(slice->hu.begin() + std::ptrdiff_t(y) * slice->size.x,
                       slice->hu.begin() + std::ptrdiff_t(y + 1) * slice->size.x, image.scanLine(y),
                       [](std::int16_t hu) { return uchar(grey(hu)); });
    const dvec3 mm = series.geometry.spacingMm();
    const QSizeF shape(slice->size.x * mm.x, slice->size.y * mm.y);
    return image.scaled(shape.scaled(kSide, kSide, Qt::KeepAspectRatio).toSize().expandedTo({1, 1}),
                        Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

void SeriesImages::make(const dicom::ScanResult& scan) {
    start([this, all = scan.series](const Progress&, const std::stop_token& stop) -> std::function<void()> {
        std::vector<std::pair<int, QImage>> images;
        for (std::size_t i = 0; i < all.size() && !stop.stop_requested(); ++i)
            if (all[i].verdict.loadable())
                if (const QImage picture = seriesImage(all[i]); !picture.isNull())
                    images.emplace_back(int(i), picture);
        return [this, images] {
            for (const auto& [series, picture] : images)
                emit made(series, picture);
        };
    });
}

}  // namespace pdr::app
