#include "ui/accuracy/error_axes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pdr::ui {
namespace {

constexpr double kCoarsest = 64, kMost = 256, kLeast = 0.25;
constexpr std::array kMoments{0.1, 1.0, 10.0, 60.0, 600.0, 3600.0, 36000.0, 360000.0};

}  // namespace

ErrorAxes::ErrorAxes(const QRectF& area, const std::vector<ErrorPoint>& points, double last)
    : area_(area),
      time_(points.empty() ? StripAxis::kSecond : points.front().seconds, last),
      coarsest_(kCoarsest),
      finest_(kFinestStep) {
    for (const ErrorPoint& point : points) {
        coarsest_ = std::max(coarsest_, std::exp2(std::ceil(std::log2(std::min(point.levels, kMost)))));
        finest_ = std::min(finest_, std::exp2(std::floor(std::log2(std::max(point.levels, kLeast)))));
    }
}

double ErrorAxes::yOf(double levels) const {
    const double place = std::log(levels / finest_) / std::log(coarsest_ / finest_);
    return area_.bottom() - std::clamp(place, 0.0, 1.0) * area_.height();
}

QLineF ErrorAxes::rootLine(const ErrorPoint& point) const {
    const auto secondsOf = [&](double levels) { return point.seconds * std::pow(point.levels / levels, 2); };
    const auto place = [&](double seconds) { return at(seconds, point.levels * std::sqrt(point.seconds / seconds)); };
    return {place(std::max(secondsOf(coarsest_), time_.first())), place(std::min(secondsOf(finest_), time_.last()))};
}

std::vector<double> ErrorAxes::moments() const {
    std::vector<double> inside;
    std::copy_if(kMoments.begin(), kMoments.end(), std::back_inserter(inside),
                 [&](double moment) { return moment >= time_.first() && moment <= time_.last(); });
    return inside;
}

std::vector<double> ErrorAxes::levels() const {
    std::vector<double> marks;
    for (double mark = finest_; mark <= coarsest_; mark *= 2)
        marks.push_back(mark);
    return marks;
}

}  // namespace pdr::ui
