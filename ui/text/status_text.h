#pragma once
/// What is said of a picture besides its accuracy: what it is made by, and whatever makes it another one than it seems.

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

#include "render/film/error/smoothing_judgement.h"
#include "render/film/film_status.h"
#include "render/scene/model.h"
#include "render/scene/schedule.h"

namespace pdr::ui {

/// "0.96 × 0.96 × 1.5 mm": what lies between the voxels of the scan.
QString gridText(dvec3 spacingMm);

/// "153 × 164 pixels stretched to 765 × 818"; nothing where a picture has the view's pixels.
QString stretchedText(ivec2 picture, QSize view);

/// What stands beside a denoised image: "denoised: 95 % of the tissue within ±7, thin structures may be further off",
/// and "fine detail below 38 % contrast is not shown yet"; or that the error is not known yet; and how many
/// `lostLines` it lacks, which the error map marks.
QStringList smoothedTexts(const std::optional<SmoothedError>& error, std::size_t lostLines);

/// What stands beside a picture with a box, whose status is `box`: "in the box 95 % of the tissue within ±4", of what
/// is shown, as that of the whole `picture`; or, where it is `first` and gets all samples, what of the whole picture is
/// true meanwhile.
QString boxText(const FilmStatus& box, bool first, const FilmStatus& picture);

/// "at least 11 % of the tissue not seen yet": no number is said of that; nothing below 1 %.
QString unseenText(const FilmStatus& status);

/// A device to choose: "CPU (2 threads)".
QString deviceText(const QString& name, const QString& details);

/// What the picture is made by.
struct Making {
    QString device;  ///< its name: "cpu"
    std::uint32_t iterations = 0;
    double efficiency = 0;  ///< (0, 1]; 0 = not known
    std::uint64_t samples = 0;
    double iterationsPerSecond = 0;
};

/// Why a picture is one to compare with, and not this program's own: "comparison: Exposure Render's schedule, blurred".
/// Empty: it is its own.
QString comparisonText(const Schedule& schedule, Estimator estimator);

/// "No sample was left out", or how many were and what else went wrong with samples, a line each. Nothing without any.
QString healthText(const FilmStatus& status);

/// "256 samples, 31 iterations/s, 10 iterations per frame on the CPU, efficiency 99 %"
QString makingText(const Making& making);

}  // namespace pdr::ui
