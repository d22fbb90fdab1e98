#include "app/cli/accuracy/accuracy_plot.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace pdr::app {
namespace {

constexpr double kWidth = 760, kHeight = 420, kLeft = 60, kRight = 20, kTop = 16, kBottom = 46;

/// A logarithmic scale of whole decades or octaves.
class Scale {
  public:
    Scale(double low, double high, double from, double to) : low_(low), high_(high), from_(from), to_(to) {}
    double operator()(double value) const {
        const double share = std::log(std::clamp(value, low_, high_) / low_) / std::log(high_ / low_);
        return from_ + share * (to_ - from_);
    }
    double low() const { return low_; }
    double high() const { return high_; }

  private:
    double low_, high_, from_, to_;
};

Scale timeScale(const std::vector<AccuracyCurve>& curves) {
    double low = INFINITY, high = 0;
    for (const AccuracyCurve& curve : curves)
        for (const AccuracyStep& step : curve.steps)
            low = std::min(low, step.seconds), high = std::max(high, step.seconds);
    if (!(low < high))
        low = std::isfinite(low) ? low / 2 : 0.1, high = 10 * low;
    return {std::pow(10, std::floor(std::log10(low))), std::pow(10, std::ceil(std::log10(high))), kLeft,
            kWidth - kRight};
}

QString line(double x1, double y1, double x2, double y2, const char* style) {
    return QString("<line x1='%1' y1='%2' x2='%3' y2='%4' %5/>").arg(x1).arg(y1).arg(x2).arg(y2).arg(style);
}

QString label(double x, double y, const char* anchor, const QString& text) {
    return QString("<text x='%1' y='%2' text-anchor='%3'>%4</text>").arg(x).arg(y).arg(anchor, text);
}

QString axes(const Scale& time, const Scale& levels) {
    QString svg;
    for (double t = time.low(); t <= 1.001 * time.high(); t *= 10)
        svg += line(time(t), kTop, time(t), kHeight - kBottom, "stroke='#ddd'") +
               label(time(t), kHeight - kBottom + 16, "middle", QString("%1 s").arg(t));
    for (double l = levels.low(); l <= levels.high(); l *= 2)
        svg += line(kLeft, levels(l), kWidth - kRight, levels(l), "stroke='#ddd'") +
               label(kLeft - 6, levels(l) + 4, "end", QString("±%1").arg(l));
    return svg + label((kLeft + kWidth - kRight) / 2, kHeight - 10, "middle", "time of rendering") +
           QString(
               "<text transform='translate(14 %1) rotate(-90)' text-anchor='middle'>95 % of the tissue within, of "
               "255 levels</text>")
               .arg((kTop + kHeight - kBottom) / 2);
}

QString ground(std::optional<double> floor, const Scale& levels) {
    if (!floor)
        return {};
    const double top = levels(*floor), bottom = kHeight - kBottom;
    return QString("<rect x='%1' y='%2' width='%3' height='%4' fill='#eee'/>")
               .arg(kLeft)
               .arg(top)
               .arg(kWidth - kLeft - kRight)
               .arg(bottom - top) +
           label(kLeft + 6, std::min(top + 14, bottom - 4), "start", "less than the reference's own error");
}

QString path(const QStringList& points, const char* colour, const char* style) {
    if (points.size() < 2)
        return {};
    return QString("<polyline points='%1' fill='none' stroke='%2' %3/>").arg(points.join(' '), colour, style);
}

QString curveDrawing(const AccuracyCurve& curve, const char* colour, const Scale& time, const Scale& levels) {
    QStringList measured, stated;
    QString dots;
    for (const AccuracyStep& step : curve.steps) {
        const double x = time(step.seconds), y = levels(step.error.levels);
        measured << QString("%1,%2").arg(x).arg(y);
        dots += QString("<circle cx='%1' cy='%2' r='2.5' fill='%3'/>").arg(x).arg(y).arg(colour);
        if (step.stated)
            stated << QString("%1,%2").arg(x).arg(levels(*step.stated));
    }
    return path(measured, colour, "stroke-width='2'") + path(stated, colour, "stroke-dasharray='5 4'") + dots;
}

/// Draws the names in the upper right corner, where falling curves leave room.
QString legend(const std::vector<AccuracyCurve>& curves) {
    QString svg;
    for (std::size_t i = 0; i < curves.size(); ++i)
        svg += QString("<text x='%1' y='%2' text-anchor='end' fill='%3'>%4</text>")
                   .arg(kWidth - kRight - 6)
                   .arg(kTop + 16 + 15 * double(i))
                   .arg(curveColour(i), QString::fromStdString(curves[i].name).toHtmlEscaped());
    return svg;
}

}  // namespace

const char* curveColour(std::size_t i) {
    constexpr const char* kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"};
    return kColours[i % std::size(kColours)];
}

QString accuracyPlot(const std::vector<AccuracyCurve>& curves, std::optional<double> floor) {
    const Scale time = timeScale(curves), levels(0.5, 256, kHeight - kBottom, kTop);
    QString svg = QString(
                      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %1 %2' width='%1' height='%2' "
                      "font-family='sans-serif' font-size='12'><rect width='%1' height='%2' fill='#fff'/>")
                      .arg(kWidth)
                      .arg(kHeight) +
                  ground(floor, levels) + axes(time, levels);
    if (!curves.empty() && !curves[0].steps.empty()) {
        const AccuracyStep& first = curves[0].steps.front();
        const double fall = std::sqrt(first.seconds / time.high());
        svg += line(time(first.seconds), levels(first.error.levels), time(time.high()),
                    levels(first.error.levels * fall), "stroke='#888' stroke-dasharray='1 4'");
    }
    for (std::size_t i = 0; i < curves.size(); ++i)
        svg += curveDrawing(curves[i], curveColour(i), time, levels);
    return svg + legend(curves) + "</svg>";
}

}  // namespace pdr::app
