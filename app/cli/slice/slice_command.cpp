#include "app/cli/slice/slice_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "app/cli/failed.h"
#include "app/cli/render/annotating.h"
#include "app/cli/run_command.h"
#include "app/cli/scan/scanned_volume.h"
#include "app/cli/slice/slice_options.h"
#include "app/output/image_files.h"
#include "app/output/slice_file.h"
#include "render/slice/reslice.h"
#include "render/slice/unit_window.h"
#include "ui/annotation/slice_camera.h"
#include "ui/text/series_text.h"

namespace pdr::app {
namespace {

/// A slice and its place in words: "axial slice 50, z = -111.5 mm".
struct ChosenSlice {
    SlicePlane plane;
    std::string place;
};

Error outOfRange(const char* option, std::string what) {
    return {std::move(what), option, "", ErrorKind::refused};
}

Result<ChosenSlice> chosenSlice(const SliceOptions& options, const VolumeGeometry& geometry) {
    const SliceStack stack(geometry, options.plane);
    const std::string name = planeName(options.plane);
    const char* axis = options.plane == AnatomicalPlane::axial     ? "z"
                       : options.plane == AnatomicalPlane::coronal ? "y"
                                                                   : "x";
    const auto placed = [&](const SlicePlane& plane, const std::string& which) {
        const std::string mm = fixedNumber(stack.positionMm(plane.originMm), 2) + " mm";
        const dvec3 across = glm::abs(stack.across());
        const bool alongAnAxis = std::max({across.x, across.y, across.z}) > 1 - 1e-9;
        return ChosenSlice{plane, name + which + ", " + (alongAnAxis ? axis + (" = " + mm) : mm + " along its normal")};
    };
    if (options.atMm) {
        const dvec2 range = stack.rangeMm();
        if (*options.atMm < range.x || *options.atMm > range.y)
            return outOfRange("--at", "must be from " + fixedNumber(range.x, 2) + " to " + fixedNumber(range.y, 2) +
                                          " mm: there the scan has " + name + " slices");
        return placed(stack.at(*options.atMm), " slice");
    }
    const std::uint64_t index = options.index.value_or(std::uint64_t(stack.count() / 2));
    if (index >= std::uint64_t(stack.count()))
        return outOfRange("--index", "must be from 0 to " + std::to_string(stack.count() - 1) + ": the scan has " +
                                         std::to_string(stack.count()) + " " + name + " slices");
    return placed(stack.slice(int(index)), " slice " + std::to_string(index));
}

/// Returns the window of voxels to look through. Errors: the file's own is asked for, and there is none; a preset is
/// asked for, and the values are no HU.
Result<GreyWindow> chosenWindow(const SliceOptions& options, const ScannedVolume& scanned) {
    if (options.hasPreset && !unitOf(*scanned.volume).isHu)
        return Error{"this window is one in HU, and the values of the scan are none", "--window",
                     "Give a centre and a width in values, or \"whole\".", ErrorKind::refused};
    if (const auto* window = std::get_if<GreyWindow>(&options.window))
        return inVoxels(*window, unitOf(*scanned.volume));
    const auto wanted = std::get<ScanWindow>(options.window);
    if (wanted == ScanWindow::whole)
        return wholeRange(*scanned.volume);
    const dicom::StatedWindow stated = scanned.series ? scanned.series->window : dicom::StatedWindow();
    if (stated.window)
        return inVoxels(*stated.window, unitOf(*scanned.volume));
    if (wanted == ScanWindow::file)
        return Error{stated.ignored.empty() ? Text("the files state no grey window") : stated.ignored, "--window",
                     "Give a centre and a width, such as 40/400.", ErrorKind::refused};
    if (!stated.ignored.empty())
        std::fprintf(stderr, "note: %s\n", stated.ignored.c_str());
    return firstWindow(*scanned.volume, {});
}

/// Returns what is painted over PNG files. Error: the patient's data is asked for, and there is none.
Result<PaintOver> painterOf(const SliceOptions& options, const ScannedVolume& scanned, const ChosenSlice& slice,
                            const GreyWindow& window) {
    if (options.annotate == ui::Annotate::none)
        return PaintOver();
    if (options.annotate == ui::Annotate::patient && !scanned.series)
        return noPatientKnown();
    const QStringList patient =
        options.annotate == ui::Annotate::patient ? ui::patientLines(*scanned.series) : QStringList();
    QString place = QString::fromStdString(slice.place);
    place[0] = place[0].toUpper();
    const ValueUnit unit = unitOf(*scanned.volume);
    const QString seen = QString::fromStdString("Window " + windowText(inValues(window, unit)) + " " + unitText(unit));
    const ui::Annotations annotations{ui::cameraFacing(slice.plane), patient, {place, seen}, false};
    return PaintOver([annotations](ivec2 size, std::vector<std::uint8_t>& rgba) { annotate(annotations, size, rgba); });
}

void report(const SliceImage& image, const ValueUnit& unit, const std::string& place, const Paths& files) {
    float lowest = INFINITY, highest = -INFINITY;
    for (const float hu : image.hu) {
        lowest = std::fmin(lowest, hu);  // leaves out what is not a number
        highest = std::fmax(highest, hu);
    }
    std::printf("%s: %d x %d pixels of %s mm, %.4g to %.4g %s\n", place.c_str(), image.plane.size.x, image.plane.size.y,
                numberOf(image.plane.mmPerPixel, 4).c_str(), unit.valueOf(double(lowest)),
                unit.valueOf(double(highest)), unitText(unit).c_str());
    for (const auto& file : files)
        std::printf("%s\n", file.c_str());
}

/// Returns whether every file is in its place.
Result<bool> sliceAll(const SliceOptions& options) {
    if (auto ok = checkWritable(options.outputs); !ok)
        return ok.error();
    if (auto ok = checkFonts(anyPng(options.outputs) ? options.annotate : ui::Annotate::none); !ok)
        return ok.error();
    const auto scanned = scannedVolume(options.path, options.seriesUid);
    if (!scanned)
        return scanned.error();
    if (auto ok = checkSpared(scanned->files, options.outputs); !ok)
        return ok.error();
    const auto slice = chosenSlice(options, scanned->volume->geometry());
    if (!slice)
        return slice.error();
    const auto window = chosenWindow(options, *scanned);
    if (!window)
        return window.error();
    const auto painter = painterOf(options, *scanned, *slice, *window);
    if (!painter)
        return painter.error();

    const SliceImage image = *reslice(*scanned->volume, slice->plane);
    const SliceFacts facts{planeName(options.plane), scanned->volume->remarks()};
    const WrittenFiles written = writeFiles(options.outputs, [&](const std::filesystem::path& file) {
        return writeSlice(image, facts, *window, *painter, file);
    });
    for (const Error& trouble : written.troubles)
        failed(trouble);
    report(image, unitOf(*scanned->volume), slice->place, written.files);
    return written.troubles.empty();
}

}  // namespace

int runSlice(const QStringList& arguments) {
    return runCommand("slice", sliceOptions(arguments), sliceHelp, [](const SliceOptions& options) {
        const auto written = sliceAll(options);
        return !written ? failed(written.error()) : *written ? 0 : 1;
    });
}

}  // namespace pdr::app
