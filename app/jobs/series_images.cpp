#include "app/jobs/series_images.h"

#include <algorithm>

#include "app/scan/scan_place.h"
#include "render/slice/grey_window.h"
#include "render/slice/unit_window.h"

namespace pdr::app {
namespace {

constexpr int kSide = 96;                  ///< [px]
constexpr GreyWindow kWindow{100.5, 801};  ///< for files that ask for none: lungs are black, bone is white
constexpr double kUnknownPixelMm = 1;      ///< square pixels, where a series without a grid states no spacing

/// Returns the pixels' size along x and y [mm].
dvec2 pixelMm(const dicom::Series& series, const dicom::SliceRef& slice) {
    if (series.verdict.loadable())
        return dvec2(series.geometry.spacingMm());
    return slice.identity.spacingMm.value_or(dvec2(kUnknownPixelMm));
}

/// Returns whether rows or columns that lead along `direction` lead to where radiologists see the beginning.
bool leadsBack(dvec3 direction) {
    const dvec3 seen = direction * dvec3(1, 1, -1);  // to the left, the back and the feet
    const dvec3 size = glm::abs(seen);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return seen[axis] < 0;
}

/// Returns the window that the files ask for; without one, of values that are no HU, from the darkest to the brightest.
GreyWindow windowFor(const dicom::Series& series, const dicom::DecodedSlice& slice) {
    if (series.window.window)
        return inVoxels(*series.window.window, series.unit);
    if (series.unit.isHu || slice.hu.empty())
        return kWindow;
    const auto [low, high] = std::ranges::minmax(slice.hu);
    return {(low + high) / 2.0, std::max(high - low, 1) + 0.0, VoiFunction::linearExact};
}

}  // namespace

QImage seriesImage(const dicom::Series& series, const std::stop_token& stop) {
    if (series.slices.empty())
        return {};
    const dicom::SliceRef& middle = series.slices[series.slices.size() / 2];
    const auto slice = decodeSliceOf(series, middle, stop);
    if (!slice)
        return {};
    const GreyWindow window = windowFor(series, *slice);
    QImage image(slice->size.x, slice->size.y, QImage::Format_Grayscale8);
    for (int y = 0; y < slice->size.y; ++y)
        std::transform(slice->hu.begin() + std::ptrdiff_t(y) * slice->size.x,
                       slice->hu.begin() + std::ptrdiff_t(y + 1) * slice->size.x, image.scanLine(y),
                       [&](std::int16_t hu) { return greyLevel(window, float(hu)); });
    if (const dmat4& map = series.geometry.patientFromIndex; series.verdict.loadable())
        image.mirror(leadsBack(dvec3(map[0])), leadsBack(dvec3(map[1])));
    const dvec2 mm = pixelMm(series, middle);
    const QSizeF shape(slice->size.x * mm.x, slice->size.y * mm.y);
    return image.scaled(shape.scaled(kSide, kSide, Qt::KeepAspectRatio).toSize().expandedTo({1, 1}),
                        Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

void SeriesImages::make(const dicom::ScanResult& scan, const std::vector<int>& order) {
    start([this, all = scan.series, order](const Progress&, const std::stop_token& stop) -> std::function<void()> {
        for (const int index : order) {
            if (stop.stop_requested())
                break;
            const QImage image = seriesImage(all[std::size_t(index)], stop);
            if (!image.isNull())
                QMetaObject::invokeMethod(this, [this, stop, index, image] {
                    if (!stop.stop_requested())
                        emit made(index, image);
                });
        }
        return [] {};
    });
}

}  // namespace pdr::app
