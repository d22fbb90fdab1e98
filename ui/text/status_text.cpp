#include "ui/text/status_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "render/film/health_text.h"
#include "render/film/levels_text.h"
#include "ui/text/language.h"
#include "ui/text/room_text.h"

namespace pdr::ui {
namespace {

constexpr int kFaintestPercent = 5;  ///< contrast of fine lines that hardly anybody sees on a screen

QString translated(const char* text) {
    return QCoreApplication::translate("statusText", text);
}

/// Formats a number with two significant digits: 12, 1.8, 0.18.
QString shortNumber(double value) {
    if (value <= 0)
        return "0";
    const int decimals = std::clamp(1 - int(std::floor(std::log10(value))), 0, 6);
    return number(value, decimals);
}

/// Returns "1 sample", "123 456 samples" with thin spaces between the thousands.
QString samplesText(std::uint64_t count) {
    QLocale locale = QLocale::c();
    locale.setNumberOptions(QLocale::DefaultNumberOptions);  // the C locale leaves the separators out
    const QString counted = locale.toString(qulonglong(count)).replace(',', QChar(0x2009));
    return count == 1 ? translated("1 sample") : translated("%1 samples").arg(counted);
}

}  // namespace

QStringList denoisedTexts(const std::optional<DenoisedError>& error, std::size_t lostLines) {
    QStringList texts{error ? translated("Denoised, error ±%1").arg(localNumber(levelsText(error->levelsAtMost)))
                            : translated("Denoised, error not known yet")};
    if (lostLines >= denoise::kMostLostLines)
        texts << translated("%1 or more thin lines hidden by denoising: E shows where").arg(lostLines);
    else if (lostLines > 0)
        texts << translated(lostLines == 1 ? "%1 thin line hidden by denoising: E shows where"
                                           : "%1 thin lines hidden by denoising: E shows where")
                     .arg(lostLines);
    return texts;
}

QStringList hiddenDetailTexts(const DenoisedError& error) {
    QStringList texts{translated("thin structures may be further off")};
    const int hidden = int(std::ceil(100 * std::min(error.hiddenContrast, 1.0)));
    if (hidden >= 100)
        texts << translated("fine detail may be missing");
    else if (hidden >= kFaintestPercent)
        texts << translated("detail below %1 % contrast may be missing").arg(hidden);
    return texts;
}

QString gridText(dvec3 spacingMm) {
    return translated("Voxel size %1 × %2 × %3 mm")
        .arg(shortNumber(spacingMm.x), shortNumber(spacingMm.y), shortNumber(spacingMm.z));
}

QString stretchedText(ivec2 image, QSize view) {
    const double scale = double(view.height()) / image.y;
    if (std::abs(scale - 1) <= 0.02)  // shown pixel by pixel
        return {};
    return translated("%1 × %2 pixels stretched to %3 × %4")
        .arg(image.x)
        .arg(image.y)
        .arg(std::lround(image.x * scale))
        .arg(view.height());
}

QString boxText(const FilmStatus& box, bool first, const FilmStatus& image) {
    const auto levels = [](const FilmStatus& status) { return localNumber(levelsText(status.displayError)); };
    if (first && std::isfinite(image.displayError))
        return translated("whole image, waiting for the region: ±%1 (95 % of the tissue)").arg(levels(image));
    if (first)
        return translated("the rest of the image waits for the region");
    if (box.tissuePixels == 0)
        return translated("no tissue in the region");
    if (!std::isfinite(box.displayError))
        return translated("the region is still black");
    return translated("in the region ±%1 (95 % of the tissue)").arg(levels(box));
}

QString unseenText(const FilmStatus& status) {
    const int percent = int(std::lround(100 * status.unseenTissue));
    return percent < 1 ? QString() : translated("at least %1 % of the tissue not sampled yet").arg(percent);
}

QString comparisonText(const Schedule& schedule, Estimator estimator) {
    QStringList parts;
    if (schedule.kind != Schedule::Kind::pd) {
        parts << translated("Exposure Render's schedule %1").arg(schedule.redundant ? "K0" : "K1");
        if (schedule.filter)
            parts << translated("blurred");
    }
    if (estimator == Estimator::kroesMarch)
        parts << translated("march of 3 voxels") << translated("biased");
    return parts.isEmpty() ? QString() : translated("comparison: %1").arg(parts.join(", "));
}

QString deviceText(const QString& name, const QString& details) {
    const QString title = name == "cpu" ? translated("CPU") : name;
    return details.isEmpty() ? title : title + " (" + details + ')';
}

QString healthText(const FilmStatus& status) {
    if (status.samplesPerPixel == 0)
        return {};
    QStringList lines;
    for (const Text& line : healthLines(status.health))
        lines << inWords(line);
    return lines.isEmpty() ? translated("No sample was left out") : lines.join('\n');
}

QString makingText(const Making& making) {
    const QString device = making.device == "cpu" ? translated("the CPU") : making.device;
    const QString frames = making.iterations == 1
                               ? translated("1 iteration per frame on %1").arg(device)
                               : translated("%1 iterations per frame on %2").arg(making.iterations).arg(device);
    QString text = translated("%1, %2 iterations/s, %3")
                       .arg(samplesText(making.samples), shortNumber(making.iterationsPerSecond), frames);
    if (making.efficiency > 0)
        text += ", " + translated("efficiency %1 %").arg(std::floor(100 * making.efficiency));
    return text;
}

}  // namespace pdr::ui
