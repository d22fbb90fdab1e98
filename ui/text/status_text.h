#pragma once
/// Texts on an image besides its accuracy: how it was rendered, and everything that makes it differ from a regular
/// image.

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

#include "render/film/error/smoothing_judgement.h"
#include "render/film/film_status.h"
#include "render/scene/model.h"
#include "render/scene/schedule.h"

namespace pdr::ui {

/// Returns the voxel spacing of the scan, as statedSpacingMm() gives it: "Voxel size 0.96 × 0.96 × 1.5 mm".
QString gridText(dvec3 spacingMm);

/// Returns "153 × 164 pixels stretched to 765 × 818"; empty if the image has as many pixels as the view.
QString stretchedText(ivec2 image, QSize view);

/// Returns what stands on a denoised image: "Denoised, error ±7", or that the error is not known yet; and how many thin
/// `lostLines` it lacks, which the error map marks.
QStringList denoisedTexts(const std::optional<DenoisedError>& error, std::size_t lostLines);

/// Returns what a denoised image may lack beyond its error: "thin structures may be further off", and "detail below 38
/// % contrast may be missing".
QStringList hiddenDetailTexts(const DenoisedError& error);

/// Returns the remark on an image with a box, whose status is `box`: "in the region ±4 (95 % of the tissue)", for the
/// image shown, as `image` is for the whole image. If the box is `first` and gets all samples, the status of the
/// whole image meanwhile.
QString boxText(const FilmStatus& box, bool first, const FilmStatus& image);

/// Returns "at least 11 % of the tissue not sampled yet": the error has no estimate for it. Empty below 1 %.
QString unseenText(const FilmStatus& status);

/// Returns a device to choose: "CPU (2 threads)".
QString deviceText(const QString& name, const QString& details);

/// How an image was rendered.
struct Making {
    QString device;  ///< its name: "cpu"
    std::uint32_t iterations = 0;
    double efficiency = 0;  ///< (0, 1]; 0 = not known
    std::uint64_t samples = 0;
    double iterationsPerSecond = 0;
};

/// Returns why an image is for comparison only and not a regular one: "comparison: Exposure Render's schedule,
/// blurred". Empty: it is a regular one.
QString comparisonText(const Schedule& schedule, Estimator estimator);

/// Returns "No sample was left out", or how many were, and what else went wrong with samples, one per line. Empty
/// without samples.
QString healthText(const FilmStatus& status);

/// Returns "256 samples, 31 iterations/s, 10 iterations per frame on the CPU, efficiency 99 %".
QString makingText(const Making& making);

}  // namespace pdr::ui
