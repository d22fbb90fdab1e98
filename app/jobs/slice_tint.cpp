#include "app/jobs/slice_tint.h"

#include "render/slice/label_slice.h"

namespace pdr::app {

void tint(const SliceTint& tint, const SlicePlane& plane, QImage& image) {
    constexpr int kOfColour = 90;  // of 256 parts
    if (!tint.map)
        return;
    const auto mixed = [](int grey, int colour) { return grey + (colour - grey) * kOfColour / 256; };
    const std::vector<std::uint8_t> labels = labelsOnPlane(*tint.map, plane);
    const std::uint8_t* label = labels.data();
    for (int y = 0; y < image.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x, ++label)
            if (*label != 0)
                if (const auto& colour = tint.colours[*label - 1u])
                    row[x] = qRgb(mixed(qRed(row[x]), (*colour)[0]), mixed(qGreen(row[x]), (*colour)[1]),
                                  mixed(qBlue(row[x]), (*colour)[2]));
    }
}

}  // namespace pdr::app
