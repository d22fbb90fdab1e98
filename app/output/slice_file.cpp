#include "app/output/slice_file.h"

#include <sstream>
#include <vector>

#include "render/base/version.h"
#include "render/film/file/image_format.h"
#include "render/film/file/pixel_file.h"
#include "render/slice/unit_window.h"

namespace pdr::app {
namespace {

constexpr Ground kGround{38, 43, 52};  ///< where the volume does not reach: a blue that no tissue has

std::string text(dvec3 vector) {
    std::ostringstream out;
    out.precision(12);
    out << vector.x << ' ' << vector.y << ' ' << vector.z;
    return out.str();
}

std::vector<Fact> factsOf(const SliceImage& slice, const SliceFacts& facts) {
    const SlicePlane& plane = slice.plane;
    std::vector<Fact> all{{"pdrender/program", "PD-Render " PDR_VERSION},
                          {"pdrender/slice", facts.plane},
                          {"pdrender/originMm", text(plane.originMm)},
                          {"pdrender/right", text(plane.right)},
                          {"pdrender/down", text(plane.down)},
                          {"pdrender/mmPerPixel", plane.mmPerPixel}};
    if (!facts.remarks.empty())
        all.push_back({"pdrender/remarks", facts.remarks});
    return all;
}

std::vector<float> valuesOf(const SliceImage& slice, const ValueUnit& unit) {
    std::vector<float> values;
    values.reserve(slice.hu.size());
    for (const float voxel : slice.hu)
        values.push_back(float(unit.valueOf(double(voxel))));
    return values;
}

}  // namespace

std::string windowText(const GreyWindow& window) {
    const char* function = window.function == VoiFunction::sigmoid       ? "SIGMOID "
                           : window.function == VoiFunction::linearExact ? "LINEAR_EXACT "
                                                                         : "";
    return function + numberOf(window.centre) + "/" + numberOf(window.width);
}

Result<void> writeSlice(const SliceImage& slice, const SliceFacts& about, const GreyWindow& window,
                        const PaintOver& paintOver, const std::filesystem::path& file) {
    std::vector<Fact> facts = factsOf(slice, about);
    const ivec2 size = slice.plane.size;
    const ValueUnit unit = unitIn(about.remarks);
    if (imageFormat(file) == ImageFormat::exr && unit.isHu)
        return writeExr(size,
                        {"HU", "Hounsfield units, trilinear, not filtered; not a number outside the scan.", slice.hu},
                        facts, file);
    if (imageFormat(file) == ImageFormat::exr)
        return writeExr(
            size,
            {"value",
             "Values of the scan, no Hounsfield units (unit: " + (unit.name.empty() ? "none stated" : unit.name) +
                 "), trilinear, not filtered; not a number outside the scan.",
             valuesOf(slice, unit)},
            facts, file);
    std::vector<std::uint8_t> rgba = greyPixels(window, slice.hu, kGround);
    if (paintOver)
        paintOver(size, rgba);
    facts.push_back({"pdrender/window", windowText(inValues(window, unit))});
    return writePng(size, rgba, facts, file);
}

}  // namespace pdr::app
