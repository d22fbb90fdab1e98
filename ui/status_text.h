#pragma once
/// How good the picture is by now, in one line of words.

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

#include "render/film/smoothing_judgement.h"
#include "ui/render_panel.h"

namespace pdr::ui {

/// Why rendering holds, if it does.
enum class Holding { no, paused, reached };

/// "95 % of the tissue within ±9 of 255 grey levels, 256 samples, 31 iterations/s, ±8 in about 19 s"; "estimating"
/// below kSamplesToEstimate samples; why the rendering holds stands in front. Nothing without samples.
QString statusText(const FilmStatus& status, double iterationsPerSecond, Holding holding);

/// "153 × 164 pixels stretched to 765 × 818"; nothing where a picture has the view's pixels.
QString stretchedText(ivec2 picture, QSize view);

/// What stands beside a smoothed picture: "smoothed: within ±5 levels, at most ±7", for 95 % of the tissue, and "fine
/// detail below 38 % contrast is not shown yet"; or that it is not known yet; and how many `lostLines` are marked in
/// it.
QStringList smoothedTexts(const std::optional<SmoothedError>& error, std::size_t lostLines);

/// A device to choose: "CPU (2 threads)".
QString deviceText(const QString& name, const QString& details);

/// What the picture is made by.
struct Making {
    QString device;  ///< its name: "cpu"
    std::uint32_t iterations = 0;
    double efficiency = 0;  ///< (0, 1]; 0 = not known
};

/// Why a picture is one to compare with, and not this program's own: "comparison: Exposure Render's schedule, blurred".
/// Empty: it is its own.
QString comparisonText(const Schedule& schedule, Estimator estimator);

/// "10 iterations per frame on the CPU, efficiency 99 %"
QString makingText(const Making& making);

}  // namespace pdr::ui
